//! All simple roots at once: the Ehrlich-Aberth iteration from the Newton polygon.
//!
//! Each step is Newton's with the other approximations' repulsion: with `N = p/p'` and
//! `S = sum over j of 1/(z - z_j)` the correction is `N / (1 - N S)` (Aberth 1973, Math. Comp. 27).
//! A root first iterates in plain floats until `p` sinks below its rounding error, then in doubled precision.
//! Each evaluation is scaled by a power of two near the root's modulus, so coefficients may spread over the
//! whole range of floats.

#[cfg(test)]
mod tests;

use crate::PolyError;
use crate::newton_polygon::NewtonPolygon;
use crate::poly::floating::{absolute_sum, doubled_bound, horner_doubled, horner_with_bound};
use doubled::times_power_of_two;
use num_complex::Complex;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

type C = Complex<f64>;

/// Moduli of roots must lie within 2^-LIMIT .. 2^LIMIT, so that differences don't overflow.
const LIMIT: f64 = 1020.0;

/// Bini's angle between circles, so that no two starts fall together and none is real.
const TWIST: f64 = 0.7;

/// Terms of the repulsion smaller than this cannot matter beside a correction of order one.
const FAR: f64 = 1e100;

/// Approximate roots and how they were found.
#[derive(Debug, Clone)]
pub(crate) struct Approximations {
    pub(crate) roots: Vec<C>,
    pub(crate) iterations: usize,
    pub(crate) converged: bool,
}

/// A polynomial with nonzero first and last coefficients, evaluated under scaling.
#[derive(Debug, Clone)]
pub(crate) struct ScaledPoly {
    coefficients: Vec<C>,
    polygon: NewtonPolygon,
    cache: BTreeMap<i64, Vec<C>>,
}

/// A value of the scaled polynomial `p(2^e y) / 2^shift` and its derivative with respect to `y`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ScaledValue {
    pub(crate) value: C,
    pub(crate) derivative: C,
    /// Bound on the rounding error of `value`.
    pub(crate) bound: f64,
    /// Sum of the moduli of the terms.
    pub(crate) terms: f64,
}

/// Which arithmetic an evaluation uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Precision {
    Plain,
    Doubled,
}

/// `x 2^exponent` without overflow on the way.
pub(crate) fn scale_by_power(x: C, exponent: i64) -> C {
    // Farther than from one end of the range to the other, so that an exponent beyond changes nothing.
    let exponent = i32::try_from(exponent.clamp(-4000, 4000)).expect("clamped");
    C::new(times_power_of_two(x.re, exponent), times_power_of_two(x.im, exponent))
}

/// Binary logarithm of the modulus; minus infinity for zero.
pub(crate) fn log2_modulus(x: C) -> f64 {
    // Scale up first: the modulus of a subnormal has few digits.
    let large = x.re.abs().max(x.im.abs());
    if large == 0.0 {
        return f64::NEG_INFINITY;
    }
    let shift: i64 = if large < 1e-200 {
        600
    } else if large > 1e200 {
        -600
    } else {
        0
    };
    let back = shift as f64;
    scale_by_power(x, shift).norm().log2() - back
}

fn rounded(x: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "clamped to a small range")]
    let integer = x.clamp(-1e15, 1e15).round() as i64;
    integer
}

impl ScaledPoly {
    pub(crate) fn new(coefficients: Vec<C>) -> Self {
        let heights: Vec<f64> = coefficients.iter().map(|&c| log2_modulus(c)).collect();
        let polygon = NewtonPolygon::new(&heights);
        Self { coefficients, polygon, cache: BTreeMap::new() }
    }

    pub(crate) fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// The Newton polygon's heights for `p(2^e y)` at each degree, and the exponent e that makes the first and the last
    /// about equal.
    pub(crate) fn hull(&self) -> (Vec<f64>, i64) {
        let degree = self.degree();
        let heights: Vec<f64> = (0..=degree).map(|k| self.polygon.height(k)).collect();
        let exponent =
            if degree == 0 { 0 } else { rounded((heights[0] - heights[degree]) / degree as f64) };
        let scaled =
            heights.iter().enumerate().map(|(k, h)| h + exponent as f64 * k as f64).collect();
        (scaled, exponent)
    }

    /// The power of two nearest to the modulus of `z`.
    pub(crate) fn exponent(z: C) -> i64 {
        rounded(log2_modulus(z).clamp(-LIMIT, LIMIT))
    }

