//! Scaling by powers of two, which costs no rounding: balancing (Parlett & Reinsch 1969, with the norms of
//! James, Langou & Lowery 2014) and protection against overflow.

use doubled::{power_of_two, times_power_of_two};
use nalgebra::{DMatrix, DVector};

/// 2^exponent with the exponent held where both it and its inverse are normal numbers.
pub(crate) fn invertible_power_of_two(exponent: i32) -> f64 {
    power_of_two(exponent.clamp(-1000, 1000))
}

/// The exponent of the power of two next below |x| (0 for x = 0).
pub(crate) fn exponent(x: f64) -> i32 {
    split(x).map_or(0, |(_, exponent)| exponent)
}

/// x = m 2^e with 1 <= |m| < 2; `None` for 0 and for what is not finite.
fn split(x: f64) -> Option<(f64, i32)> {
    const EXPONENT_BITS: u64 = 0x7ff << 52;
    if x == 0.0 || !x.is_finite() {
        return None;
    }
    if x.abs() < f64::MIN_POSITIVE {
        let (mantissa, exponent) = split(x * power_of_two(100))?;
        return Some((mantissa, exponent - 100));
    }
    let mantissa = f64::from_bits(x.to_bits() & !EXPONENT_BITS | 1.0_f64.to_bits());
    Some((mantissa, doubled::exponent(x)))
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

/// [`Balanced`] with the powers of two held as exponents: D may span more than the range of a double.
#[derive(Debug, Clone)]
pub(crate) struct WidelyBalanced {
    pub(crate) matrix: DMatrix<f64>,
    /// Exponents of the diagonal of D.
    pub(crate) diagonal: Vec<i32>,
    /// Exponent of what A was divided by.
    pub(crate) scale: i32,
}

/// Largest exponent in a D of doubles (about 1e280): products with ordinary entries stay in range.
const DOUBLE_RANGE: i32 = 930;
/// Largest exponent in a D of exponents: never reached, it only rules out overflow of the integers.
const WIDE_RANGE: i32 = 1 << 20;

/// Balances a square matrix: rows and columns of like norm, largest entry about 1.
pub(crate) fn balance(a: &DMatrix<f64>) -> Balanced {
    let parts = Parts::new(a);
    let diagonal = parts.balancing(DOUBLE_RANGE);
    let scale = parts.largest(&diagonal).clamp(-1000, 1000);
    Balanced {
        matrix: parts.matrix(&diagonal, scale),
        diagonal: DVector::from_iterator(a.nrows(), diagonal.iter().map(|&e| power_of_two(e))),
        scale: power_of_two(scale),
    }
}

/// [`balance`] without a limit on D, for entries from one end of the range of doubles to the other.
pub(crate) fn balance_widely(a: &DMatrix<f64>) -> WidelyBalanced {
    let parts = Parts::new(a);
    let diagonal = parts.balancing(WIDE_RANGE);
    let scale = parts.largest(&diagonal);
    WidelyBalanced { matrix: parts.matrix(&diagonal, scale), diagonal, scale }
}

/// Only the diagonal similarity of [`balance`].
pub(crate) fn balance_similarity(a: &DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let parts = Parts::new(a);
    let diagonal = parts.balancing(DOUBLE_RANGE);
    let factors = DVector::from_iterator(a.nrows(), diagonal.iter().map(|&e| power_of_two(e)));
    (parts.matrix(&diagonal, 0), factors)
}

/// m 2^e with m = 0 or of order one: a positive number that can't leave the range.
#[derive(Debug, Clone, Copy)]
struct Wide(f64, i32);

impl Wide {
    /// The Euclidean norm of numbers given like this.
    fn norm(entries: impl Iterator<Item = (f64, i32)> + Clone) -> Self {
        let Some(top) = entries.clone().map(|(_, exponent)| exponent).max() else {
            return Self(0.0, 0);
        };
        // What underflows here is below the rounding error of the sum.
        let square = |(m, exponent)| times_power_of_two(m, exponent - top).powi(2);
        Self(entries.map(square).sum::<f64>().sqrt(), top)
    }

    fn log2(self) -> f64 {
        self.0.log2() + f64::from(self.1)
    }

    /// The number over 2^unit.
    fn over(self, unit: i32) -> f64 {
        times_power_of_two(self.0, self.1 - unit)
    }
}

/// A matrix entry by entry as mantissa and exponent, zeros left out. Balancing changes only exponents, so nothing
/// can overflow or underflow before the spread of the entries has been taken out.
struct Parts(DMatrix<Option<(f64, i32)>>);

impl Parts {
    fn new(a: &DMatrix<f64>) -> Self {
        Self(a.map(split))
    }

    /// The entry (i, j) of D^-1 A D.
    fn entry(&self, i: usize, j: usize, diagonal: &[i32]) -> Option<(f64, i32)> {
        self.0[(i, j)].map(|(m, exponent)| (m, exponent + diagonal[j] - diagonal[i]))
    }

    /// The exponents of D.
    fn balancing(&self, limit: i32) -> Vec<i32> {
        // A spread along a cycle of n states may shrink by no more than about 1 - 10/n^2 a sweep.
        const SWEEPS: usize = 1000;
        const WORTHWHILE: f64 = 0.95; // LAPACK's: a step has to lower the sum of norms by 5 %.
        let n = self.0.nrows();
        let mut diagonal = vec![0; n];
        for _ in 0..SWEEPS {
            let mut changed = false;
            for i in 0..n {
                let column = Wide::norm((0..n).filter_map(|k| self.entry(k, i, &diagonal)));
                let row = Wide::norm((0..n).filter_map(|k| self.entry(i, k, &diagonal)));
                if column.0 == 0.0 || row.0 == 0.0 {
                    continue;
                }
                // The factor 2^step makes 2^step column = row / 2^step.
                let step = nearest((row.log2() - column.log2()) / 2.0);
                let total = diagonal[i] + step;
                let (new_column, new_row) =
                    (Wide(column.0, column.1 + step), Wide(row.0, row.1 - step));
                let unit = column.1.max(row.1).max(new_column.1).max(new_row.1);
                let now = column.over(unit) + row.over(unit);
                let then = new_column.over(unit) + new_row.over(unit);
                if total.abs() <= limit && then < WORTHWHILE * now {
                    diagonal[i] = total;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        diagonal
    }

    /// The largest exponent in D^-1 A D; 0 for a zero matrix.
    fn largest(&self, diagonal: &[i32]) -> i32 {
        let n = self.0.nrows();
        let entries = (0..n).flat_map(|j| (0..n).map(move |i| (i, j)));
        entries
            .filter_map(|(i, j)| self.entry(i, j, diagonal))
            .map(|(_, exponent)| exponent)
            .max()
            .unwrap_or(0)
    }

    /// D^-1 (A / 2^scale) D.
    fn matrix(&self, diagonal: &[i32], scale: i32) -> DMatrix<f64> {
        let n = self.0.nrows();
        DMatrix::from_fn(n, n, |i, j| {
            self.entry(i, j, diagonal).map_or(0.0, |(m, e)| times_power_of_two(m, e - scale))
        })
    }
}

#[expect(clippy::cast_possible_truncation, reason = "half a difference of exponents in an i32")]
fn nearest(x: f64) -> i32 {
    (x + 0.5).floor() as i32
}

/// The 1-norm: the largest sum of absolute values in a column.
pub(crate) fn norm_1(matrix: &DMatrix<f64>) -> f64 {
    matrix.column_iter().map(|column| column.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
