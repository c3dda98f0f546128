//! What the triangle says about the parameters: singular values, rank, minimum-norm solution, covariance.

use faer::MatRef;
use nalgebra::{DMatrix, DVector};

use crate::{FitError, triangle::Triangle};

/// Singular value decomposition of the triangle with its columns scaled to unit norm, cut at the numerical rank.
///
/// With R S = U W V', S diagonal with the inverse column norms, the solution of smallest scaled norm is
/// theta = S V W^-1 U' z over the singular values kept.
#[derive(Debug, Clone)]
pub(crate) struct Factor {
    /// S, the factor that scales each column to norm one; 1 for a zero column.
    scaling: DVector<f64>,
    /// Norms of the columns.
    pub(crate) norms: Vec<f64>,
    left: DMatrix<f64>,
    right: DMatrix<f64>,
    pub(crate) singular_values: Vec<f64>,
    pub(crate) rank: usize,
}

impl Factor {
    /// Decomposes the triangle. Singular values at or below `relative_tolerance` times the largest count as zero.
    pub(crate) fn new(triangle: &Triangle, relative_tolerance: f64) -> Result<Self, FitError> {
        let mut scaled = triangle.regressors();
        let size = scaled.ncols();
        let norms: Vec<f64> = scaled.column_iter().map(|column| column.norm()).collect();
        let inverse = |norm: &f64| if *norm > 0.0 { norm.recip() } else { 1.0 };
        let scaling = DVector::from_iterator(size, norms.iter().map(inverse));
        for (mut column, scale) in scaled.column_iter_mut().zip(&scaling) {
            column *= *scale;
        }
        let svd = MatRef::from_column_major_slice(scaled.as_slice(), size, size)
            .svd()
            .map_err(|_| FitError::Decomposition { size })?;
        let (u, v, s) = (svd.U(), svd.V(), svd.S().column_vector());
        let singular_values: Vec<f64> = s.iter().copied().collect();
        if singular_values.iter().any(|x| !x.is_finite()) {
            return Err(FitError::Decomposition { size });
        }
        let floor = relative_tolerance * singular_values.first().copied().unwrap_or(0.0);
        let rank = singular_values.iter().take_while(|x| **x > floor).count();
        Ok(Self {
            scaling,
            norms,
            left: DMatrix::from_fn(size, size, |i, j| u[(i, j)]),
            right: DMatrix::from_fn(size, size, |i, j| v[(i, j)]),
            singular_values,
            rank,
        })
    }

    /// The solution of smallest scaled norm for a projected right-hand side.
    pub(crate) fn solve(&self, right_hand_side: &DVector<f64>) -> DVector<f64> {
        let mut weights = self.left.tr_mul(right_hand_side);
        for (i, weight) in weights.iter_mut().enumerate() {
            *weight = if i < self.rank { *weight / self.singular_values[i] } else { 0.0 };
        }
        (&self.right * weights).component_mul(&self.scaling)
    }

    /// (Phi Phi')^+ with the regressors scaled to norm one.
    pub(crate) fn inverse(&self) -> DMatrix<f64> {
        let mut half = self.right.columns(0, self.rank).into_owned();
        for (mut column, value) in half.column_iter_mut().zip(&self.singular_values) {
            column /= *value;
        }
        &half * half.transpose()
    }

    /// Combinations of parameters that leave the prediction unchanged, one a column, orthonormal in scaled units.
    pub(crate) fn null_directions(&self) -> DMatrix<f64> {
        self.right.columns(self.rank, self.right.ncols() - self.rank).into_owned()
    }

    /// Ratio of the largest to the smallest singular value kept; 1 if none is.
    pub(crate) fn condition(&self) -> f64 {
        match self.rank {
            0 => 1.0,
            rank => self.singular_values[0] / self.singular_values[rank - 1],
        }
    }
}
