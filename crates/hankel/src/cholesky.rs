//! Cholesky's factor in doubled precision, with pivoting, and what it says about rank and condition.

use doubled::DoubleDouble;
use nalgebra::DMatrix;

mod factorisation;
mod null_space;
mod pivoting;
mod substitution;

/// `P' S G S P = L L'` of a Gram matrix G = X' X: S scales each column of X to a norm between one and two by a power of two, P puts
/// the column farthest from those before it next.
///
/// Squaring X doubles the digits that its condition number costs; the doubled precision of G and L pays for it. So L' is the triangle of a QR
/// factorisation of X S P to the digits of a double, as long as the condition number stays below the inverse root of [`Gram::rounding`](crate::Gram::rounding), about 1e14.
#[derive(Debug, Clone, PartialEq)]
pub struct Cholesky {
    /// Column-major with `stride` rows to a column, lower triangle, rows and columns in pivot order; columns from `found` on and what is above the diagonal
    /// mean nothing.
    high: Vec<f64>,
    low: Vec<f64>,
    /// p, rounded up so that a column is a whole number of vectors.
    stride: usize,
    /// `order[k]` is the column that became the k-th.
    order: Vec<usize>,
    /// Columns that stand above rounding.
    found: usize,
    /// Singular values of X with its columns scaled to norm one, descending, p of them.
    singular_values: Vec<f64>,
    rank: usize,
    /// The columns of X, in units of 2^exponents, have norms between one and two.
    exponents: Vec<i32>,
    /// Those norms.
    norms: Vec<f64>,
}

impl Cholesky {
    fn at(&self, row: usize, column: usize) -> DoubleDouble {
        let at = row + column * self.stride;
        // The parts are those of a normalised number, so that this changes nothing.
        DoubleDouble::sum(self.high[at], self.low[at])
    }

    /// Number of columns.
    #[must_use]
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Numerical rank.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Columns in the order in which they were taken; the first [`Cholesky::rank`] are independent.
    #[must_use]
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// The unit of a column.
    pub(crate) fn exponent(&self, column: usize) -> i32 {
        self.exponents[column]
    }

    /// R with `R' R = D G D` to the digits of a double, D scaling each column of X to norm one: as many rows as columns stand above
    /// rounding, columns in the order of the layout, so that it is a triangle but for their order.
    ///
    /// Its singular values are those of X D.
    #[must_use]
    pub fn triangle(&self) -> DMatrix<f64> {
        let mut triangle = DMatrix::zeros(self.found, self.size());
        for (position, column) in self.order.iter().enumerate() {
            let norm = self.norms[*column];
            for k in 0..self.found.min(position + 1) {
                if norm > 0.0 {
                    triangle[(k, *column)] = self.high[position + k * self.stride] / norm;
                }
            }
        }
        triangle
    }

    /// Singular values of X with its columns scaled to norm one, descending, one for each column.
    #[must_use]
    pub fn singular_values(&self) -> &[f64] {
        &self.singular_values
    }

    /// Ratio of the largest singular value to the smallest that counts as different from zero; 1 for rank 0.
    #[must_use]
    pub fn condition(&self) -> f64 {
        match self.rank {
            0 => 1.0,
            rank => self.singular_values[0] / self.singular_values[rank - 1],
        }
    }

    /// Norms of the columns of X, in the units of the record, as `factor * 2^exponent`.
    #[must_use]
    pub fn norms(&self) -> Vec<(f64, i32)> {
        self.norms.iter().copied().zip(self.exponents.iter().copied()).collect()
    }

    /// Norm of a solution in units in which every column has norm one.
    pub(crate) fn scaled_norm(&self, solution: &[f64]) -> f64 {
        let squares = solution.iter().zip(&self.norms).map(|(b, norm)| (b * norm).powi(2));
        squares.sum::<f64>().sqrt()
    }
}
