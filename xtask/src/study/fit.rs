//! One fit of maximum likelihood beside the truth, and what the records allow at best.

use num_complex::Complex;
use reconstruct::likelihood::{ComplexEstimate, Hold, SearchStatus};
use reconstruct::{Record, SharedModel, likelihood};
use serde::{Deserialize, Serialize};

use crate::TaskError;
use crate::shared::matching::{errors, holds_in_ellipse, named};
use crate::shared::modes::{PerMode, TrueModes};

const PART: &str = "study";

/// Stands for an infinite score, which JSON does not know: a real eigenvalue has taken the Dutch
/// roll's place, and its imaginary part has no deviation.
pub(super) const LOST: f64 = 1e100;

/// How far off a fit is, and what it states about itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct JudgedFit {
    /// Errors |s - true s| in 1/s.
    pub(super) errors: PerMode,
    /// Error over its own deviation: spiral, roll, Dutch roll's real part, its imaginary part;
    /// [`LOST`] or more where there is no deviation.
    pub(super) scores: [f64; 4],
    /// Whether the 95 % interval (of the Dutch roll: ellipse) holds the truth.
    pub(super) covered: [bool; 3],
    /// Chi-squared per degree of freedom.
    pub(super) chi_squared: f64,
    pub(super) converged: bool,
}

impl JudgedFit {
    /// `modes` are the fit's, for spiral, roll, Dutch roll.
    pub(super) fn new(
        fit: &likelihood::Fit,
        modes: &[likelihood::Mode; 3],
        truth: &TrueModes,
    ) -> Self {
        Self {
            errors: errors(&modes.each_ref().map(|mode| mode.continuous.value), truth),
            scores: scores(modes, truth),
            covered: covered(modes, truth),
            chi_squared: fit.chi_squared.per_degree_of_freedom(),
            converged: fit.search.levels_settled
                && matches!(
                    fit.search.status,
                    SearchStatus::Converged | SearchStatus::AtRoundingLevel
                ),
        }
    }
}

/// Errors over their own deviations: spiral, roll, Dutch roll's real part, its imaginary part.
fn scores(modes: &[likelihood::Mode; 3], truth: &TrueModes) -> [f64; 4] {
    let [spiral, roll, dutch_roll] = modes.each_ref().map(|mode| &mode.continuous);
    let real = |estimate: &ComplexEstimate, truth: Complex<f64>| {
        (estimate.value.re - truth.re) / estimate.real_standard_error()
    };
    [
        real(spiral, truth.spiral),
        real(roll, truth.roll),
        real(dutch_roll, truth.dutch_roll),
        (dutch_roll.value.im.abs() - truth.dutch_roll.im) / dutch_roll.imaginary_standard_error(),
    ]
    .map(|z| if z.is_finite() { z } else { LOST })
}

/// Whether the 95 % intervals of the real modes and the 95 % ellipse of the Dutch roll hold the
/// truth.
fn covered(modes: &[likelihood::Mode; 3], truth: &TrueModes) -> [bool; 3] {
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
        && (estimate.value.re - truth.re).abs() <= NORMAL_95 * estimate.real_standard_error()
}

/// The likelihood of the records from one start, which with no steps is the likelihood at the
/// start. `hold` as in [`likelihood::Options`].
pub(super) fn search(
    records: &[Record],
    start: &SharedModel,
    noise: likelihood::Noise,
    hold: Option<Hold>,
    max_steps: usize,
) -> Result<likelihood::Fit, TaskError> {
    let mut options = likelihood::Options::default();
    options.noise = noise;
    options.hold = hold;
    options.search.directions = likelihood::InputDirections::AsStarted;
    options.search.max_steps = max_steps;
    likelihood::identify(records, std::slice::from_ref(start), &options)
        .map_err(TaskError::computation(PART))
}

/// The variances that no unbiased estimate without the inputs can go below, of real and imaginary
/// part together: the covariance at the true system, whose likelihood under the true noise this is.
pub(super) fn bound(at_truth: &likelihood::Fit, truth: &TrueModes) -> Result<PerMode, TaskError> {
    let modes = named(at_truth, truth)
        .ok_or_else(|| TaskError::computation(PART)("the true system lacks a mode"))?;
    Ok(modes.map(|mode| mode.continuous.covariance.trace()))
}
