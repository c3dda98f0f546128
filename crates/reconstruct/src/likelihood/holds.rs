//! Which hold: the search with the excitation held between samples, and with one that moves on straight where that is more likely.

use super::climb::{ascend, settled};
use super::conclusion::model;
use super::evaluation::Problem;
use super::options::{Hold, LikelihoodOptions};
use super::search::{Found, STEPS_OF_A_MOVE, UPDATES_OF_A_MOVE, search};
use crate::SharedModel;

/// An objective lower by so much says that the excitation is not held, a likelihood ratio of e^3; then its tops are searched from all starts.
const DECISIVE: f64 = 6.0;

/// Searches under the hold that was asked for, or under the more likely one; the problem is left with it. With it comes what the other one's
/// objective lies above, where that was compared.
pub(super) fn search_over_holds(
    problem: &mut Problem,
    starts: &[SharedModel],
    units: &[f64],
    residuals: f64,
    options: &LikelihoodOptions,
) -> Option<(Found, Option<f64>)> {
    let held = search(problem, starts, units, residuals, options)?;
    if options.hold.is_some() || options.largest_steps == 0 {
        return Some((held, None));
    }
    problem.layout.hold = Hold::FirstOrder;
    let before = held.climb.objective;
    // A few steps tell whether it leads lower.
    let few = LikelihoodOptions {
        largest_steps: options.largest_steps.min(STEPS_OF_A_MOVE),
        largest_updates: options.largest_updates.min(UPDATES_OF_A_MOVE),
        ..options.clone()
    };
    let variances = &held.climb.variances;
    let start = settled(problem, held.climb.evaluation.system.clone(), variances);
    let mut replaced = vec![false; problem.layout.records];
    let straight =
        ascend(problem, start, variances.clone(), residuals, &few, Some(before), &mut replaced);
    let gain = before - straight.objective;
    if gain.is_nan() || gain <= 0.0 {
        problem.layout.hold = Hold::ZeroOrder;
        return Some((held, (!gain.is_nan()).then_some(-gain)));
    }
    if gain <= DECISIVE {
        return Some((Found { climb: straight, ..held }, Some(gain)));
    }
    let own = model(&straight.evaluation.system, units, &problem.layout, starts[0].period);
    let all: Vec<SharedModel> = starts.iter().cloned().chain([own]).collect();
    let mut found = search(problem, &all, units, residuals, options)?;
    found.reports.truncate(starts.len());
    if found.best_start == starts.len() {
        found.best_start = held.best_start;
    }
    let evidence = before - found.climb.objective;
    Some((found, Some(evidence)))
}

#[cfg(test)]
mod tests;
