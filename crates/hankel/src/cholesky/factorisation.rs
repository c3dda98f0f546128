//! From a Gram matrix to its factor: scaling, factorisation, rank.

use doubled::{exponent, power_of_two};
use faer::MatRef;
use nalgebra::DMatrix;
use pulp::Arch;

use super::{
    Cholesky,
    pivoting::{Factorise, LANES},
};
use crate::{Gram, HankelError, sums::times};

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
        let stride = size.next_multiple_of(LANES);
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
        Arch::new().dispatch(Factorise { factor: &mut factor, level });
        factor.singular_values = singular_values(&factor.triangle())?;
        let largest = factor.singular_values.first().copied().unwrap_or(0.0);
        let floor = tolerance.unwrap_or(level) * largest;
        factor.rank = factor.singular_values.iter().take_while(|value| **value > floor).count();
        factor.rank = factor.rank.min(factor.found);
        Ok(factor)
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
