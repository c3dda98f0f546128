//! The decompositions behind this crate: faer on nalgebra's matrices.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::ComputeEigenvectors;
use faer::linalg::gevd::{gevd_real, gevd_scratch};
use faer::{Mat, MatRef, Par};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use crate::LtiError;

pub(crate) type CMatrix = DMatrix<Complex<f64>>;
pub(crate) type CVector = DVector<Complex<f64>>;

/// A = U diag(s) V^T with U and V square; s descending, of length min(rows, columns).
pub(crate) struct Svd {
    pub(crate) u: DMatrix<f64>,
    pub(crate) s: Vec<f64>,
    pub(crate) v: DMatrix<f64>,
}

pub(crate) fn svd(a: &DMatrix<f64>) -> Result<Svd, LtiError> {
    let (rows, columns) = a.shape();
    if rows == 0 || columns == 0 {
        return Ok(Svd {
            u: DMatrix::identity(rows, rows),
            s: Vec::new(),
            v: DMatrix::identity(columns, columns),
        });
    }
    let decomposition =
        MatRef::from_column_major_slice(a.as_slice(), rows, columns).svd().map_err(no_svd)?;
    let (u, v) = (decomposition.U(), decomposition.V());
    let s = decomposition.S();
    Ok(Svd {
        u: DMatrix::from_fn(rows, rows, |i, j| u[(i, j)]),
        s: (0..rows.min(columns)).map(|i| s[i]).collect(),
        v: DMatrix::from_fn(columns, columns, |i, j| v[(i, j)]),
    })
}

/// The singular values of a complex matrix, descending, with the left and right vectors of the one at `index`.
pub(crate) fn singular_triple(
    a: &CMatrix,
    index: usize,
) -> Result<(Vec<f64>, CVector, CVector), LtiError> {
    let (rows, columns) = a.shape();
    let decomposition =
        MatRef::from_column_major_slice(a.as_slice(), rows, columns).svd().map_err(no_svd)?;
    let (u, v) = (decomposition.U(), decomposition.V());
    let s = decomposition.S();
    Ok((
        (0..rows.min(columns)).map(|i| s[i].re).collect(),
        CVector::from_fn(rows, |i, _| u[(i, index)]),
        CVector::from_fn(columns, |i, _| v[(i, index)]),
    ))
}

fn no_svd(_: faer::linalg::solvers::SvdError) -> LtiError {
    LtiError::NotConverged { operation: "the singular value decomposition", residual: f64::NAN }
}

/// A generalised eigenvalue alpha/beta of A x = lambda B x; of a complex pair only the member with positive
/// imaginary part. A v = lambda B v and w^H A = lambda w^H B.
#[derive(Debug, Clone)]
pub(crate) struct GeneralizedEigenpair {
    pub(crate) value: Complex<f64>,
    pub(crate) right: CVector,
    pub(crate) left: CVector,
}

/// The generalised eigenvalues of a real pencil with nonsingular B, in no particular order.
pub(crate) fn generalized_eigenpairs(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
) -> Result<Vec<GeneralizedEigenpair>, LtiError> {
    // faer 0.24.4 asks for too small a workspace at small sizes (n <= 5 with both kinds of vectors) and then
    // panics. The workspace of a larger problem is enough for every size.
    const EXTRA: usize = 8;
    let n = a.nrows();
    if n == 0 {
        return Ok(Vec::new());
    }
    let mut a_work = Mat::from_fn(n, n, |i, j| a[(i, j)]);
    let mut b_work = Mat::from_fn(n, n, |i, j| b[(i, j)]);
    let (mut re, mut im, mut beta) =
        (Diag::<f64>::zeros(n), Diag::<f64>::zeros(n), Diag::<f64>::zeros(n));
    let (mut left, mut right) = (Mat::<f64>::zeros(n, n), Mat::<f64>::zeros(n, n));
    let both = ComputeEigenvectors::Yes;
    let scratch = gevd_scratch::<f64>(n + EXTRA, both, both, Par::Seq, Default::default());
    gevd_real(
        a_work.as_mut(),
        b_work.as_mut(),
        re.as_mut(),
        im.as_mut(),
        beta.as_mut(),
        Some(left.as_mut()),
        Some(right.as_mut()),
        Par::Seq,
        MemStack::new(&mut MemBuffer::new(scratch)),
        Default::default(),
    )
    .map_err(|_| LtiError::NotConverged { operation: "the QZ iteration", residual: f64::NAN })?;

    let mut pairs = Vec::with_capacity(n);
    let mut j = 0;
    while j < n {
        let complex = im[j] != 0.0 && j + 1 < n;
        let vector = |m: &Mat<f64>| {
            CVector::from_fn(n, |i, _| {
                Complex::new(m[(i, j)], if complex { m[(i, j + 1)] } else { 0.0 })
            })
        };
        let value = Complex::new(re[j] / beta[j], if complex { im[j] / beta[j] } else { 0.0 });
        // faer's left vectors of complex pairs belong to w^T A = lambda w^T B.
        let left = vector(&left).map(|x| x.conj());
        let pair = GeneralizedEigenpair { value, right: vector(&right), left };
        pairs.push(if value.im < 0.0 { pair.conjugate() } else { pair });
        j += if complex { 2 } else { 1 };
    }
    Ok(pairs)
}

impl GeneralizedEigenpair {
    fn conjugate(self) -> Self {
        Self {
            value: self.value.conj(),
            right: self.right.map(|x| x.conj()),
            left: self.left.map(|x| x.conj()),
        }
    }
}

#[cfg(test)]
mod tests;
