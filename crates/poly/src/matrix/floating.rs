//! The determinant over 64-bit floats with error estimates.

use super::PolyMatrix;
use crate::{Poly, PolyError};
use num_complex::Complex;
use std::f64::consts::TAU;

type C = Complex<f64>;

/// Up to this size the minors are expanded, with an error bound for each coefficient.
const EXPANSION_LIMIT: usize = 8;

/// A determinant and how far rounding may have moved its coefficients.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Determinant {
    /// The determinant without the leading coefficients that rounding alone could have made.
    pub polynomial: Poly<f64>,
    /// Error of each coefficient, constant term first, also of those that were dropped.
    ///
    /// Up to size 8 a bound: a multiple of the rounding unit times the same coefficient of the sum of
    /// absolute products. Above, an estimate for all coefficients alike.
    pub coefficient_errors: Vec<f64>,
    /// Number of leading coefficients dropped because they are within their error.
    pub vanished_leading: usize,
}

impl PolyMatrix<f64> {
    /// The determinant with error estimates, and with a meaningful degree.
    ///
    /// Up to size 8 by expansion of minors. Above, each row and the variable are scaled by powers of two, the determinant
    /// is evaluated by elimination at roots of unity and the values are transformed back; the error is then about
    /// `n u` times the largest value on the circle for every scaled coefficient.
    ///
    /// # Errors
    /// [`PolyError::NotSquare`], [`PolyError::NonFiniteCoefficient`], [`PolyError::Overflow`].
    ///
    /// # Example
    /// ```
    /// use poly::{Poly, PolyMatrix};
    ///
    /// // The leading terms 0.1 * 0.3 and 0.03 * 1 cancel but for rounding: the degree is 1, not 2.
    /// let p = |c: &[f64]| Poly::from_descending(c);
    /// let m = PolyMatrix::new(2, 2, vec![p(&[0.1, 1.0]), p(&[0.03]), p(&[1.0, 0.0, 0.0]), p(&[0.3, 5.0])])?;
    /// let determinant = m.determinant_f64()?;
    /// assert_eq!(determinant.polynomial.degree(), Some(1));
    /// assert_eq!(determinant.vanished_leading, 1);
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn determinant_f64(&self) -> Result<Determinant, PolyError> {
        self.check_square()?;
        for (degree, c) in self.entries.iter().flat_map(|p| p.coefficients().iter().enumerate()) {
            if !c.is_finite() {
                let value = C::new(*c, 0.0);
                return Err(PolyError::NonFiniteCoefficient { degree, value });
            }
        }
        let (coefficients, coefficient_errors) =
            if self.rows <= EXPANSION_LIMIT { self.expanded()? } else { self.interpolated() };
        if let Some(degree) =
            coefficients.iter().zip(&coefficient_errors).position(|(c, e)| !(c + e).is_finite())
        {
            return Err(PolyError::Overflow { degree });
        }
        let kept = coefficients
            .iter()
            .zip(&coefficient_errors)
            .rposition(|(c, error)| c.abs() > *error)
            .map_or(0, |k| k + 1);
        Ok(Determinant {
            polynomial: Poly::new(coefficients[..kept].to_vec()),
            vanished_leading: coefficients.len() - kept,
            coefficient_errors,
        })
    }

    /// Expansion, and the same for the moduli of the entries with every sign positive.
    fn expanded(&self) -> Result<(Vec<f64>, Vec<f64>), PolyError> {
        let moduli = self.map(|entry| entry.map(|c| c.abs())).permanent();
        let mut coefficients = self.determinant()?.into_coefficients();
        coefficients.resize(moduli.coefficients().len(), 0.0);
        // Each coefficient is a sum over products of up to n factors; one rounding per product and per sum.
        let terms = self.rows * (self.degree().unwrap_or(0) + 1 + self.rows);
        let unit = 0.5 * f64::EPSILON * (terms + 2) as f64;
        let errors = moduli.coefficients().iter().map(|m| unit * m).collect();
        Ok((coefficients, errors))
    }

