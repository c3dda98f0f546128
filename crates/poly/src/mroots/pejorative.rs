//! Multiple roots, refined together with their multiplicities held fixed (Zeng 2005, Math. Comp. 74).
//!
//! The polynomials `c (x - z_1)^m_1 ... (x - z_k)^m_k` with given multiplicities form a manifold in the space of
//! coefficients, Kahan's pejorative manifold. Gauss-Newton iteration finds the nearest point of it: minimise
//! `sum over k of |(q_k - p_k) / h_k|^2` over c and z, where `h_k` is the Newton polygon's hull at degree k,
//! so that the answer does not depend on the scales of x and p. On the manifold the roots are well conditioned even where
//! each of them, taken as simple, is hopeless. Residuals and roots are kept in doubled precision.

use crate::aberth::{ScaledPoly, scale_by_power};
use crate::least_squares::Factored;
use crate::leja::leja_order;
use doubled::DoubleDoubleComplex;
use num_complex::Complex;

type C = Complex<f64>;

/// Hypotheses with more Gauss-Newton steps than this are given up.
const MAXIMUM_STEPS: usize = 40;

/// Relative size of a step that changes nothing more, not even the low parts of the doubled roots that are rounded to
/// floats in the end.
const NEGLIGIBLE_STEP: f64 = 1e-24;

/// Scaled coefficients below this could lose bits to underflow.
const SMALLEST_HULL: f64 = -850.0;

/// A root in doubled precision and its multiplicity.
type Unknown = (DoubleDoubleComplex, usize);

/// A root and its multiplicity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Multiple {
    pub(crate) value: C,
    pub(crate) multiplicity: usize,
}

/// A point of the manifold nearest to the polynomial.
#[derive(Debug, Clone)]
pub(crate) struct Fit {
    pub(crate) roots: Vec<Multiple>,
    /// Relative condition of each root for changes of the coefficients, multiplicities held.
    pub(crate) conditions: Vec<f64>,
    /// Largest `|q_k - p_k| / h_k`.
    pub(crate) largest_error: f64,
    pub(crate) steps: usize,
}

/// The polynomial, scaled once for all hypotheses.
#[derive(Debug, Clone)]
pub(crate) struct Target {
    coefficients: Vec<C>,
    hull: Vec<f64>,
    exponent: i64,
    real: bool,
}

impl Target {
    /// `None` if the coefficients spread so far that one scale does not serve them all.
    pub(crate) fn new(p: &mut ScaledPoly, real: bool) -> Option<Self> {
        let (hull, exponent) = p.hull();
        let lowest = hull.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = hull.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if lowest - highest < SMALLEST_HULL {
            return None;
        }
        let coefficients = p.scaled(exponent).to_vec();
        // The scaled coefficients carry one common power of two: that of the largest.
        let largest = coefficients.iter().map(|c| c.norm()).fold(0.0, f64::max);
        let top = (0..coefficients.len()).map(|k| (hull[k], coefficients[k].norm())).fold(
            (f64::NEG_INFINITY, largest),
            |best, (height, modulus)| {
                if modulus > 0.0 && height > best.0 { (height, modulus) } else { best }
            },
        );
        let hull = hull.iter().map(|h| (h - top.0).exp2() * top.1).collect();
        Some(Self { coefficients, hull, exponent, real })
    }

    pub(crate) fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// The coefficients on the common scale.
    pub(crate) fn coefficients(&self) -> &[C] {
        &self.coefficients
    }

    /// Whether the coefficients are real.
    pub(crate) fn is_real(&self) -> bool {
        self.real
    }

    /// The power of two that roots were divided by.
    pub(crate) fn exponent(&self) -> i64 {
        self.exponent
    }

    /// `(q_k - p_k) / h_k` for `q = factor * product`.
    fn residual(&self, product: &[DoubleDoubleComplex], factor: DoubleDoubleComplex) -> Vec<C> {
        product
            .iter()
            .zip(&self.coefficients)
            .zip(&self.hull)
            .map(|((&q, &p), &h)| (factor * q - p.into()).value() / h)
            // Conjugate factors leave imaginary parts of rounding size only.
            .map(|r| if self.real { C::new(r.re, 0.0) } else { r })
            .collect()
    }

