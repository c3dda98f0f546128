//! All roots taken as simple: approximation, symmetry, a last Newton step, condition and residual.

use super::conjugate::symmetrize;
use super::multiset::{Mroots, MrootsMethod, Root};
use crate::PolyError;
use crate::aberth::{Precision, ScaledPoly, scale_by_power};
use num_complex::Complex;

/// Newton steps after the iteration; each at least halves the error or is not taken.
const POLISH_STEPS: usize = 3;

/// The roots of a polynomial whose first and last coefficients are nonzero.
pub(crate) fn simple_roots(
    p: &mut ScaledPoly,
    real: bool,
    maximum_iterations: usize,
) -> Result<Mroots, PolyError> {
    let approximations = p.approximate(maximum_iterations)?;
    let mut values = approximations.roots;
    if real {
        values = symmetrize(&values);
    }
    let values: Vec<Complex<f64>> = values.into_iter().map(|z| polish(p, z, real)).collect();
    let roots: Vec<Root> = values.iter().map(|&z| describe(p, z)).collect();
    Ok(Mroots {
        roots,
        method: MrootsMethod::Simple,
        backward_error: 0.0,
        iterations: approximations.iterations,
        converged: approximations.converged,
        vanished_leading: 0,
    })
}

/// Newton steps in doubled precision as long as they make `|p|` smaller.
///
/// Conjugates are treated alike: the arithmetic is symmetric. A real root of a real polynomial stays real.
fn polish(p: &mut ScaledPoly, z: Complex<f64>, real: bool) -> Complex<f64> {
    let exponent = ScaledPoly::exponent(z);
    let mut y = scale_by_power(z, -exponent);
    let mut at = p.evaluate(y, exponent, Precision::Doubled);
    for _ in 0..POLISH_STEPS {
        let mut correction = at.value / at.derivative;
        if real && z.im == 0.0 {
            correction.im = 0.0;
        }
        let moved = y - correction;
        let small = correction.norm() <= 1e-3 * y.norm();
        if !small || moved == y {
            break;
        }
        let there = p.evaluate(moved, exponent, Precision::Doubled);
        if there.value.norm() >= at.value.norm() {
            break;
        }
        y = moved;
        at = there;
    }
    scale_by_power(y, exponent)
}

/// Residual, condition and error estimate of a simple root.
pub(crate) fn describe(p: &mut ScaledPoly, z: Complex<f64>) -> Root {
    let exponent = ScaledPoly::exponent(z);
    let y = scale_by_power(z, -exponent);
    let at = p.evaluate(y, exponent, Precision::Doubled);
    let degree = p.degree() as f64;
    let slope = at.derivative.norm();
    let radius = degree * (at.value.norm() + at.bound) / slope;
    Root {
        value: z,
        multiplicity: 1,
        residual: at.value.norm() / at.terms,
        condition: at.terms / (y.norm() * slope),
        error_estimate: scale_by_power(Complex::new(radius, 0.0), exponent).re,
    }
}
