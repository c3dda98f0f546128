//! Which hold: the search with the excitation held between samples, and with one that moves on straight where that is more likely.

use super::climb::{Climb, ascend, settled};
use super::conclusion::model;
use super::evaluation::Problem;
use super::levenberg_marquardt::SearchStatus;
use super::options::{Hold, LikelihoodOptions};
use super::search::{Found, RIVAL, STEPS_OF_A_MOVE, UPDATES_OF_A_MOVE, search};
use super::spectrum::count;
use crate::SharedModel;

/// An objective lower by so much says that the excitation is not held, a likelihood ratio of e^3; then its tops are searched from all starts.
const DECISIVE: f64 = 6.0;
/// Where the other hold's objective will stay above by more than this, nobody asks by how much: a likelihood ratio of e^10.
pub(super) const CERTAIN: f64 = 20.0;
/// What a number costs that one hold has and the other has not, as in Akaike's criterion: both fit noise with it.
pub(super) const PRICE: f64 = 2.0;

/// Searches under the hold that was asked for, or under the more likely one; the problem is left with it. With it comes what the other one's
/// objective lies above, at most [`CERTAIN`] where the excitation is held; `None` where that was not compared or is not known.
///
/// The system has as many parameters under both. A straight line asks for more of each record: what its first and last state and known inputs do
/// along its excitation is no longer part of that, and a known input enters every sensor. Those numbers are counted against it.
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
    let before = priced(&held.climb);
    // A few steps tell whether it leads lower.
    let few = LikelihoodOptions {
        largest_steps: options.largest_steps.min(STEPS_OF_A_MOVE),
        largest_updates: options.largest_updates.min(UPDATES_OF_A_MOVE),
        ..options.clone()
    };
    let straight = up(problem, &held.climb, residuals, &few, Some(before + CERTAIN));
    let gain = before - priced(&straight);
    if gain.is_nan() || gain <= 0.0 {
        problem.layout.hold = Hold::ZeroOrder;
        let evidence = match straight.search.status {
            SearchStatus::GivenUp => Some(CERTAIN),
            SearchStatus::Converged | SearchStatus::AtRoundingLevel => {
                (!gain.is_nan()).then(|| CERTAIN.min(-gain))
            }
            _ => None,
        };
        return Some((held, evidence));
    }
    if gain <= DECISIVE {
        let climb = up(problem, &straight, residuals, options, None);
        let gain = before - priced(&climb);
        let lower = |(above, system)| (above + gain, system);
        let rivals = held.rivals.into_iter().map(lower).filter(|(above, _)| *above < RIVAL);
        return Some((Found { climb, rivals: rivals.collect(), ..held }, Some(gain)));
    }
    let own = model(&straight.evaluation.system, units, &problem.layout, starts[0].period);
    let all: Vec<SharedModel> = starts.iter().cloned().chain([own]).collect();
    let mut found = search(problem, &all, units, residuals, options)?;
    found.reports.truncate(starts.len());
    if found.best_start == starts.len() {
        found.best_start = held.best_start;
    }
    let evidence = before - priced(&found.climb);
    Some((found, Some(evidence)))
}

/// The objective with the price of the coefficients that the records determine.
fn priced(climb: &Climb) -> f64 {
    climb.objective + PRICE * count(climb.evaluation.nuisance_rank)
}

/// On from where another climb has ended, under the problem's own hold.
fn up(
    problem: &Problem,
    from: &Climb,
    residuals: f64,
    options: &LikelihoodOptions,
    ceiling: Option<f64>,
) -> Climb {
    let start = settled(problem, from.evaluation.system.clone(), &from.variances);
    let mut replaced = vec![false; problem.layout.records];
    ascend(problem, start, from.variances.clone(), residuals, options, ceiling, &mut replaced)
}

#[cfg(test)]
mod tests;
