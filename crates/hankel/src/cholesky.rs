//! Cholesky's factorisation in doubled precision, with pivoting, and what it says about rank and condition.

use doubled::{DoubleDouble, exponent, power_of_two};
use faer::MatRef;
use nalgebra::DMatrix;
use pulp::Arch;

use crate::{Gram, HankelError, sums::times};

mod null_space;
mod pivoting;
mod substitution;

/// `P' S G S P = L L'` of a Gram matrix G = X' X: S scales each column of X to a norm between one and two by a power of two, P puts
/// the column farthest from those before it next.
///
/// Squaring X doubles the digits that its condition number costs; the doubled precision of G and L pays for it. So L' is the triangle of a QR
/// factorisation of X S P to the digits of a double, as long as the condition number stays below the inverse root of [`Gram::rounding`], about 1e14.
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

impl Gram {
    /// Factorises. Singular values of X, its columns scaled to norm one, at or below `tolerance` times the largest count as zero.
    ///
    /// `None` takes the root of p times [`Gram::rounding`], the smallest that the matrix can tell from zero: 1e-14 or so.
    ///
    /// # Errors
    ///
    /// [`HankelError::NotSquare`] for a cross product, [`HankelError::BadValue`] for a tolerance outside 0 .. 1,
    /// [`HankelError::Decomposition`].
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Layout, Options, gram};
    ///
    /// // A sine obeys x(k+2) = 2 cos(1) x(k+1) - x(k): two of any number of shifted copies are independent.
    /// let sine: Vec<f64> = (0..100).map(|k| f64::from(k).sin()).collect();
    /// let factor = gram(&Layout::block_hankel(1, 5)?, &[&sine], &Options::default())?.cholesky(None)?;
    /// assert_eq!(factor.rank(), 2);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn cholesky(&self, tolerance: Option<f64>) -> Result<Cholesky, HankelError> {
        self.square()?;
        if let Some(value) = tolerance
            && !(0.0..1.0).contains(&value)
        {
            let what = "the rank tolerance";
            return Err(HankelError::BadValue {
                what,
                value,
                needed: "at least 0 and less than 1",
            });
        }
        let size = self.shape().0;
        let level = (size as f64 * self.rounding()).sqrt();
        // Powers of two that bring the diagonal to 1 .. 4.
        let halves: Vec<i32> = (0..size)
            .map(|i| match self.at(i, i).value() {
                diagonal if diagonal > 0.0 => exponent(diagonal).div_euclid(2),
                _ => 0,
            })
            .collect();
        let value = |i: usize, j: usize| times(self.at(i, j), power_of_two(-halves[i] - halves[j]));
        let stride = size.next_multiple_of(pivoting::LANES);
        let mut high = vec![0.0; stride * size];
        let mut low = vec![0.0; stride * size];
        for j in 0..size {
            for i in j..size {
                let value = value(i, j);
                (high[i + j * stride], low[i + j * stride]) = (value.high(), value.low());
            }
        }
        let norms = (0..size).map(|i| high[i + i * stride].max(0.0).sqrt()).collect();
        let mut factor = Cholesky {
            high,
            low,
            stride,
            order: (0..size).collect(),
            found: 0,
            singular_values: Vec::new(),
            rank: 0,
            exponents: (0..size).map(|i| self.exponent(i) + halves[i]).collect(),
            norms,
        };
        Arch::new().dispatch(pivoting::Factorise { factor: &mut factor, level });
        factor.singular_values = singular_values(&factor.triangle())?;
        let largest = factor.singular_values.first().copied().unwrap_or(0.0);
        let floor = tolerance.unwrap_or(level) * largest;
        factor.rank = factor.singular_values.iter().take_while(|value| **value > floor).count();
        factor.rank = factor.rank.min(factor.found);
        Ok(factor)
    }
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

/// Descending, padded with zeros to one for each column.
fn singular_values(triangle: &DMatrix<f64>) -> Result<Vec<f64>, HankelError> {
    let (rows, columns) = triangle.shape();
    let mut values = if rows == 0 {
        Vec::new()
    } else {
        MatRef::from_column_major_slice(triangle.as_slice(), rows, columns)
            .singular_values()
            .map_err(|_| HankelError::Decomposition { rows, columns })?
    };
    values.sort_by(|a, b| b.total_cmp(a));
    values.resize(columns, 0.0);
    Ok(values)
}
