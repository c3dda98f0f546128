//! Zeros of the difference of two transmissibilities, evaluated in factored form.
//!
//! T_1 - T_2 vanishes where P(z) = g_1 prod (z - z_1) prod (z - p_2) equals Q(z) = g_2 prod (z - z_2) prod (z - p_1). Expanded, the coefficients of
//! P - Q are of size one while its values near z = 1, where everything crowds, are many decades smaller: rounding the coefficients alone
//! moves the paper's spiral by 1e-6. Each factor z - a is exact to rounding, so the values of P and Q are too. The roots of the expanded
//! polynomial therefore only start a Newton iteration on the factored form.

use num_complex::Complex;
use poly::{MrootsOptions, mroots};

use super::identification::Identification;
use super::theorem::TransmissibilityPair;
use crate::ReconstructError;

/// A zero of a difference, and how well it is determined.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Zero {
    /// Where it is, in the z-plane.
    pub value: Complex<f64>,
    /// |P - Q| / (|P| + |Q|) there: at rounding level after a converged iteration, but without meaning at a zero that both terms share,
    /// where it is a quotient of rounding errors.
    pub residual: f64,
    /// (|P| + |Q|) / |P' - Q'|: how far the zero moves, to first order, when either transmissibility changes there by a small relative
    /// amount, divided by that amount.
    pub condition: f64,
}

impl Zero {
    /// A zero without doubt, for comparisons with values known otherwise.
    #[must_use]
    pub fn exact(value: Complex<f64>) -> Self {
        Self { value, residual: 0.0, condition: 1.0 }
    }
}

/// The zeros of T_1 - T_2, by ascending real part, each as often as its multiplicity; conjugates are exact conjugates.
///
/// The poles of the difference are those of T_1 and those of T_2.
///
/// # Errors
///
/// [`ReconstructError::SameExcitation`] where the difference vanishes identically, up to rounding.
pub fn difference_zeros(
    first: &Identification,
    second: &Identification,
) -> Result<Vec<Zero>, ReconstructError> {
    // What is smaller than this part of its terms is the error of two fits: far above what noise-free fits have, far below a
    // coefficient that means anything.
    const VANISHING: f64 = 1e-11;
    let pair =
        TransmissibilityPair::new(first.transmissibility.clone(), second.transmissibility.clone());
    let determinant = pair.theorem_rounded(0, VANISHING)?.determinant;
    if determinant.is_zero() {
        return Err(ReconstructError::SameExcitation {
            first: first.record.clone(),
            second: second.record.clone(),
            input: first.input.clone(),
            output: first.output.clone(),
        });
    }
    let start = mroots(&determinant, &MrootsOptions::default()).map_err(|error| {
        ReconstructError::Step {
            step: "zeros of a difference of transmissibilities",
            message: error.to_string(),
        }
    })?;
    let factored = FactoredDifference {
        minuend: Product::new(first.gain, &first.zeros, &second.poles),
        subtrahend: Product::new(second.gain, &second.zeros, &first.poles),
    };
    let polished = factored.polish(&start.values());
    Ok(polished.into_iter().map(|value| factored.judge(value)).collect())
}

/// g prod (z - a), the factors in an order that keeps conjugates together.
#[derive(Debug)]
struct Product {
    gain: f64,
    roots: Vec<Complex<f64>>,
}

impl Product {
    fn new(gain: f64, zeros: &[Complex<f64>], poles: &[Complex<f64>]) -> Self {
        Self { gain, roots: zeros.iter().chain(poles).copied().collect() }
    }

    /// Value and derivative at z. The derivative is summed over products that leave one factor out, so that it is right at a root too.
    fn at(&self, z: Complex<f64>) -> (Complex<f64>, Complex<f64>) {
        let start = (Complex::new(self.gain, 0.0), Complex::new(0.0, 0.0));
        self.roots.iter().fold(start, |(value, derivative), root| {
            let factor = z - root;
            (value * factor, derivative * factor + value)
        })
    }
}

/// P - Q.
#[derive(Debug)]
struct FactoredDifference {
    minuend: Product,
    subtrahend: Product,
}

impl FactoredDifference {
    fn judge(&self, value: Complex<f64>) -> Zero {
        let ((p, dp), (q, dq)) = (self.minuend.at(value), self.subtrahend.at(value));
        let scale = p.norm() + q.norm();
        let residual = if scale > 0.0 { (p - q).norm() / scale } else { 0.0 };
        Zero { value, residual, condition: scale / (dp - dq).norm() }
    }

    /// Newton's iteration for all zeros at once, each kept from running into the others (Ehrlich and Aberth).
    ///
    /// Real starts stay real, and only the upper half of the plane is iterated. A zero stops where its step no longer shrinks, that is at
    /// rounding level. Coinciding starts (a multiple zero) stay where they are.
    fn polish(&self, starts: &[Complex<f64>]) -> Vec<Complex<f64>> {
        const SWEEPS: usize = 30;
        let mut zeros = starts.to_vec();
        let mut last_step = vec![f64::INFINITY; zeros.len()];
        for _ in 0..SWEEPS {
            for index in 0..zeros.len() {
                let z = zeros[index];
                if z.im < 0.0 || last_step[index] <= 0.0 {
                    continue;
                }
                let step = self.step(index, &zeros);
                // Closer to the start than this only rounding errors move a zero; farther away something else went wrong.
                if step.is_finite() && step.norm() < 0.5 * last_step[index] {
                    zeros[index] = z - step;
                    last_step[index] = step.norm();
                    mirror(&mut zeros, index, z);
                } else {
                    last_step[index] = 0.0;
                }
            }
        }
        zeros
    }

    fn step(&self, index: usize, zeros: &[Complex<f64>]) -> Complex<f64> {
        let z = zeros[index];
        let ((p, dp), (q, dq)) = (self.minuend.at(z), self.subtrahend.at(z));
        let newton = (p - q) / (dp - dq);
        let others = zeros.iter().enumerate().filter(|(other, _)| *other != index);
        let repulsion: Complex<f64> = others.map(|(_, zero)| (z - zero).inv()).sum();
        let step = newton / (Complex::new(1.0, 0.0) - newton * repulsion);
        if z.im > 0.0 { step } else { Complex::new(step.re, 0.0) }
    }
}

/// Moves the conjugate of the zero that was at `before` along with it.
fn mirror(zeros: &mut [Complex<f64>], index: usize, before: Complex<f64>) {
    if before.im > 0.0 {
        let conjugate = zeros[index].conj();
        if let Some(partner) = zeros.iter_mut().find(|zero| **zero == before.conj()) {
            *partner = conjugate;
        }
    }
}

#[cfg(test)]
mod tests;
