//! One run: both methods with and without the quiet record, the yardsticks, and what the records allow at best.

use reconstruct::{
    AutoregressionOrder, Directions, LikelihoodFit, LikelihoodNoise, LikelihoodOptions, Method,
    NoiseModel, NoiseSpectrum, Options, OrderChoice, Reconstruction, ReconstructionDoubt,
    SearchStatus, SharedModel, VectorAutoregression, maximise, reconstruct,
};

use super::case::Case;
use super::flights::{Flight, SAMPLES, Simulator};
use super::inputs_known;
use super::outcome::{Both, Likelihood, Outcome, Subspace};
use crate::TaskError;
use crate::study::modes::{PerMode, TrueModes};
use crate::study::runs::Kept;
use crate::study::verdict::{
    covered, eigenvalue_errors, errors, named, reconstruction_errors, scores,
};

const PART: &str = "study";
/// The aircraft has four states. They are given, so that errors of all runs can be compared.
const ORDER: OrderChoice = OrderChoice::Fixed(4);
/// The longest autoregression that the default options try for a record of this length.
const LONGEST: AutoregressionOrder = AutoregressionOrder::Akaike { largest: 24 };

pub(crate) fn run(simulator: &Simulator, case: &Case) -> Result<Outcome, TaskError> {
    let flight = simulator.fly(case)?;
    let (truth, system) = (simulator.modes(), simulator.truth());
    let fault = TaskError::computation(PART);
    let fitted = VectorAutoregression::fit(&flight.quiet, LONGEST).map_err(fault)?;
    let estimated = fitted.spectrum(SAMPLES).map_err(TaskError::computation(PART))?;
    let quiet = NoiseModel::Quiet(flight.quiet.clone());

    let (alone, alone_fit) = both(&flight, NoiseModel::Estimated, &truth);
    let (quiet, quiet_fit) = both(&flight, quiet, &truth);
    let white = LikelihoodNoise::Given(flight.levels.clone());
    let alone = Both {
        likelihood: match (alone.likelihood, alone_fit) {
            (Some(judged), Some(fit)) => {
                let under_noise = search(&flight, &fit.model, white, 0)?;
                let chi_squared = under_noise.chi_squared.per_degree_of_freedom();
                Some(Likelihood { chi_squared, ..judged })
            }
            _ => None,
        },
        ..alone
    };
    let steps = LikelihoodOptions::default().largest_steps;
    let from_truth = search(&flight, &system, spectra(&estimated), steps)?;
    let at_best = search(&flight, &system, spectra(&flight.spectrum), steps)?;
    let eigenvalues = inputs_known::eigenvalues(&flight, system.period);
    Ok(Outcome {
        edition: Outcome::EDITION,
        case: *case,
        true_start: judged(&from_truth, &[], &truth),
        true_spectrum: judged(&at_best, &[], &truth),
        inputs_known: eigenvalues.and_then(|found| eigenvalue_errors(&found, &truth)),
        bound: bound(&flight, &system, &truth)?,
        lags: fitted.coefficients().len(),
        missed: quiet_fit.map(|fit| fit.chi_squared.value - from_truth.chi_squared.value),
        alone,
        quiet,
    })
}

/// What both methods make of the records, and the fit of the second.
fn both(flight: &Flight, noise: NoiseModel, truth: &TrueModes) -> (Both, Option<LikelihoodFit>) {
    let apply = |method| {
        let mut options = Options::default();
        options.method = method;
        options.order = ORDER;
        options.noise = noise.clone();
        reconstruct(&flight.records, &options).ok()
    };
    let subspace = apply(Method::Subspace).and_then(|found| closed_form(&found, truth));
    let Some(found) = apply(Method::MaximumLikelihood) else {
        return (Both { subspace, likelihood: None }, None);
    };
    let likelihood = found.likelihood.as_ref().and_then(|fit| judged(fit, &found.doubts, truth));
    (Both { subspace, likelihood }, found.likelihood)
}

fn closed_form(found: &Reconstruction, truth: &TrueModes) -> Option<Subspace> {
    let errors = reconstruction_errors(found, truth)?;
    Some(Subspace { errors, doubts: kinds(&found.doubts) })
}

fn judged(
    fit: &LikelihoodFit,
    doubts: &[ReconstructionDoubt],
    truth: &TrueModes,
) -> Option<Likelihood> {
    let modes = named(fit, truth)?;
    Some(Likelihood {
        errors: errors(&modes.each_ref().map(|mode| mode.continuous.value), truth),
        scores: scores(&modes, truth),
        covered: covered(&modes, truth),
        chi_squared: fit.chi_squared.per_degree_of_freedom(),
        converged: fit.search.levels_settled
            && matches!(fit.search.status, SearchStatus::Converged | SearchStatus::AtRoundingLevel),
        doubts: kinds(doubts),
    })
}

/// The names of the doubts' variants, each once: what is left of `Subspace(NoiseNotWhite { record: .. })` is `NoiseNotWhite`.
pub(super) fn kinds(doubts: &[ReconstructionDoubt]) -> Vec<String> {
    let name = |doubt: &ReconstructionDoubt| {
        let text = match doubt {
            ReconstructionDoubt::Subspace(doubt) => format!("{doubt:?}"),
            ReconstructionDoubt::Printed(doubt) => format!("{doubt:?}"),
            other => format!("{other:?}"),
        };
        text.chars().take_while(char::is_ascii_alphanumeric).collect()
    };
    let mut names: Vec<String> = doubts.iter().map(name).collect();
    names.sort();
    names.dedup();
    names
}

fn spectra(spectrum: &NoiseSpectrum) -> LikelihoodNoise {
    LikelihoodNoise::Spectra(vec![spectrum.clone(); 2])
}

/// The likelihood from one start, which with no steps is the likelihood at the start.
fn search(
    flight: &Flight,
    start: &SharedModel,
    noise: LikelihoodNoise,
    largest_steps: usize,
) -> Result<LikelihoodFit, TaskError> {
    let mut options = LikelihoodOptions::default();
    options.noise = noise;
    options.directions = Directions::AsStarted;
    options.largest_steps = largest_steps;
    maximise(&flight.records, std::slice::from_ref(start), &options)
        .map_err(TaskError::computation(PART))
}

/// The variances that no unbiased estimate without the controls can go below: the covariance at the true system under the true spectrum.
fn bound(flight: &Flight, system: &SharedModel, truth: &TrueModes) -> Result<PerMode, TaskError> {
    let fit = search(flight, system, spectra(&flight.spectrum), 0)?;
    let modes = named(&fit, truth)
        .ok_or_else(|| TaskError::computation(PART)("the true system lacks a mode"))?;
    Ok(modes.map(|mode| mode.continuous.covariance.trace()))
}

#[cfg(test)]
mod tests;
