//! What several unit tests use.

use nalgebra::DMatrix;

/// A matrix from its rows.
pub(crate) fn matrix<const COLUMNS: usize>(rows: &[[f64; COLUMNS]]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), COLUMNS, |i, j| rows[i][j])
}