    /// Backward error of the roots as they are: the largest relative error of a coefficient.
    pub(crate) fn backward_error(&self, roots: &[Multiple]) -> f64 {
        let values: Vec<Unknown> = roots
            .iter()
            .map(|root| {
                let value = scale_by_power(root.value, -self.exponent);
                (value.into(), root.multiplicity)
            })
            .collect();
        let leading = self.coefficients.last().copied().unwrap_or_default();
        let residual = self.residual(&expand(&in_leja_order(&values)), leading.into());
        residual.iter().map(|r| r.norm()).fold(0.0, f64::max)
    }

    /// The nearest polynomial with the multiplicities of `start`; `None` if its mean error exceeds the tolerance or the
    /// iteration fails.
    ///
    /// With real coefficients `start` holds real roots and exact conjugate pairs, and so does the result.
    pub(crate) fn fit(&self, start: &[Multiple], tolerance: f64) -> Option<Fit> {
        if start.iter().map(|root| root.multiplicity).sum::<usize>() != self.degree() {
            return None;
        }
        // Of a conjugate pair only the upper root is an unknown.
        let mut unknowns: Vec<Unknown> = start
            .iter()
            .filter(|root| !self.real || root.value.im >= 0.0)
            .map(|root| (scale_by_power(root.value, -self.exponent).into(), root.multiplicity))
            .collect();
        let mut factor = DoubleDoubleComplex::from(self.coefficients.last().copied()?);
        let mut best: Option<(f64, Vec<Unknown>, DoubleDoubleComplex)> = None;
        let mut failures = 0;
        let mut steps = 0;
        while steps < MAXIMUM_STEPS {
            steps += 1;
            let all = self.with_conjugates(&unknowns);
            let residual = self.residual(&expand(&all), factor);
            let size = residual.iter().map(C::norm_sqr).sum::<f64>().sqrt();
            if !size.is_finite() {
                return None;
            }
            if best.as_ref().is_none_or(|(least, ..)| size < *least) {
                best = Some((size, unknowns.clone(), factor));
            } else {
                failures += 1;
                if failures > 1 {
                    break;
                }
            }
            let factored = Factored::new(self.jacobian(&unknowns, factor))?;
            let correction = factored.solve(&residual);
            if !correction.iter().all(|c| c.re.is_finite() && c.im.is_finite()) {
                return None;
            }
            let relative = self.complex_corrections(&correction, &unknowns);
            let largest = relative.iter().map(|c| c.norm()).fold(0.0, f64::max);
            // A root may not move by more than half its modulus at once.
            let damping = if largest > 0.5 { 0.5 / largest } else { 1.0 };
            for ((value, _), step) in unknowns.iter_mut().zip(&relative[1..]) {
                *value -= *value * (step * damping).into();
            }
            factor -= factor * (relative[0] * damping).into();
            if largest <= NEGLIGIBLE_STEP {
                break;
            }
        }
        let (size, unknowns, factor) = best?;
        let count = self.coefficients.len() as f64;
        if size / count.sqrt() > tolerance {
            return None;
        }
        self.describe(&unknowns, factor, steps)
    }

    /// The unknowns and, for real coefficients, the conjugates of those that are not real.
    fn with_conjugates(&self, unknowns: &[Unknown]) -> Vec<Unknown> {
        let mut all = Vec::with_capacity(2 * unknowns.len());
        for &(value, multiplicity) in unknowns {
            all.push((value, multiplicity));
            if self.real && value.value().im != 0.0 {
                all.push((value.conj(), multiplicity));
            }
        }
        in_leja_order(&all)
    }

    /// Columns of the Jacobian with respect to the relative change of the factor and of each root, divided by the hull.
    /// For real coefficients a root that is not real has two columns: real and imaginary part of its change.
    fn jacobian(&self, unknowns: &[Unknown], factor: DoubleDoubleComplex) -> Vec<Vec<C>> {
        let all: Vec<(C, usize)> =
            self.with_conjugates(unknowns).iter().map(|(z, m)| (z.value(), *m)).collect();
        let common = product(
            all.iter().flat_map(|&(z, m)| std::iter::repeat_n(z, m.saturating_sub(1))),
            factor.value(),
        );
        let weigh = |column: Vec<C>| -> Vec<C> {
            column.iter().zip(&self.hull).map(|(c, h)| c / h).collect()
        };
        let whole = times(&common, all.iter().map(|&(z, _)| z));
        let mut columns = vec![weigh(whole)];
        for &(value, multiplicity) in unknowns {
            let value = value.value();
            // The derivative with respect to z is -m q / (x - z); the unknown is the change relative to z.
            let mut others: Vec<C> = all.iter().map(|&(z, _)| z).collect();
            if let Some(own) = others.iter().position(|&z| z == value) {
                others.remove(own);
            }
            let count = multiplicity as f64;
            let mut column = times(&common, others.into_iter());
            for c in &mut column {
                *c *= -value * count;
            }
            column.push(C::new(0.0, 0.0));
            let column = weigh(column);
            if self.real && value.im != 0.0 {
                columns.push(column.iter().map(|c| C::new(2.0 * c.re, 0.0)).collect());
                columns.push(column.iter().map(|c| C::new(-2.0 * c.im, 0.0)).collect());
            } else if self.real {
                columns.push(column.iter().map(|c| C::new(c.re, 0.0)).collect());
            } else {
                columns.push(column);
            }
        }
        if self.real {
            for c in &mut columns[0] {
                c.im = 0.0;
            }
        }
        columns
    }

