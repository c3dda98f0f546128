//! The triangle R of a Gram matrix: singular values without squaring.

use doubled::DoubleDouble;
use hankel::Gram;
use nalgebra::DMatrix;

/// Pivots below so many times the rounding of the Gram matrix, relative to their diagonal entry, are rounding errors of it and of the elimination.
const PIVOT_FLOOR: f64 = 10.0;

/// The rounding of a Gram matrix is not taken for less than this.
const LEAST_ROUNDING: f64 = 1e-30;

/// R with `R' R = H H' / M`, rounded to double: a triangle but for the order of its columns, which is that of the Gram matrix.
///
/// A Cholesky factorisation in doubled precision, so that R is as accurate as that of a QR factorisation of H' in double: noise 1e-14 of the
/// signal is still told from it. The row with the largest part that the rows before leave unexplained, relative to its norm, comes next;
/// without that choice a weak sensor would multiply rounding errors with each block row. Rows of H that depend on others have no row in R;
/// the remaining rows of R are zero.
pub(super) fn triangle(gram: &Gram) -> DMatrix<f64> {
    let p = gram.shape().0;
    let floor = PIVOT_FLOOR * gram.rounding().max(LEAST_ROUNDING);
    let entry = |i, k| gram.entry(i, k).unwrap_or(DoubleDouble::ZERO);
    let root = (gram.rows() as f64).sqrt();
    let diagonal: Vec<f64> = (0..p).map(|i| entry(i, i).value()).collect();
    let mut rest: Vec<DoubleDouble> =
        (0..p).flat_map(|i| (0..p).map(move |k| (i, k))).map(|(i, k)| entry(i, k)).collect();
    let mut open: Vec<usize> = (0..p).collect();
    let mut r = DMatrix::zeros(p, p);
    for step in 0..p {
        let share = |i: &usize| rest[i * p + i].value() / diagonal[*i].max(f64::MIN_POSITIVE);
        let Some(next) = (0..open.len()).max_by(|a, b| {
            // Of equal ones the first, so that nothing but the matrix decides.
            share(&open[*a]).total_cmp(&share(&open[*b])).then(b.cmp(a))
        }) else {
            break;
        };
        if share(&open[next]) <= floor {
            break;
        }
        let pivot = open.remove(next);
        let length = rest[pivot * p + pivot].sqrt();
        r[(step, pivot)] = length.value() / root;
        let row: Vec<DoubleDouble> = open.iter().map(|&k| rest[pivot * p + k] / length).collect();
        for (at, (&k, &factor)) in open.iter().zip(&row).enumerate() {
            r[(step, k)] = factor.value() / root;
            for (&l, &other) in open[at..].iter().zip(&row[at..]) {
                let entry = rest[k * p + l] - factor * other;
                rest[k * p + l] = entry;
                rest[l * p + k] = entry;
            }
        }
    }
    r
}

#[cfg(test)]
mod tests;
