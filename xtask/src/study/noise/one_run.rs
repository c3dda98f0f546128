//! One run: the methods on one pair of records, and what the records allow at best.

use reconstruct::likelihood::{Hold, profile_intervals};
use reconstruct::{Method, NoiseModel, Options, SharedModel, likelihood};
use serde::{Deserialize, Serialize};

use super::kind::Kind;
use crate::TaskError;
use crate::shared::matching::reconstruction_errors;
use crate::shared::methods::{ORDER, apply, most_likely, paper_errors};
use crate::shared::modes::PerMode;
use crate::shared::noisy_flights::{Pair, Simulator};
use crate::study::fit::{self, JudgedFit, search};

const PART: &str = "study";

/// What became of one pair of records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outcome {
    /// Errors |s - true s| in 1/s of the paper's method; `None` where it gives nothing.
    pub(super) as_printed: Option<PerMode>,
    /// The same of the intersection of signal subspaces.
    pub(super) subspace: Option<PerMode>,
    /// The number of states that the subspaces show.
    pub(super) order_found: Option<usize>,
    pub(super) likelihood: Option<Likelihood>,
    /// The information bound: variance of each s, of real and imaginary part together.
    pub(super) bound: PerMode,
}

/// What maximum likelihood gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Likelihood {
    /// Intervals of spiral and roll are those of the likelihood itself; chi-squared is under the
    /// true noise levels.
    #[serde(flatten)]
    pub(super) fit: JudgedFit,
    /// Whether a search from the true system ended at a higher likelihood.
    pub(super) missed: bool,
}

/// Flies and judges.
pub(super) fn run(simulator: &Simulator, kind: Kind, seed: u64) -> Result<Outcome, TaskError> {
    let pair = simulator.fly(kind.excitation, f64::from(kind.signal_to_noise), seed)?;
    let truth = simulator.aircraft.modes;
    let subspaces = |order| apply(&pair.records, Method::Subspace, NoiseModel::Estimated, order);
    let subspace = subspaces(ORDER);
    let gap = subspaces(Options::default().order);
    let likelihood = most_likely(&pair.records, &truth)
        .map(|(fit, modes)| judged(simulator, &pair, &fit, &modes))
        .transpose()?;
    Ok(Outcome {
        as_printed: paper_errors(&pair.records, &truth),
        subspace: subspace.and_then(|found| reconstruction_errors(&found, &truth)),
        order_found: gap.and_then(|found| found.order().map(|order| order.order)),
        likelihood,
        bound: bound(simulator, &pair)?,
    })
}

/// What a fit is worth.
fn judged(
    simulator: &Simulator,
    pair: &Pair,
    fit: &likelihood::Fit,
    modes: &[likelihood::Mode; 3],
) -> Result<Likelihood, TaskError> {
    let truth = simulator.aircraft.modes;
    let mut judged = JudgedFit::new(fit, modes, &truth);
    let under_truth = evaluated(pair, &fit.model, fit.hold)?;
    judged.chi_squared = under_truth.chi_squared.per_degree_of_freedom();
    // The intervals of the real modes from the likelihood itself, where they have an end.
    let intervals = profile_intervals(&pair.records, fit).map_err(TaskError::computation(PART))?;
    for ((mode, covered), truth) in modes.iter().zip(&mut judged.covered).zip(truth.list()) {
        let place = fit.modes.iter().position(|other| other == mode);
        if let Some([low, high]) = place.and_then(|place| intervals[place]) {
            *covered = (low..=high).contains(&truth.re);
        }
    }
    Ok(Likelihood { fit: judged, missed: missed(simulator, pair, fit)? })
}

/// Whether the search ended in a worse local optimum than the one that the true system leads to.
fn missed(simulator: &Simulator, pair: &Pair, fit: &likelihood::Fit) -> Result<bool, TaskError> {
    // Searches end closer to a local optimum than this.
    const SAME_OPTIMUM: f64 = 0.1;
    let mut options = likelihood::Options::default();
    let levels = fit.noise_levels.iter().flatten().map(|level| level.value).collect();
    options.noise = likelihood::Noise::Estimated { first_guess: Some(levels) };
    options.hold = Some(fit.hold);
    options.search.max_restarts = 0;
    let objective = |start: &SharedModel| {
        let fit = likelihood::identify(&pair.records, std::slice::from_ref(start), &options)
            .map_err(TaskError::computation(PART))?;
        Ok::<_, TaskError>(fit.starts[0].objective)
    };
    Ok(objective(&fit.model)? > objective(&simulator.aircraft.shared_model())? + SAME_OPTIMUM)
}

/// The likelihood of a model under the true noise levels, without a step of the search.
fn evaluated(pair: &Pair, model: &SharedModel, hold: Hold) -> Result<likelihood::Fit, TaskError> {
    search(&pair.records, model, likelihood::Noise::Given(pair.levels.clone()), Some(hold), 0)
}

/// The information bound: with known noise levels, for unknown inputs.
fn bound(simulator: &Simulator, pair: &Pair) -> Result<PerMode, TaskError> {
    let at_truth = evaluated(pair, &simulator.aircraft.shared_model(), Hold::ZeroOrder)?;
    fit::bound(&at_truth, &simulator.aircraft.modes)
}

#[cfg(test)]
mod tests;