    /// Relative changes of factor and roots as complex numbers, from the solution of the least-squares problem.
    fn complex_corrections(&self, solution: &[C], unknowns: &[Unknown]) -> Vec<C> {
        let mut parts = solution.iter().copied();
        let mut next = || parts.next().unwrap_or_default();
        let mut corrections = vec![next()];
        for (value, _) in unknowns {
            let first = next();
            corrections.push(if self.real && value.value().im != 0.0 {
                C::new(first.re, next().re)
            } else {
                first
            });
        }
        corrections
    }

    fn describe(
        &self,
        unknowns: &[Unknown],
        factor: DoubleDoubleComplex,
        steps: usize,
    ) -> Option<Fit> {
        let residual = self.residual(&expand(&self.with_conjugates(unknowns)), factor);
        let largest_error = residual.iter().map(|r| r.norm()).fold(0.0, f64::max);
        let factored = Factored::new(self.jacobian(unknowns, factor))?;
        let mut sums = vec![0.0; unknowns.len()];
        for (k, solution) in factored.pseudoinverse_columns().iter().enumerate() {
            let relative = self.coefficients[k].norm() / self.hull[k];
            let changes = self.complex_corrections(solution, unknowns);
            for (sum, change) in sums.iter_mut().zip(&changes[1..]) {
                *sum += relative * change.norm();
            }
        }
        let mut roots = Vec::with_capacity(2 * unknowns.len());
        let mut conditions = Vec::with_capacity(2 * unknowns.len());
        for (&(value, multiplicity), &condition) in unknowns.iter().zip(&sums) {
            let value = scale_by_power(value.value(), self.exponent);
            roots.push(Multiple { value, multiplicity });
            conditions.push(condition);
            if self.real && value.im != 0.0 {
                roots.push(Multiple { value: value.conj(), multiplicity });
                conditions.push(condition);
            }
        }
        Some(Fit { roots, conditions, largest_error, steps })
    }
}

fn in_leja_order(roots: &[Unknown]) -> Vec<Unknown> {
    let values: Vec<C> = roots.iter().map(|(z, _)| z.value()).collect();
    leja_order(&values).into_iter().map(|k| roots[k]).collect()
}

/// Ascending coefficients of the monic product in doubled precision; each round takes every root that is left once.
fn expand(roots: &[Unknown]) -> Vec<DoubleDoubleComplex> {
    let mut coefficients = vec![DoubleDoubleComplex::ONE];
    let rounds = roots.iter().map(|&(_, multiplicity)| multiplicity).max().unwrap_or(0);
    for round in 0..rounds {
        for &(root, _) in roots.iter().filter(|(_, multiplicity)| *multiplicity > round) {
            coefficients.push(DoubleDoubleComplex::ONE);
            for k in (1..coefficients.len() - 1).rev() {
                coefficients[k] = coefficients[k - 1] - root * coefficients[k];
            }
            coefficients[0] = -(root * coefficients[0]);
        }
    }
    coefficients
}

/// Ascending coefficients of the product of `x - z`, times a factor.
fn product(roots: impl Iterator<Item = C>, factor: C) -> Vec<C> {
    times(&[factor], roots)
}

fn times(start: &[C], roots: impl Iterator<Item = C>) -> Vec<C> {
    let mut coefficients = start.to_vec();
    for root in roots {
        let top = coefficients.last().copied().unwrap_or_default();
        coefficients.push(top);
        for k in (1..coefficients.len() - 1).rev() {
            coefficients[k] = coefficients[k - 1] - root * coefficients[k];
        }
        coefficients[0] = -root * coefficients[0];
    }
    coefficients
}
