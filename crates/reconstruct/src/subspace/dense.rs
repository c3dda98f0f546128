//! Eigenvalues, singular values and least squares by faer, on nalgebra's matrices.

use faer::{MatRef, Side};
use nalgebra::DMatrix;

use crate::ReconstructError;

/// Eigenvalues in ascending order with orthonormal vectors, one a column.
#[derive(Clone, Debug)]
pub(super) struct Eigen {
    pub(super) values: Vec<f64>,
    pub(super) vectors: DMatrix<f64>,
}

fn view(matrix: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(matrix.as_slice(), matrix.nrows(), matrix.ncols())
}

fn failed(step: &'static str) -> ReconstructError {
    ReconstructError::Step { step, message: "the iteration did not converge".to_owned() }
}

/// All eigenvalues and vectors of a symmetric matrix, of which the lower triangle is read.
pub(super) fn eigen(matrix: &DMatrix<f64>) -> Result<Eigen, ReconstructError> {
    let n = matrix.nrows();
    let found = view(matrix)
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| failed("eigenvalues of a symmetric matrix"))?;
    let (u, s) = (found.U(), found.S());
    Ok(Eigen {
        values: (0..n).map(|i| s[i]).collect(),
        vectors: DMatrix::from_fn(n, n, |i, j| u[(i, j)]),
    })
}

/// The eigenvalues alone, in ascending order.
pub(super) fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<f64>, ReconstructError> {
    view(matrix)
        .self_adjoint_eigenvalues(Side::Lower)
        .map_err(|_| failed("eigenvalues of a symmetric matrix"))
}

/// Eigenvalues and vectors of `R' R` without forming it: squared singular values of R, which has at least as many rows as columns, and its
/// right singular vectors.
pub(super) fn eigen_of_square(factor: &DMatrix<f64>) -> Result<Eigen, ReconstructError> {
    let n = factor.ncols();
    let found = view(factor).thin_svd().map_err(|_| failed("singular values"))?;
    let (v, s) = (found.V(), found.S());
    Ok(Eigen {
        values: (0..n).rev().map(|i| s[i] * s[i]).collect(),
        vectors: DMatrix::from_fn(n, n, |i, j| v[(i, n - 1 - j)]),
    })
}

/// The least-squares solution of `A X = B` for a tall A, with the singular values of A in descending order.
///
/// Directions of A below `tolerance` times its largest singular value don't count: the solution of least norm is returned.
/// (nalgebra 0.35's own decomposition is off by 1e-12 for many matrices with singular values near 1, and by more for some.)
pub(super) fn least_squares(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    tolerance: f64,
) -> Result<(DMatrix<f64>, Vec<f64>), ReconstructError> {
    let (rows, columns) = a.shape();
    let found = view(a).thin_svd().map_err(|_| failed("singular values"))?;
    let (u, v, s) = (found.U(), found.V(), found.S());
    let values: Vec<f64> = (0..columns).map(|i| s[i]).collect();
    let floor = tolerance * values[0];
    let left = DMatrix::from_fn(rows, columns, |i, k| u[(i, k)]);
    let right = DMatrix::from_fn(columns, columns, |i, k| v[(i, k)]);
    let mut projected = left.tr_mul(b);
    for (mut row, value) in projected.row_iter_mut().zip(&values) {
        row *= if *value > floor { 1.0 / value } else { 0.0 };
    }
    Ok((right * projected, values))
}

#[cfg(test)]
mod tests;
