//! Least squares without rounding: the solution that a double-precision fit should have found, from
//! the very doubles it was given.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

/// The minimiser of `|| X b - t ||`, rounded once at the end; `None` where the columns of X are
/// dependent, a number is not finite or a result is not.
///
/// Every double is an integer times a power of two, so that the Gram matrix of `[X t]` is one of
/// integers. Elimination without fractions (Bareiss 1968, here in Jordan's form: rows above the
/// pivot are cleared too) ends with the determinant in every place of the diagonal, and by Cramer's
/// rule b_i is what stands beside it, over the determinant.
pub(crate) fn least_squares(columns: &[&[f64]], target: &[f64]) -> Option<Vec<f64>> {
    let lowest = |signals: &[&[f64]]| {
        signals.iter().flat_map(|x| x.iter()).filter_map(|x| parts(*x)).map(|(_, e)| e).min()
    };
    let (unit, target_unit) = (lowest(columns)?, lowest(&[target]).unwrap_or(0));
    let mut signals = columns.iter().map(|x| integers(x, unit)).collect::<Option<Vec<_>>>()?;
    signals.push(integers(target, target_unit)?);

    let mut rows: Vec<Vec<BigInt>> = signals[..columns.len()]
        .iter()
        .map(|x| signals.iter().map(|y| dot(x, y)).collect())
        .collect();
    let determinant = eliminate(&mut rows)?;
    let to_double = |row: &Vec<BigInt>| {
        let value = BigRational::new(row.last()?.clone(), determinant.clone()).to_f64()?;
        let value = value * 2.0_f64.powi(target_unit - unit);
        value.is_finite().then_some(value)
    };
    rows.iter().map(to_double).collect()
}

/// Brings `[G | b]` to `[det G I | det G G^-1 b]`, and returns det G; `None` if G is singular. G is
/// positive semidefinite, so that a pivot vanishes only then.
fn eliminate(rows: &mut [Vec<BigInt>]) -> Option<BigInt> {
    let mut before = BigInt::from(1);
    for k in 0..rows.len() {
        let pivot_row = rows[k].clone();
        let pivot = pivot_row[k].clone();
        if pivot.is_zero() {
            return None;
        }
        for row in rows.iter_mut().enumerate().filter(|(i, _)| *i != k).map(|(_, row)| row) {
            let factor = row[k].clone();
            for (j, x) in row.iter_mut().enumerate() {
                let product = &pivot * &*x - &factor * &pivot_row[j];
                // Sylvester's identity: the previous pivot divides it without remainder.
                *x = product / &before;
            }
        }
        before = pivot;
    }
    Some(before)
}

fn dot(x: &[BigInt], y: &[BigInt]) -> BigInt {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// A signal in multiples of 2^unit.
fn integers(signal: &[f64], unit: i32) -> Option<Vec<BigInt>> {
    let integer = |x: &f64| {
        if !x.is_finite() {
            return None;
        }
        let Some((mantissa, exponent)) = parts(*x) else {
            return Some(BigInt::zero());
        };
        Some(BigInt::from(mantissa) << usize::try_from(exponent - unit).ok()?)
    };
    signal.iter().map(integer).collect()
}

/// x = mantissa 2^exponent; `None` for zero and for what is not finite.
fn parts(x: f64) -> Option<(i64, i32)> {
    if x == 0.0 || !x.is_finite() {
        return None;
    }
    let bits = x.to_bits();
    let biased = i32::try_from((bits >> 52) & 0x7ff).ok()?;
    let fraction = i64::try_from(bits & ((1 << 52) - 1)).ok()?;
    let magnitude = if biased == 0 { fraction } else { fraction | (1 << 52) };
    let mantissa = if x < 0.0 { -magnitude } else { magnitude };
    Some((mantissa, biased.max(1) - 1075))
}

#[cfg(test)]
mod tests;
