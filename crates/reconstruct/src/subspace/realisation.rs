//! A and C from the extended observability matrix, and the modes that it holds.

use nalgebra::DMatrix;
use num_complex::Complex;

use super::dense::least_squares;
use crate::ReconstructError;

/// A and C in units of the sensors' deviations, and how well they are determined.
#[derive(Clone, Debug)]
pub(super) struct Realisation {
    pub(super) a: DMatrix<f64>,
    pub(super) c: DMatrix<f64>,
    /// Condition number of the observability matrix without its last block row.
    pub(super) condition: f64,
    /// What the shift leaves unexplained, relative to the shifted matrix.
    pub(super) residual: f64,
}

/// Singular values below this fraction of the largest are rounding errors.
const RANK_TOLERANCE: f64 = 1e-14;

/// Shift invariance: the observability matrix without its first block row is the one without its last block row times A.
pub(super) fn realise(
    observability: &DMatrix<f64>,
    sensors: usize,
) -> Result<Realisation, ReconstructError> {
    let (rows, order) = observability.shape();
    let upper = observability.rows(0, rows - sensors).into_owned();
    let lower = observability.rows(sensors, rows - sensors).into_owned();
    let (a, values) = least_squares(&upper, &lower, RANK_TOLERANCE)?;
    let (largest, smallest) = (values[0], values[order - 1]);
    let residual = (&lower - upper * &a).norm() / lower.norm().max(f64::MIN_POSITIVE);
    let condition = if smallest > 0.0 { largest / smallest } else { f64::INFINITY };
    Ok(Realisation { a, c: observability.rows(0, sensors).into_owned(), condition, residual })
}

/// A right eigenvector of A for an eigenvalue, by two steps of inverse iteration; of a multiple eigenvalue one of its vectors.
pub(super) fn eigenvector(a: &DMatrix<f64>, value: Complex<f64>) -> Option<DMatrix<Complex<f64>>> {
    let n = a.nrows();
    // Off the eigenvalue by enough that the system can be solved, and by far less than eigenvalues differ.
    let offset = 1e-10 * (a.norm() + f64::MIN_POSITIVE);
    let shift = value + Complex::new(offset, 0.5 * offset);
    let shifted = DMatrix::from_fn(n, n, |i, k| {
        Complex::from(a[(i, k)]) - if i == k { shift } else { Complex::from(0.0) }
    });
    let decomposed = shifted.lu();
    // Unequal entries, so that no eigenvector is likely to be missed.
    let mut vector = DMatrix::from_fn(n, 1, |i, _| Complex::new(1.0, 1.0 / (2.0 + i as f64)));
    for _ in 0..2 {
        vector = decomposed.solve(&vector)?;
        let norm = vector.norm();
        if !(norm.is_finite() && norm > 0.0) {
            return None;
        }
        vector /= Complex::from(norm);
    }
    Some(vector)
}

#[cfg(test)]
mod tests;
