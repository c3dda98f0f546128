//! The problem of a fit that is finished, for what is asked of it afterwards.

use realfft::RealFftPlanner;

use super::climb::{scaled, settled};
use super::evaluation::{Evaluation, Problem};
use super::options::{LikelihoodNoise, LikelihoodOptions};
use super::spectrum::transform;
use super::{LikelihoodFit, noise_levels, validation};
use crate::{ReconstructError, Record};

/// A fit's problem with the noise as the fit knows it, in sensors of unit noise.
pub(super) struct Finished {
    pub(super) problem: Problem,
    /// At the fitted system.
    pub(super) evaluation: Evaluation,
    /// The unit of each scaled sensor.
    pub(super) units: Vec<f64>,
}

pub(super) fn finished(
    records: &[Record],
    fit: &LikelihoodFit,
    options: &LikelihoodOptions,
    planner: &mut RealFftPlanner<f64>,
) -> Result<Finished, ReconstructError> {
    let known = with_known_noise(fit, options);
    let layout = validation::check(records, std::slice::from_ref(&fit.model), &known)?;
    let units = noise_levels::units(records, &known);
    let spectra = records
        .iter()
        .enumerate()
        .map(|(index, record)| transform(record, index, &units, &known, planner))
        .collect::<Result<Vec<_>, _>>()?;
    let problem = Problem { layout, spectra, threads: options.threads };
    let system = scaled(&fit.model, &units, &problem.layout);
    let evaluation = settled(&problem, system, &vec![1.0; units.len()]);
    Ok(Finished { problem, evaluation, units })
}

/// The options of a fit with noise levels and hold as it knows them.
fn with_known_noise(fit: &LikelihoodFit, options: &LikelihoodOptions) -> LikelihoodOptions {
    let mut known = LikelihoodOptions { hold: Some(fit.hold), ..options.clone() };
    if let (LikelihoodNoise::Estimated { .. }, Some(levels)) = (&options.noise, &fit.noise_levels) {
        known.noise = LikelihoodNoise::Given(levels.iter().map(|level| level.value).collect());
    }
    known
}
