//! The complex Schur form of a real matrix by the shifted QR algorithm (Golub & Van Loan, section 7.5).

use nalgebra::DMatrix;
use num_complex::Complex;

use crate::LtiError;
use crate::dense::CMatrix;
use crate::scaling::{exponent, invertible_power_of_two};

/// A = Q T Q^H with Q unitary and T upper triangular.
pub(crate) struct ComplexSchur {
    pub(crate) q: CMatrix,
    pub(crate) t: CMatrix,
}

/// The complex Schur form of a square finite matrix. One that is upper triangular already is left as it is.
pub(crate) fn complex_schur(a: &DMatrix<f64>) -> Result<ComplexSchur, LtiError> {
    // LAPACK gives up after 30 iterations per eigenvalue; convergence takes two or three.
    const MOST_ITERATIONS: usize = 60;
    const EXCEPTIONAL: usize = 10;
    let n = a.nrows();
    // Entries of about 1: products of two can neither over- nor underflow.
    let scale = invertible_power_of_two(exponent(a.amax()));
    let a = a / scale;
    let (q, h) =
        if n > 2 { a.clone().hessenberg().unpack() } else { (DMatrix::identity(n, n), a.clone()) };
    let mut q = q.map(|x| Complex::new(x, 0.0));
    let mut t = h.map(|x| Complex::new(x, 0.0));
    let norm = a.norm();
    if (0..n).all(|j| (j + 1..n).all(|i| a[(i, j)] == 0.0)) {
        return Ok(ComplexSchur {
            q: CMatrix::identity(n, n),
            t: a.map(|x| Complex::new(x * scale, 0.0)),
        });
    }
    let mut end = n;
    let mut iteration = 0;
    while end > 0 {
        // The last block without a negligible subdiagonal entry: start .. end.
        let mut start = end - 1;
        while start > 0 {
            let neighbours = t[(start, start)].l1_norm() + t[(start - 1, start - 1)].l1_norm();
            let size = if neighbours == 0.0 { norm } else { neighbours };
            if t[(start, start - 1)].l1_norm() <= f64::EPSILON / 2.0 * size {
                t[(start, start - 1)] = Complex::new(0.0, 0.0);
                break;
            }
            start -= 1;
        }
        if start == end - 1 {
            end -= 1;
            iteration = 0;
            continue;
        }
        iteration += 1;
        if iteration > MOST_ITERATIONS {
            return Err(LtiError::NotConverged {
                operation: "the Schur form",
                residual: t[(end - 1, end - 2)].norm() / norm,
            });
        }
        let shift = if iteration % EXCEPTIONAL == 0 {
            t[(end - 1, end - 1)] + 0.75 * t[(end - 1, end - 2)].l1_norm()
        } else {
            wilkinson_shift(&t, end)
        };
        sweep(&mut t, &mut q, start, end, shift);
    }
    for j in 0..n {
        for i in j + 1..n {
            t[(i, j)] = Complex::new(0.0, 0.0);
        }
    }
    t *= Complex::new(scale, 0.0);
    Ok(ComplexSchur { q, t })
}

/// The eigenvalue of the trailing 2 x 2 block that is closer to its last entry.
fn wilkinson_shift(t: &CMatrix, end: usize) -> Complex<f64> {
    let (a, b) = (t[(end - 2, end - 2)], t[(end - 2, end - 1)]);
    let (c, d) = (t[(end - 1, end - 2)], t[(end - 1, end - 1)]);
    let product = b * c;
    if product.l1_norm() == 0.0 {
        return d;
    }
    // d - lambda = product / (half +- root), the sign chosen so that nothing cancels.
    let half = (a - d) * 0.5;
    let root = (half * half + product).sqrt();
    let denominator =
        if half.re * root.re + half.im * root.im >= 0.0 { half + root } else { half - root };
    d - product / denominator
}

/// One QR step on the block start .. end, by Givens rotations: T - sI = Q R, T <- R Q + sI.
fn sweep(t: &mut CMatrix, q: &mut CMatrix, start: usize, end: usize, shift: Complex<f64>) {
    let n = t.nrows();
    // The bulge is chased: the first rotation comes from the shifted column, the others restore the zeros.
    let mut x = t[(start, start)] - shift;
    let mut y = t[(start + 1, start)];
    for k in start..end - 1 {
        if k > start {
            x = t[(k, k - 1)];
            y = t[(k + 1, k - 1)];
        }
        let length = x.norm().hypot(y.norm());
        if length == 0.0 {
            continue;
        }
        let (c, s) = (x / length, y / length);
        // Rows k and k+1 times [c* s*; -s c].
        for j in k.saturating_sub(1).max(start)..n {
            let (upper, lower) = (t[(k, j)], t[(k + 1, j)]);
            t[(k, j)] = c.conj() * upper + s.conj() * lower;
            t[(k + 1, j)] = c * lower - s * upper;
        }
        if k > start {
            t[(k + 1, k - 1)] = Complex::new(0.0, 0.0);
        }
        // Columns k and k+1 times the adjoint.
        for i in 0..(k + 3).min(end) {
            rotate_columns(t, i, k, c, s);
        }
        for i in 0..n {
            rotate_columns(q, i, k, c, s);
        }
    }
}

fn rotate_columns(matrix: &mut CMatrix, i: usize, k: usize, c: Complex<f64>, s: Complex<f64>) {
    let (left, right) = (matrix[(i, k)], matrix[(i, k + 1)]);
    matrix[(i, k)] = left * c + right * s;
    matrix[(i, k + 1)] = right * c.conj() - left * s.conj();
}

#[cfg(test)]
mod tests;
