//! Over the tops of the likelihood: from every start to a top, from the best one to those that its slow modes hide, and the best few on all
//! frequencies. Where there are many frequencies the first look takes some of them (`thinning.rs`).

use super::StartReport;
use super::climb::{Climb, around, ascend, climb, settled, settled_again, with_directions};
use super::evaluation::Problem;
use super::held::Held;
use super::options::{Directions, LikelihoodOptions};
use super::slow_modes;
use super::system::System;
use super::thinning::thinned;
use crate::SharedModel;

/// Tops within this objective of the best one are told: a likelihood ratio of e^3, 20 to 1.
pub(super) const RIVAL: f64 = 6.0;
/// Tops within this objective of the best one may be the best one in the end; on some frequencies, times how many of all one stands for.
const FINALIST: f64 = 20.0;
/// Two tops with objectives closer than this are one; the searches end within a tenth of it.
const SAME_TOP: f64 = 0.02;
/// The most tops that are followed on all frequencies.
const MOST_FINALISTS: usize = 4;
/// A first look ends where the next step would be shorter than this many standard deviations, and its levels are as coarse.
const FIRST_LOOK: f64 = 0.1;

/// A mode that was moved is held within its share of a record's length over this, as long as the cost does not ask for more than that squared.
const HOLD: f64 = 1e3;
/// Around a moved mode that leaves this many times the best cost there is no higher top.
const HOPELESS: f64 = 5.0;

/// The most steps between two updates of the noise levels, and the most updates, after a move.
pub(super) const STEPS_OF_A_MOVE: usize = 40;
pub(super) const UPDATES_OF_A_MOVE: usize = 5;

/// A top, and the start from which it was reached.
struct Top {
    climb: Climb,
    start: usize,
}

/// What the search found.
pub(super) struct Found {
    pub(super) climb: Climb,
    pub(super) best_start: usize,
    pub(super) reports: Vec<StartReport>,
    /// Other tops, the highest first, with what their objective lies above the best one's.
    pub(super) rivals: Vec<(f64, System)>,
    /// Rounds in which a moved mode led higher.
    pub(super) moves: usize,
}

/// Looks for the highest top. `None` where no start has a finite likelihood.
pub(super) fn search(
    problem: &Problem,
    starts: &[SharedModel],
    units: &[f64],
    residuals: f64,
    options: &LikelihoodOptions,
) -> Option<Found> {
    let moving = options.largest_moves > 0 && options.largest_steps > 0;
    let thin = if moving || starts.len() > 1 { thinned(problem) } else { None };
    let (look, first, chance) = match &thin {
        Some(thin) => (&thin.problem, &first_look(options), thin.largest_weight),
        None => (problem, options, 1.0),
    };
    let finalist = FINALIST * chance;
    let mut tops = Tops::default();
    let mut reports = Vec::with_capacity(starts.len());
    for (index, start) in starts.iter().enumerate() {
        let (report, climb) = climb(look, start, units, residuals, first);
        if let Some(climb) = climb {
            tops.add(Top { climb, start: index });
        }
        reports.push(report);
    }
    let moves =
        if moving { past_slow_modes(look, &mut tops, residuals, first, finalist) } else { 0 };
    if thin.is_some() || moves > 0 {
        tops = on_all_frequencies(problem, tops, residuals, options, finalist);
    }
    let mut ordered = tops.0.into_iter();
    let Top { climb, start } = ordered.next()?;
    let rivals = ordered
        .map(|top| (top.climb.objective - climb.objective, top.climb.evaluation.system))
        .filter(|(above, _)| *above < RIVAL)
        .collect();
    Some(Found { climb, best_start: start, reports, rivals, moves })
}

fn first_look(options: &LikelihoodOptions) -> LikelihoodOptions {
    LikelihoodOptions {
        step_tolerance: options.step_tolerance.max(FIRST_LOOK),
        level_tolerance: options.level_tolerance.max(FIRST_LOOK),
        ..options.clone()
    }
}

/// Moves slow modes of the best top, in rounds, as long as that leads higher.
fn past_slow_modes(
    problem: &Problem,
    tops: &mut Tops,
    residuals: f64,
    options: &LikelihoodOptions,
    finalist: f64,
) -> usize {
    let samples = problem
        .spectra
        .iter()
        .map(|spectrum| spectrum.weight.iter().sum::<f64>())
        .fold(0.0, f64::max);
    let rounds = options.largest_moves;
    // A move that creeps leads nowhere, and there are several of them.
    let options = &LikelihoodOptions {
        largest_steps: options.largest_steps.min(STEPS_OF_A_MOVE),
        largest_updates: options.largest_updates.min(UPDATES_OF_A_MOVE),
        ..options.clone()
    };
    for round in 0..rounds {
        let Some(best) = tops.0.first() else { return round };
        let start = best.start;
        let (objective, cost) = (best.climb.objective, best.climb.evaluation.cost);
        let (system, variances) =
            (best.climb.evaluation.system.clone(), best.climb.variances.clone());
        for moved in slow_modes::moved(&system.a, samples) {
            let held = Held { eigenvalue: moved.eigenvalue, penalty: (HOLD * samples).powi(2) };
            let mut system = System { a: moved.a, ..system.clone() };
            if options.directions == Directions::Reestimated {
                system = with_directions(problem, &system, &variances);
            }
            let evaluation = settled(problem, system, &variances);
            let hopeless = HOPELESS * cost;
            let Some(evaluation) =
                around(problem, evaluation, &variances, residuals, held, hopeless)
            else {
                continue;
            };
            let ceiling = Some(objective + finalist);
            let mut replaced = vec![false; problem.layout.records];
            let variances = variances.clone();
            let climb =
                ascend(problem, evaluation, variances, residuals, options, ceiling, &mut replaced);
            if climb.objective.is_finite() {
                tops.add(Top { climb, start });
            }
        }
        if tops.0.first().is_none_or(|best| best.climb.objective >= objective) {
            return round;
        }
    }
    rounds
}

/// Follows the best tops on all frequencies.
fn on_all_frequencies(
    problem: &Problem,
    tops: Tops,
    residuals: f64,
    options: &LikelihoodOptions,
    finalist: f64,
) -> Tops {
    let mut finals = Tops::default();
    let highest = tops.0.first().map_or(f64::INFINITY, |top| top.climb.objective);
    let finalists = tops.0.into_iter().take(MOST_FINALISTS);
    for top in finalists.take_while(|top| top.climb.objective < highest + finalist) {
        let ceiling = finals.0.first().map(|best| best.climb.objective + RIVAL);
        let mut replaced = vec![false; problem.layout.records];
        let Climb { evaluation, variances, .. } = top.climb;
        let evaluation = settled_again(problem, evaluation, &variances);
        let climb =
            ascend(problem, evaluation, variances, residuals, options, ceiling, &mut replaced);
        if climb.objective.is_finite() {
            finals.add(Top { climb, start: top.start });
        }
    }
    finals
}

/// Different tops, the highest likelihood, which is the lowest objective, first.
#[derive(Default)]
struct Tops(Vec<Top>);

impl Tops {
    fn add(&mut self, top: Top) {
        let objective = top.climb.objective;
        let same = |other: &Top| (other.climb.objective - objective).abs() < SAME_TOP;
        if self.0.iter().any(same) {
            return;
        }
        let place = self.0.partition_point(|other| other.climb.objective <= objective);
        self.0.insert(place, top);
    }
}

#[cfg(test)]
mod tests;
