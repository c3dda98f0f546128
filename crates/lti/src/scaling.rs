//! Scaling by powers of two, which costs no rounding: balancing (Parlett & Reinsch 1969, with the norms of
//! James, Langou & Lowery 2014) and protection against overflow.

use nalgebra::{DMatrix, DVector};

/// 2^exponent with the exponent held where both it and its inverse are normal numbers.
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    2.0_f64.powi(exponent.clamp(-1000, 1000))
}

/// The exponent of the power of two next below |x| (0 for x = 0).
#[expect(
    clippy::cast_possible_truncation,
    reason = "the exponent of a finite number lies in -1075..1025"
)]
pub(crate) fn exponent(x: f64) -> i32 {
    if x == 0.0 || !x.is_finite() { 0 } else { x.abs().log2().floor() as i32 }
}

/// `matrix = D^-1 (A / scale) D` with D diagonal, all powers of two.
#[derive(Debug, Clone)]
pub(crate) struct Balanced {
    /// The balanced matrix, with entries of at most about 1.
    pub(crate) matrix: DMatrix<f64>,
    /// The diagonal of D.
    pub(crate) diagonal: DVector<f64>,
    /// What A was divided by.
    pub(crate) scale: f64,
}

/// Balances a square matrix: rows and columns of like norm, largest entry about 1.
pub(crate) fn balance(a: &DMatrix<f64>) -> Balanced {
    let before = power_of_two(exponent(a.amax()));
    let (matrix, diagonal) = balance_similarity(&(a / before));
    // Balancing can lower the norm a lot where the states had odd units.
    let after = power_of_two(exponent(matrix.amax()));
    Balanced { matrix: matrix / after, diagonal, scale: before * after }
}

/// Only the diagonal similarity of [`balance`].
pub(crate) fn balance_similarity(a: &DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>) {
    const SWEEPS: usize = 100;
    const WORTHWHILE: f64 = 0.95; // LAPACK's: a step has to lower the sum of norms by 5 %.
    let n = a.nrows();
    let mut matrix = a.clone();
    let mut diagonal = DVector::from_element(n, 1.0);
    for _ in 0..SWEEPS {
        let mut changed = false;
        for i in 0..n {
            let column = matrix.column(i).norm();
            let row = matrix.row(i).norm();
            if column == 0.0 || row == 0.0 {
                continue;
            }
            // The factor f makes f column = row / f.
            let factor = power_of_two(exponent((row / column).sqrt() * core::f64::consts::SQRT_2));
            let total: f64 = diagonal[i] * factor;
            let in_range = (1e-280..=1e280).contains(&total);
            if in_range && column * factor + row / factor < WORTHWHILE * (column + row) {
                matrix.column_mut(i).scale_mut(factor);
                matrix.row_mut(i).scale_mut(1.0 / factor);
                diagonal[i] = total;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    (matrix, diagonal)
}

/// The 1-norm: the largest sum of absolute values in a column.
pub(crate) fn norm_1(matrix: &DMatrix<f64>) -> f64 {
    matrix.column_iter().map(|column| column.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
