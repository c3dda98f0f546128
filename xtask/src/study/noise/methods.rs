//! One run: the methods on one pair of records, and what the records allow at best.

use lti::{Transmissibility, z_to_s};
use nalgebra::Vector2;
use num_complex::Complex;
use poly::Poly;
use reconstruct::{
    ComplexEstimate, Directions, Identification, LikelihoodFit, LikelihoodNoise, LikelihoodOptions,
    Method, ModeEstimate, Options, OrderChoice, Reconstruction, SearchStatus, SharedModel,
    difference_zeros, maximise, reconstruct,
};

use super::case::Case;
use super::flights::{Pair, Simulator, TrueModes};
use super::outcome::{EDITION, LOST, Likelihood, Outcome, PerMode};
use crate::TaskError;
use crate::study::matching::{apart, assigned, nearest};

const PART: &str = "study";
/// The aircraft has four states. They are given, so that errors of all runs can be compared; what the gap says is counted apart.
const ORDER: OrderChoice = OrderChoice::Fixed(4);

/// What a method makes of records; `None` where it gives nothing.
pub(crate) fn apply(pair: &Pair, method: Method, order: OrderChoice) -> Option<Reconstruction> {
    let mut options = Options::default();
    options.method = method;
    options.order = order;
    options.feedthrough_sensors.clone_from(&pair.direct);
    reconstruct(&pair.records, &options).ok()
}

/// Errors of the printed method: for each mode the closest of all zeros of all differences, of the composite models as they are fitted and of what
/// their realization keeps above the noise of the fit. With noise the differences share no zero; this gives the method what it cannot know,
/// which of the zeros is the right one.
pub(crate) fn printed_errors(pair: &Pair, truth: &TrueModes) -> Option<PerMode> {
    let printed = apply(pair, Method::AsPrinted, ORDER)?.printed?;
    let realised = printed.differences.iter().flat_map(|difference| difference.zeros.clone());
    let (first, second) = printed.identifications.split_at(printed.identifications.len() / 2);
    let fitted = first.iter().zip(second).filter_map(|(first, second)| {
        difference_zeros(&unrealised(first)?, &unrealised(second)?).ok()
    });
    let found: Vec<_> = realised
        .chain(fitted.flatten())
        .filter_map(|zero| z_to_s(zero.value, printed.period).ok())
        .collect();
    nearest(&found, truth)
}

/// The transmissibility as the composite model has it, without a realization of its FIR factor: sum of H_i z^(d + r - i) over D, where the
/// power of z that all records share is left out.
fn unrealised(found: &Identification) -> Option<Identification> {
    let numerator = Poly::from_descending(&found.fit.model.markov_parameters());
    let denominator = Poly::new(found.fit.model.denominator());
    let mut unrealised = found.clone();
    unrealised.transmissibility =
        Transmissibility::from_polynomials(numerator, denominator).ok()?;
    Some(unrealised)
}

/// The modes of maximum likelihood with four states: spiral, roll, Dutch roll.
pub(crate) fn most_likely(
    pair: &Pair,
    truth: &TrueModes,
) -> Option<(LikelihoodFit, [ModeEstimate; 3])> {
    let fit = apply(pair, Method::MaximumLikelihood, ORDER)?.likelihood?;
    let modes = named(&fit, truth)?;
    Some((fit, modes))
}

pub(crate) fn run(simulator: &Simulator, case: &Case) -> Result<Outcome, TaskError> {
    let pair = simulator.fly(case)?;
    let truth = simulator.modes();
    let subspace = apply(&pair, Method::Subspace, ORDER);
    let gap = apply(&pair, Method::Subspace, Options::default().order);
    let likelihood = most_likely(&pair, &truth)
        .map(|(fit, modes)| judged(&pair, &truth, &fit, &modes))
        .transpose()?;
    Ok(Outcome {
        edition: EDITION,
        case: *case,
        as_printed: printed_errors(&pair, &truth),
        subspace: subspace.and_then(|found| subspace_errors(&found, &truth)),
        order_found: gap.and_then(|found| found.order).map(|order| order.order),
        likelihood,
        bound: bound(simulator, &pair)?,
    })
}

fn subspace_errors(found: &Reconstruction, truth: &TrueModes) -> Option<PerMode> {
    let values: Vec<Complex<f64>> = found.modes.iter().map(|found| found.mode.eigenvalue).collect();
    let places = with_conjugates(&values, truth)?;
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

fn errors(found: &[Complex<f64>; 3], truth: &TrueModes) -> PerMode {
    let truth = truth.list();
    [0, 1, 2].map(|mode| apart(found[mode], truth[mode]))
}

/// The estimates for spiral, roll, Dutch roll.
fn named(fit: &LikelihoodFit, truth: &TrueModes) -> Option<[ModeEstimate; 3]> {
    let (mut values, mut owners) = (Vec::new(), Vec::new());
    for mode in &fit.modes {
        for s in both(mode.continuous.value) {
            values.push(s);
            owners.push(mode);
        }
    }
    assigned(&values, truth).map(|places| places.map(|place| owners[place].clone()))
}

fn judged(
    pair: &Pair,
    truth: &TrueModes,
    fit: &LikelihoodFit,
    modes: &[ModeEstimate; 3],
) -> Result<Likelihood, TaskError> {
    let [spiral, roll, dutch_roll] = modes.each_ref().map(|mode| &mode.continuous);
    let real = |estimate: &ComplexEstimate, truth: Complex<f64>| {
        (estimate.value.re - truth.re) / estimate.real_deviation()
    };
    let scores = [
        real(spiral, truth.spiral),
        real(roll, truth.roll),
        real(dutch_roll, truth.dutch_roll),
        (dutch_roll.value.im.abs() - truth.dutch_roll.im) / dutch_roll.imaginary_deviation(),
    ];
    let checked = evaluated(pair, &fit.model)?;
    Ok(Likelihood {
        errors: errors(&[spiral.value, roll.value, dutch_roll.value], truth),
        scores: scores.map(|z| if z.is_finite() { z } else { LOST }),
        covered: [
            holds_real(spiral, truth.spiral),
            holds_real(roll, truth.roll),
            holds_in_ellipse(dutch_roll, truth.dutch_roll),
        ],
        chi_squared: checked.chi_squared.per_degree_of_freedom(),
        converged: fit.search.levels_settled
            && matches!(fit.search.status, SearchStatus::Converged | SearchStatus::AtRoundingLevel),
    })
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

/// The likelihood of a model under the true noise levels, without a step of the search.
fn evaluated(pair: &Pair, model: &SharedModel) -> Result<LikelihoodFit, TaskError> {
    let mut options = LikelihoodOptions::default();
    options.noise = LikelihoodNoise::Given(pair.levels.clone());
    if model.feedthrough.is_some() {
        options.feedthrough_sensors.clone_from(&pair.direct);
    }
    options.directions = Directions::AsStarted;
    options.largest_steps = 0;
    maximise(&pair.records, std::slice::from_ref(model), &options)
        .map_err(TaskError::computation(PART))
}

/// The variances that no unbiased estimate without the inputs can go below: the covariance at the true system.
fn bound(simulator: &Simulator, pair: &Pair) -> Result<PerMode, TaskError> {
    let truth = simulator.modes();
    let fit = evaluated(pair, &simulator.truth())?;
    let modes = named(&fit, &truth).ok_or_else(|| TaskError::Computation {
        part: PART,
        message: "the true system lacks a mode".to_owned(),
    })?;
    Ok(modes.map(|mode| mode.continuous.covariance.trace()))
}

#[cfg(test)]
mod tests;
