//! Hold selection: the search under a zero-order hold, and under a first-order hold where that is more likely.

use super::levenberg_marquardt::SearchStatus;
use super::local_search::{LocalOptimum, optimise};
use super::multistart::{Found, RIVAL, search};
use crate::SharedModel;
use crate::likelihood::cost::evaluation::Problem;
use crate::likelihood::options::Options;
use crate::model::Hold;

/// A first-order hold whose objective is lower by this much (a likelihood ratio of e^3) is searched from all starts.
const DECISIVE: f64 = 6.0;
/// The evidence against a first-order hold is capped here: a likelihood ratio of e^10.
pub(crate) const CERTAIN: f64 = 20.0;
/// What each fitted number adds to the criterion, after Akaike: it fits noise, too.
pub(crate) const PRICE: f64 = 2.0;

/// Searches under the hold that was asked for, or under the more likely one; the problem is left with it. With it comes what the other one's
/// objective lies above, at most [`CERTAIN`] where the excitation is held; `None` where that was not compared or is not known.
///
/// The system has as many parameters under both. A straight line asks for more of each record: what its first and last state and known inputs do
/// along its excitation is no longer part of that, and a known input enters every sensor. Those numbers are counted against it.
pub(crate) fn search_over_holds(
    problem: &mut Problem,
    starts: &[SharedModel],
    units: &[f64],
    residuals: f64,
    options: &Options,
) -> Option<(Found, Option<f64>)> {
    let zero_order = search(problem, starts, units, residuals, options)?;
    if options.hold.is_some() || options.search.max_steps == 0 {
        return Some((zero_order, None));
    }
    problem.layout.hold = Hold::FirstOrder;
    let before = priced(&zero_order.optimum);
    // A few steps tell whether it leads lower.
    let few = Options { search: options.search.of_a_restart(), ..options.clone() };
    let first_order =
        continue_from(problem, &zero_order.optimum, residuals, &few, Some(before + CERTAIN));
    let gain = before - priced(&first_order);
    if gain.is_nan() || gain <= 0.0 {
        problem.layout.hold = Hold::ZeroOrder;
        let evidence = match first_order.search.status {
            SearchStatus::GivenUp => Some(CERTAIN),
            SearchStatus::Converged | SearchStatus::AtRoundingLevel => {
                (!gain.is_nan()).then(|| CERTAIN.min(-gain))
            }
            _ => None,
        };
        return Some((zero_order, evidence));
    }
    if gain <= DECISIVE {
        let optimum = continue_from(problem, &first_order, residuals, options, None);
        let gain = before - priced(&optimum);
        let lower = |(above, system)| (above + gain, system);
        let rivals = zero_order.rivals.into_iter().map(lower).filter(|(above, _)| *above < RIVAL);
        return Some((Found { optimum, rivals: rivals.collect(), ..zero_order }, Some(gain)));
    }
    let own = first_order.evaluation.system.model(units, &problem.layout, starts[0].period);
    let all: Vec<SharedModel> = starts.iter().cloned().chain([own]).collect();
    let mut found = search(problem, &all, units, residuals, options)?;
    found.reports.truncate(starts.len());
    if found.best_start == starts.len() {
        found.best_start = zero_order.best_start;
    }
    let evidence = before - priced(&found.optimum);
    Some((found, Some(evidence)))
}

/// The objective with the price of the coefficients that the records determine.
fn priced(optimum: &LocalOptimum) -> f64 {
    optimum.objective + PRICE * optimum.evaluation.nuisance_rank as f64
}

/// Restart from another optimum under the current hold.
fn continue_from(
    problem: &Problem,
    from: &LocalOptimum,
    residuals: f64,
    options: &Options,
    ceiling: Option<f64>,
) -> LocalOptimum {
    let start = problem.evaluate(from.evaluation.system.clone(), &from.variances);
    optimise(problem, start, from.variances.clone(), residuals, options, ceiling)
}

#[cfg(test)]
mod tests;
