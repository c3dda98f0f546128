//! One run: both methods with and without the quiet record, the yardsticks, and what the records
//! allow at best.

use reconstruct::likelihood::{AutoregressionOrder, NoiseSpectrum, VectorAutoregression};
use reconstruct::{Doubt, Method, NoiseModel, Reconstruction, Record, likelihood};
use serde::{Deserialize, Serialize};

use super::flights::{SAMPLES, Simulator};
use super::inputs_known;
use super::kind::Kind;
use crate::TaskError;
use crate::shared::matching::{eigenvalue_errors, named, reconstruction_errors};
use crate::shared::methods::{ORDER, apply};
use crate::shared::modes::{PerMode, TrueModes};
use crate::study::fit::{self, JudgedFit, search};

const PART: &str = "study";

/// The longest autoregression that the default options try for a record of this length.
const LONGEST: AutoregressionOrder = AutoregressionOrder::Akaike { largest: 24 };

/// What became of one flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outcome {
    /// Without the quiet record.
    pub(super) alone: Both,
    /// With the quiet record.
    pub(super) quiet: Both,
    /// Maximum likelihood with the quiet record, from the true system: what a perfect start would
    /// give.
    pub(super) true_start: Option<Likelihood>,
    /// Maximum likelihood with the true spectrum, from the true system: what a quiet record without
    /// an end would give.
    pub(super) true_spectrum: Option<Likelihood>,
    /// Errors of the regression that knows the controls.
    pub(super) inputs_known: Option<PerMode>,
    /// The information bound for unknown controls and known spectrum: variance of each s, of real
    /// and imaginary part together.
    pub(super) bound: PerMode,
    /// Lags of the autoregression fitted to the quiet record.
    pub(super) lags: usize,
    /// How much lower the sum of squares of the fit with the quiet record is when the search starts
    /// from the true system.
    pub(super) missed: Option<f64>,
}

/// What both methods make of the same records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Both {
    pub(super) subspace: Option<Subspace>,
    pub(super) likelihood: Option<Likelihood>,
}

/// What the intersection of signal subspaces gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Subspace {
    pub(super) errors: PerMode,
    /// The kinds of doubts that the result carries, each once.
    pub(super) doubts: Vec<String>,
}

/// What maximum likelihood gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Likelihood {
    /// Chi-squared is under the spectrum that the fit used, or without one under the true levels of
    /// the sensors' noise.
    #[serde(flatten)]
    pub(super) fit: JudgedFit,
    /// The kinds of doubts that the result carries, each once.
    pub(super) doubts: Vec<String>,
}

/// Flies and judges.
pub(super) fn run(simulator: &Simulator, kind: Kind, seed: u64) -> Result<Outcome, TaskError> {
    let flight = simulator.fly(kind, seed)?;
    let (truth, system) = (simulator.aircraft.modes, simulator.aircraft.shared_model());
    let fault = TaskError::computation(PART);
    let records = &flight.records;
    let fitted = VectorAutoregression::fit(&flight.quiet, LONGEST).map_err(fault)?;
    let estimated = fitted.spectrum(SAMPLES).map_err(TaskError::computation(PART))?;
    let quiet = NoiseModel::Quiet(flight.quiet.clone());

    let (mut alone, alone_fit) = both(records, NoiseModel::Estimated, &truth);
    let (quiet, quiet_fit) = both(records, quiet, &truth);
    let white = likelihood::Noise::Given(flight.levels.clone());
    if let (Some(judged), Some(fit)) = (&mut alone.likelihood, alone_fit) {
        let under_noise = search(records, &fit.model, white, None, 0)?;
        judged.fit.chi_squared = under_noise.chi_squared.per_degree_of_freedom();
    }
    let steps = likelihood::Options::default().search.max_steps;
    let from_truth = search(records, &system, spectra(&estimated), None, steps)?;
    let at_best = search(records, &system, spectra(&flight.spectrum), None, steps)?;
    let under_truth = search(records, &system, spectra(&flight.spectrum), None, 0)?;
    let eigenvalues = inputs_known::eigenvalues(&flight, system.period);
    Ok(Outcome {
        true_start: judged(&from_truth, &[], &truth),
        true_spectrum: judged(&at_best, &[], &truth),
        inputs_known: eigenvalues.and_then(|found| eigenvalue_errors(&found, &truth)),
        bound: fit::bound(&under_truth, &truth)?,
        lags: fitted.coefficients().len(),
        missed: quiet_fit.map(|fit| fit.chi_squared.value - from_truth.chi_squared.value),
        alone,
        quiet,
    })
}

/// What both methods make of the records, and the fit of the second.
fn both(
    records: &[Record],
    noise: NoiseModel,
    truth: &TrueModes,
) -> (Both, Option<likelihood::Fit>) {
    let apply = |method| apply(records, method, noise.clone(), ORDER);
    let subspace = apply(Method::Subspace).and_then(|found| closed_form(&found, truth));
    let Some(found) = apply(Method::MaximumLikelihood) else {
        return (Both { subspace, likelihood: None }, None);
    };
    let likelihood = found.fit().and_then(|fit| judged(fit, &found.doubts, truth));
    (Both { subspace, likelihood }, found.fit().cloned())
}

fn closed_form(found: &Reconstruction, truth: &TrueModes) -> Option<Subspace> {
    let errors = reconstruction_errors(found, truth)?;
    Some(Subspace { errors, doubts: doubt_names(&found.doubts) })
}

fn judged(fit: &likelihood::Fit, doubts: &[Doubt], truth: &TrueModes) -> Option<Likelihood> {
    let modes = named(fit, truth)?;
    Some(Likelihood { fit: JudgedFit::new(fit, &modes, truth), doubts: doubt_names(doubts) })
}

/// The names of the doubts' variants, each once: what is left of `Subspace(NoiseNotWhite { record:
/// .. })` is `NoiseNotWhite`.
fn doubt_names(doubts: &[Doubt]) -> Vec<String> {
    let name = |doubt: &Doubt| {
        let text = match doubt {
            Doubt::Subspace(doubt) => format!("{doubt:?}"),
            Doubt::Likelihood(doubt) => format!("{doubt:?}"),
            Doubt::Paper(doubt) => format!("{doubt:?}"),
            other => format!("{other:?}"),
        };
        text.chars().take_while(char::is_ascii_alphanumeric).collect()
    };
    let mut names: Vec<String> = doubts.iter().map(name).collect();
    names.sort();
    names.dedup();
    names
}

fn spectra(spectrum: &NoiseSpectrum) -> likelihood::Noise {
    likelihood::Noise::Spectra(vec![spectrum.clone(); 2])
}

#[cfg(test)]
mod tests;
