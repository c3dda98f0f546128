//! How far the eigenvalues of one reconstruction are off, in 1/s and in deviations that it states.

use nalgebra::Vector2;
use num_complex::Complex;
use reconstruct::{ComplexEstimate, LikelihoodFit, ModeEstimate, Reconstruction};

use super::matching::{apart, assigned};
use super::modes::{PerMode, TrueModes};

/// Stands for an infinite score, which JSON does not know: a real eigenvalue has taken the Dutch roll's place, and its imaginary part has no
/// deviation.
pub(crate) const LOST: f64 = 1e100;

/// Errors of a reconstruction of any method; `None` where it has too few eigenvalues.
pub(crate) fn reconstruction_errors(found: &Reconstruction, truth: &TrueModes) -> Option<PerMode> {
    let values: Vec<Complex<f64>> = found.modes.iter().map(|found| found.mode.eigenvalue).collect();
    eigenvalue_errors(&values, truth)
}

/// Errors of eigenvalues, of which a complex pair may be given once or as both.
pub(crate) fn eigenvalue_errors(values: &[Complex<f64>], truth: &TrueModes) -> Option<PerMode> {
    let upper: Vec<_> = values.iter().copied().filter(|s| s.im >= 0.0).collect();
    let places = with_conjugates(&upper, truth)?;
    Some(errors(&places, truth))
}

/// The eigenvalues for spiral, roll, Dutch roll. A pair may stand for two real modes that the method could not tell apart.
fn with_conjugates(values: &[Complex<f64>], truth: &TrueModes) -> Option<[Complex<f64>; 3]> {
    let all: Vec<_> = values.iter().flat_map(|s| both(*s)).collect();
    assigned(&all, truth).map(|places| places.map(|place| all[place]))
}

fn both(s: Complex<f64>) -> Vec<Complex<f64>> {
    if s.im.abs() > 0.0 { vec![s, s.conj()] } else { vec![s] }
}

/// Distances |s - true s| in 1/s, of s for spiral, roll, Dutch roll.
pub(crate) fn errors(found: &[Complex<f64>; 3], truth: &TrueModes) -> PerMode {
    let truth = truth.list();
    [0, 1, 2].map(|mode| apart(found[mode], truth[mode]))
}

/// The estimates for spiral, roll, Dutch roll.
pub(crate) fn named(fit: &LikelihoodFit, truth: &TrueModes) -> Option<[ModeEstimate; 3]> {
    let (mut values, mut owners) = (Vec::new(), Vec::new());
    for mode in &fit.modes {
        for s in both(mode.continuous.value) {
            values.push(s);
            owners.push(mode);
        }
    }
    assigned(&values, truth).map(|places| places.map(|place| owners[place].clone()))
}

/// Errors over their own deviations: spiral, roll, Dutch roll's real part, its imaginary part.
pub(crate) fn scores(modes: &[ModeEstimate; 3], truth: &TrueModes) -> [f64; 4] {
    let [spiral, roll, dutch_roll] = modes.each_ref().map(|mode| &mode.continuous);
    let real = |estimate: &ComplexEstimate, truth: Complex<f64>| {
        (estimate.value.re - truth.re) / estimate.real_deviation()
    };
    [
        real(spiral, truth.spiral),
        real(roll, truth.roll),
        real(dutch_roll, truth.dutch_roll),
        (dutch_roll.value.im.abs() - truth.dutch_roll.im) / dutch_roll.imaginary_deviation(),
    ]
    .map(|z| if z.is_finite() { z } else { LOST })
}

/// Whether the 95 % intervals of the real modes and the 95 % ellipse of the Dutch roll hold the truth.
pub(crate) fn covered(modes: &[ModeEstimate; 3], truth: &TrueModes) -> [bool; 3] {
    let [spiral, roll, dutch_roll] = modes.each_ref().map(|mode| &mode.continuous);
    [
        holds_real(spiral, truth.spiral),
        holds_real(roll, truth.roll),
        holds_in_ellipse(dutch_roll, truth.dutch_roll),
    ]
}

/// Whether the 95 % interval of a real mode holds the truth. A pair in its place does not.
fn holds_real(estimate: &ComplexEstimate, truth: Complex<f64>) -> bool {
    // 1.96 deviations hold 95 % of a normal distribution.
    const NORMAL_95: f64 = 1.959_963_984_540_054;
    estimate.value.im.abs() <= 0.0
        && (estimate.value.re - truth.re).abs() <= NORMAL_95 * estimate.real_deviation()
}

/// Whether the 95 % ellipse holds the truth.
pub(crate) fn holds_in_ellipse(estimate: &ComplexEstimate, truth: Complex<f64>) -> bool {
    // -2 ln 0.05: chi-squared with two degrees of freedom.
    const CHI_SQUARED_95: f64 = 5.991_464_547_107_98;
    let off = Vector2::new(estimate.value.re - truth.re, estimate.value.im - truth.im);
    let inverse = estimate.covariance.try_inverse();
    inverse.is_some_and(|inverse| off.dot(&(inverse * off)) <= CHI_SQUARED_95)
}

#[cfg(test)]
mod tests;