    /// Values at scaled roots of unity, transformed back.
    fn interpolated(&self) -> (Vec<f64>, Vec<f64>) {
        let n = self.rows;
        let row_degree = |i: usize| (0..n).filter_map(|j| self[(i, j)].degree()).max().unwrap_or(0);
        let column_degree =
            |j: usize| (0..n).filter_map(|i| self[(i, j)].degree()).max().unwrap_or(0);
        let degree = (0..n).map(row_degree).sum::<usize>().min((0..n).map(column_degree).sum());
        let exponent = self.variable_exponent();
        let mut row_shifts = 0;
        let mut scaled: Vec<Vec<f64>> = Vec::with_capacity(n * n);
        for i in 0..n {
            let row = &self.entries[i * n..(i + 1) * n];
            let heights = row.iter().flat_map(|p| {
                p.coefficients()
                    .iter()
                    .zip(0..)
                    .filter(|(c, _)| **c != 0.0)
                    .map(|(c, k): (&f64, i64)| floor(c.abs().log2()) + exponent * k)
            });
            let shift = heights.max().unwrap_or(0);
            row_shifts += shift;
            scaled.extend(row.iter().map(|p| {
                p.coefficients()
                    .iter()
                    .zip(0..)
                    .map(|(&c, k): (&f64, i64)| times_power(c, exponent * k - shift))
                    .collect()
            }));
        }
        let count = degree + 1;
        let mut values = Vec::with_capacity(count);
        let mut largest = 0.0_f64;
        for k in 0..count {
            let node = C::from_polar(1.0, TAU * k as f64 / count as f64);
            let matrix: Vec<C> = scaled
                .iter()
                .map(|p| p.iter().rev().fold(C::new(0.0, 0.0), |v, &c| v * node + c))
                .collect();
            let (value, growth) = eliminate(matrix, n);
            largest = largest.max(growth);
            values.push(value);
        }
        let mut coefficients = Vec::with_capacity(count);
        let mut errors = Vec::with_capacity(count);
        let error = 4.0 * n as f64 * f64::EPSILON * largest;
        for degree in 0..count {
            let sum: C = values
                .iter()
                .enumerate()
                .map(|(k, v)| {
                    let turn = ((k * degree) % count) as f64 / count as f64;
                    v * C::from_polar(1.0, -TAU * turn)
                })
                .sum();
            let back = i64::try_from(degree).map_or(0, |k| row_shifts - exponent * k);
            coefficients.push(times_power(sum.re / count as f64, back));
            errors.push(times_power(error, back));
        }
        (coefficients, errors)
    }

    /// The exponent e for which the lowest and the highest coefficients of the entries of `M(2^e y)` are about equal.
    pub(crate) fn variable_exponent(&self) -> i64 {
        let Some(degree) = self.degree().filter(|&d| d > 0) else { return 0 };
        let largest =
            |k: usize| self.entries.iter().map(|p| p.coefficient(k).abs()).fold(0.0, f64::max);
        let heights: Vec<(usize, f64)> =
            (0..=degree).map(|k| (k, largest(k))).filter(|(_, h)| *h > 0.0).collect();
        match (heights.first(), heights.last()) {
            (Some(&(low, bottom)), Some(&(high, top))) if high > low => {
                floor(((bottom.log2() - top.log2()) / (high - low) as f64).round())
            }
            _ => 0,
        }
    }

    /// The determinant with every sign positive.
    fn permanent(&self) -> Poly<f64> {
        let n = self.rows;
        let mut sums = vec![Poly::zero(); 1 << n];
        sums[0] = Poly::one();
        for set in 1_usize..1 << n {
            let row = set.count_ones() as usize - 1;
            sums[set] = (0..n)
                .filter(|c| set >> c & 1 == 1)
                .map(|column| &self[(row, column)] * &sums[set & !(1 << column)])
                .sum();
        }
        sums.pop().unwrap_or_else(Poly::one)
    }
}

/// The determinant by elimination with row pivoting, and a measure of the error that rounding may cause: the sum over
/// pivots of the determinant without that pivot, times the largest entry.
fn eliminate(mut matrix: Vec<C>, n: usize) -> (C, f64) {
    let largest = matrix.iter().map(|c| c.norm()).fold(0.0, f64::max);
    let mut determinant = C::new(1.0, 0.0);
    let mut pivots = Vec::with_capacity(n);
    for k in 0..n {
        let best = (k..n)
            .max_by(|&i, &j| matrix[i * n + k].norm().total_cmp(&matrix[j * n + k].norm()))
            .unwrap_or(k);
        if best != k {
            for j in 0..n {
                matrix.swap(k * n + j, best * n + j);
            }
            determinant = -determinant;
        }
        let pivot = matrix[k * n + k];
        determinant *= pivot;
        pivots.push(pivot.norm());
        if pivot == C::new(0.0, 0.0) {
            continue;
        }
        for i in k + 1..n {
            let factor = matrix[i * n + k] / pivot;
            for j in k + 1..n {
                let change = factor * matrix[k * n + j];
                matrix[i * n + j] -= change;
            }
        }
    }
    let without = |k: usize| -> f64 {
        pivots.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, p)| p).product()
    };
    let growth = (0..n).map(|k| without(k) * largest).fold(determinant.norm(), f64::max);
    (determinant, growth)
}

fn times_power(x: f64, exponent: i64) -> f64 {
    crate::aberth::scale_by_power(C::new(x, 0.0), exponent).re
}

fn floor(x: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "a binary logarithm of a float")]
    let integer = x.clamp(-1e6, 1e6).floor() as i64;
    integer
}
