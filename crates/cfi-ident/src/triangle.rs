//! The triangle of a tall matrix: blocks of rows folded into it one after another by Householder reflections.
//!
//! Everything a least-squares fit needs to know about its N x p regressors and its right-hand side is in one (p + 1) x (p + 1)
//! triangle. Memory is O(p^2) plus a block of rows, and further records simply go on folding in.

use nalgebra::{DMatrix, DVector};

/// R of the QR factorisation of `[Phi' Psi']`, the regressors with the right-hand side as the last column.
///
/// With Q orthogonal and `Q' [Phi' Psi'] = R`:
///
/// - the leading p x p part is the triangle of the regressors,
/// - the last column above its diagonal is the projected right-hand side,
/// - the last diagonal element is, but for its sign, the norm of the residual.
///
/// Signs of rows are not normalised.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Triangle {
    r: DMatrix<f64>,
    rows: usize,
}

impl Triangle {
    /// The triangle of no rows at all, for `columns` regressors and a right-hand side.
    pub(crate) fn new(columns: usize) -> Self {
        Self { r: DMatrix::zeros(columns + 1, columns + 1), rows: 0 }
    }

    /// Folds a block of rows in. The block is used as workspace and left in an unspecified state.
    ///
    /// Each reflection touches one row of the triangle and the rows of the block, since everything between is zero:
    /// 2 p^2 operations a row, whatever the size of the block.
    pub(crate) fn absorb(&mut self, block: &mut DMatrix<f64>) {
        let columns = self.r.ncols();
        assert_eq!(block.ncols(), columns, "a block has the regressors and the right-hand side");
        let height = block.nrows();
        self.rows += height;
        if height == 0 {
            return;
        }
        let data = block.as_mut_slice();
        for j in 0..columns {
            let (done, right) = data.split_at_mut((j + 1) * height);
            let v = &mut done[j * height..];
            let below = dot(v, v);
            if below == 0.0 {
                continue;
            }
            let alpha = self.r[(j, j)];
            let norm = alpha.hypot(below.sqrt());
            let beta = if alpha > 0.0 { -norm } else { norm };
            let head = alpha - beta;
            let tau = -head / beta;
            v.iter_mut().for_each(|x| *x /= head);
            self.r[(j, j)] = beta;
            for (k, column) in right.chunks_exact_mut(height).enumerate() {
                let top = &mut self.r[(j, j + 1 + k)];
                let step = tau * (*top + dot(v, column));
                *top -= step;
                column.iter_mut().zip(&*v).for_each(|(x, v)| *x -= step * v);
            }
        }
    }

    /// Number of regressors, p.
    pub(crate) fn columns(&self) -> usize {
        self.r.ncols() - 1
    }

    /// Rows folded in so far.
    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    /// The p x p triangle of the regressors.
    pub(crate) fn regressors(&self) -> DMatrix<f64> {
        let p = self.columns();
        self.r.view((0, 0), (p, p)).into_owned()
    }

    /// The projected right-hand side, p elements.
    pub(crate) fn right_hand_side(&self) -> DVector<f64> {
        let p = self.columns();
        self.r.view((0, p), (p, 1)).column(0).into_owned()
    }

    /// Norm of the right-hand side itself.
    pub(crate) fn target_norm(&self) -> f64 {
        self.r.column(self.columns()).norm()
    }

    /// Norm of the residual of the full-rank solution.
    pub(crate) fn residual_norm(&self) -> f64 {
        let p = self.columns();
        self.r[(p, p)].abs()
    }
}

/// Dot product in eight interleaved sums: a fixed order that vectorises, and a smaller error than one sum.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (a, b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let tail: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a.zip(b) {
        for i in 0..LANES {
            sums[i] += x[i] * y[i];
        }
    }
    let [s0, s1, s2, s3, s4, s5, s6, s7] = sums;
    ((s0 + s4) + (s1 + s5)) + ((s2 + s6) + (s3 + s7)) + tail
}

#[cfg(test)]
mod tests;
