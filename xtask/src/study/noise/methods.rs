//! One run: the methods on one pair of records, and what the records allow at best.

use lti::{Transmissibility, z_to_s};
use poly::Poly;
use reconstruct::{
    Directions, Hold, Identification, LikelihoodFit, LikelihoodNoise, LikelihoodOptions, Method,
    ModeEstimate, Options, OrderChoice, Reconstruction, SearchStatus, SharedModel,
    difference_zeros, maximise, profile_intervals, reconstruct,
};

use super::case::Case;
use super::flights::{Pair, Simulator};
use super::outcome::{Likelihood, Outcome};
use crate::TaskError;
use crate::study::matching::nearest;
use crate::study::modes::{PerMode, TrueModes};
use crate::study::runs::Kept;
use crate::study::verdict::{covered, errors, named, reconstruction_errors, scores};

const PART: &str = "study";
/// The aircraft has four states. They are given, so that errors of all runs can be compared; what the gap says is counted apart.
const ORDER: OrderChoice = OrderChoice::Fixed(4);

/// What a method makes of records; `None` where it gives nothing.
pub(crate) fn apply(pair: &Pair, method: Method, order: OrderChoice) -> Option<Reconstruction> {
    let mut options = Options::default();
    options.method = method;
    options.order = order;
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
        .map(|(fit, modes)| judged(simulator, &pair, &fit, &modes))
        .transpose()?;
    Ok(Outcome {
        edition: Outcome::EDITION,
        case: *case,
        as_printed: printed_errors(&pair, &truth),
        subspace: subspace.and_then(|found| reconstruction_errors(&found, &truth)),
        order_found: gap.and_then(|found| found.order).map(|order| order.order),
        likelihood,
        bound: bound(simulator, &pair)?,
    })
}

fn judged(
    simulator: &Simulator,
    pair: &Pair,
    fit: &LikelihoodFit,
    modes: &[ModeEstimate; 3],
) -> Result<Likelihood, TaskError> {
    let checked = evaluated(pair, &fit.model, fit.hold)?;
    let truth = simulator.modes();
    Ok(Likelihood {
        errors: errors(&modes.each_ref().map(|mode| mode.continuous.value), &truth),
        scores: scores(modes, &truth),
        covered: covered_by_likelihood(pair, fit, modes, &truth)?,
        chi_squared: checked.chi_squared.per_degree_of_freedom(),
        converged: fit.search.levels_settled
            && matches!(fit.search.status, SearchStatus::Converged | SearchStatus::AtRoundingLevel),
        missed: missed(simulator, pair, fit)?,
    })
}

/// Whether the intervals of the real modes, from the likelihood itself, and the ellipse of the Dutch roll hold the truth.
fn covered_by_likelihood(
    pair: &Pair,
    fit: &LikelihoodFit,
    modes: &[ModeEstimate; 3],
    truth: &TrueModes,
) -> Result<[bool; 3], TaskError> {
    let intervals = profile_intervals(&pair.records, fit, &LikelihoodOptions::default())
        .map_err(TaskError::computation(PART))?;
    let mut covered = covered(modes, truth);
    let truth = truth.list();
    for (mode, covered) in covered.iter_mut().enumerate() {
        let place = fit.modes.iter().position(|other| *other == modes[mode]);
        if let Some([low, high]) = place.and_then(|place| intervals[place]) {
            *covered = (low..=high).contains(&truth[mode].re);
        }
    }
    Ok(covered)
}

/// Whether the search ended below the top that the true system leads to.
fn missed(simulator: &Simulator, pair: &Pair, fit: &LikelihoodFit) -> Result<bool, TaskError> {
    // Searches end closer to a top than this.
    const SAME_TOP: f64 = 0.1;
    let mut options = LikelihoodOptions::default();
    let levels = fit.noise_levels.iter().flatten().map(|level| level.value).collect();
    options.noise = LikelihoodNoise::Estimated { first_guess: Some(levels) };
    options.hold = Some(fit.hold);
    options.largest_moves = 0;
    let objective = |start: &SharedModel| {
        let fit = maximise(&pair.records, std::slice::from_ref(start), &options)
            .map_err(TaskError::computation(PART))?;
        Ok::<_, TaskError>(fit.starts[0].objective)
    };
    Ok(objective(&fit.model)? > objective(&simulator.truth())? + SAME_TOP)
}

/// The likelihood of a model under the true noise levels, without a step of the search.
fn evaluated(pair: &Pair, model: &SharedModel, hold: Hold) -> Result<LikelihoodFit, TaskError> {
    let mut options = LikelihoodOptions::default();
    options.noise = LikelihoodNoise::Given(pair.levels.clone());
    options.hold = Some(hold);
    options.directions = Directions::AsStarted;
    options.largest_steps = 0;
    maximise(&pair.records, std::slice::from_ref(model), &options)
        .map_err(TaskError::computation(PART))
}

/// The variances that no unbiased estimate without the inputs can go below: the covariance at the true system.
fn bound(simulator: &Simulator, pair: &Pair) -> Result<PerMode, TaskError> {
    let truth = simulator.modes();
    let fit = evaluated(pair, &simulator.truth(), Hold::ZeroOrder)?;
    let modes = named(&fit, &truth).ok_or_else(|| TaskError::Computation {
        part: PART,
        message: "the true system lacks a mode".to_owned(),
    })?;
    Ok(modes.map(|mode| mode.continuous.covariance.trace()))
}

#[cfg(test)]
mod tests;