    /// Coefficients of `p(2^exponent y)` divided by a power of two near the largest of them.
    pub(crate) fn scaled(&mut self, exponent: i64) -> &[C] {
        let coefficients = &self.coefficients;
        self.cache.entry(exponent).or_insert_with(|| {
            let degrees = 0_i64..;
            let shift = coefficients
                .iter()
                .zip(degrees.clone())
                .filter(|(c, _)| **c != C::new(0.0, 0.0))
                .map(|(&c, k)| rounded(log2_modulus(c)) + exponent * k)
                .max()
                .unwrap_or(0);
            coefficients
                .iter()
                .zip(degrees)
                .map(|(&c, k)| scale_by_power(c, exponent * k - shift))
                .collect()
        })
    }

    /// Evaluates at `2^exponent y`.
    pub(crate) fn evaluate(&mut self, y: C, exponent: i64, precision: Precision) -> ScaledValue {
        let coefficients = self.scaled(exponent);
        let terms = absolute_sum(coefficients, y.norm());
        match precision {
            Precision::Plain => {
                let evaluation = horner_with_bound(coefficients, y, 2.24);
                let mut derivative = C::new(0.0, 0.0);
                for (k, c) in coefficients.iter().enumerate().skip(1).rev() {
                    derivative = derivative * y + c * k as f64;
                }
                ScaledValue {
                    value: evaluation.value,
                    derivative,
                    bound: evaluation.error_bound,
                    terms,
                }
            }
            Precision::Doubled => {
                let (value, derivative) = horner_doubled(coefficients, y.into());
                let bound = doubled_bound(coefficients, y.norm());
                ScaledValue { value: value.value(), derivative: derivative.value(), bound, terms }
            }
        }
    }

    /// Starting points: on each circle of the Newton polygon, equally spaced.
    fn starts(&self) -> Result<Vec<C>, PolyError> {
        let mut starts = Vec::with_capacity(self.degree());
        for (circle, edge) in self.polygon.edges().enumerate() {
            if edge.log2_modulus.abs() > LIMIT {
                return Err(PolyError::RootOutOfRange { log2_modulus: edge.log2_modulus });
            }
            let exponent = edge.log2_modulus.round();
            let radius = (edge.log2_modulus - exponent).exp2();
            for k in 0..edge.roots {
                let angle = TAU
                    * (k as f64 / edge.roots as f64 + circle as f64 / self.degree() as f64)
                    + TWIST;
                starts.push(scale_by_power(C::from_polar(radius, angle), rounded(exponent)));
            }
        }
        Ok(starts)
    }

    /// All roots, approximately: to a float's precision where doubled precision can tell.
    pub(crate) fn approximate(
        &mut self,
        maximum_iterations: usize,
    ) -> Result<Approximations, PolyError> {
        let mut roots = self.starts()?;
        let mut state = vec![Some(Precision::Plain); roots.len()];
        let mut iterations = 0;
        while iterations < maximum_iterations && state.iter().any(Option::is_some) {
            iterations += 1;
            for i in 0..roots.len() {
                let Some(precision) = state[i] else { continue };
                (roots[i], state[i]) = self.step(&roots, i, precision);
            }
        }
        let converged = state.iter().all(Option::is_none);
        Ok(Approximations { roots, iterations, converged })
    }

    /// One correction of root `i`: the new value and what to do next.
    fn step(&mut self, roots: &[C], i: usize, precision: Precision) -> (C, Option<Precision>) {
        let z = roots[i];
        let exponent = Self::exponent(z);
        let y = scale_by_power(z, -exponent);
        let at = self.evaluate(y, exponent, precision);
        if at.value.norm() <= at.bound {
            return match precision {
                Precision::Plain => (z, Some(Precision::Doubled)),
                Precision::Doubled => (z, None),
            };
        }
        let mut repulsion = C::new(0.0, 0.0);
        for (j, &other) in roots.iter().enumerate() {
            let distance = y - scale_by_power(other, -exponent);
            let size = distance.re.abs().max(distance.im.abs());
            if j != i && size > 0.0 && size < FAR {
                repulsion += distance.inv();
            }
        }
        // N / (1 - N S) = 1 / (p'/p - S)
        let correction = (at.derivative / at.value - repulsion).inv();
        let size = correction.norm();
        if !size.is_finite() {
            // A stationary point: step aside.
            return (z * C::from_polar(1.0, 0.1), Some(precision));
        }
        // A correction may not throw the root beyond twice its own modulus.
        let limited = if size > y.norm() { correction * (y.norm() / size) } else { correction };
        let moved = y - limited;
        let next = match precision {
            Precision::Doubled if size <= 0.5 * f64::EPSILON * y.norm() => None,
            Precision::Plain if size <= 1e-12 * y.norm() => Some(Precision::Doubled),
            other => Some(other),
        };
        if moved.norm() < 1e-3 * y.norm() {
            // Never onto zero: zero is not a root here.
            return (scale_by_power(y * 0.5, exponent), next);
        }
        (scale_by_power(moved, exponent), next)
    }
}
