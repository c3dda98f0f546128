//! Multistart over the local optima of the likelihood: from every start to its local optimum, restarts of the best one with its slow modes moved,
//! and the best few on all frequencies. Where there are many frequencies the first look takes a subset of them (`frequency_subset.rs`).

use hankel::in_order;

use super::eigenvalue_penalty::EigenvaluePenalty;
use super::frequency_subset::frequency_subset;
use super::local_search::{
    LocalOptimum, optimise, optimise_from_start, optimise_with_penalty, with_directions,
};
use super::report::StartReport;
use super::slow_mode_restarts::{self, Moved};
use crate::SharedModel;
use crate::likelihood::cost::evaluation::Problem;
use crate::likelihood::cost::parameters::System;
use crate::likelihood::options::{InputDirections, Options};

/// Local optima within this objective of the best one are reported as rivals: a likelihood ratio of e^3, 20 to 1.
pub(crate) const RIVAL: f64 = 6.0;
/// Local optima within this objective of the best one are finalists; scaled by the number of frequencies that one stands for where a subset is used.
const FINALIST: f64 = 20.0;
/// Two local optima with objectives closer than this are one; the searches end within a tenth of it.
const SAME_OPTIMUM: f64 = 0.02;
/// The most finalists that are refined on all frequencies.
const MOST_FINALISTS: usize = 4;
/// A system with a real mode that changes its sign with every sample has to be e^5 times as likely as one without.
const ALTERNATING: f64 = 10.0;
/// A first look ends where the next step would be shorter than this many standard errors, and its levels are as coarse.
const FIRST_LOOK: f64 = 0.1;

/// The weight of the eigenvalue penalty is this times the number of samples, squared: a moved mode stays within a thousandth of the change that one
/// record can resolve, unless the cost gains more than the weight.
const PENALTY: f64 = 1e3;
/// A restart that leaves this many times the best cost is given up.
const HOPELESS: f64 = 5.0;

/// A local optimum, and the start from which it was reached.
struct Candidate {
    optimum: LocalOptimum,
    start: usize,
}

/// What the search found.
pub(crate) struct Found {
    pub(crate) optimum: LocalOptimum,
    pub(crate) best_start: usize,
    pub(crate) reports: Vec<StartReport>,
    /// Other local optima, the best first, with what their objective lies above the best one's.
    pub(crate) rivals: Vec<(f64, System)>,
    /// Rounds in which a restart found a better optimum.
    pub(crate) restarts: usize,
}

/// Looks for the best local optimum. `None` where no start has a finite likelihood.
pub(crate) fn search(
    problem: &Problem,
    starts: &[SharedModel],
    units: &[f64],
    residuals: f64,
    options: &Options,
) -> Option<Found> {
    let moving = options.search.max_restarts > 0 && options.search.max_steps > 0;
    let thin = if moving || starts.len() > 1 { frequency_subset(problem) } else { None };
    let (look, first, chance) = match &thin {
        Some(thin) => (&thin.problem, &first_look(options), thin.largest_weight),
        None => (problem, options, 1.0),
    };
    let finalist = FINALIST * chance;
    let mut optima = Optima::default();
    let mut reports = Vec::with_capacity(starts.len());
    let from = |start: &SharedModel| optimise_from_start(look, start, units, residuals, first);
    in_order(
        starts,
        look.sharing(),
        |starts| starts.iter().map(from).collect(),
        |(report, optimum)| {
            if let Some(optimum) = optimum {
                optima.add(Candidate { optimum, start: reports.len() });
            }
            reports.push(report);
        },
    );
    let restarts = if moving {
        restart_from_slow_modes(look, &mut optima, residuals, first, finalist)
    } else {
        0
    };
    if thin.is_some() || restarts > 0 {
        optima = on_all_frequencies(problem, optima, residuals, options, finalist);
    }
    let mut ordered = optima.0.into_iter();
    let Candidate { optimum, start } = ordered.next()?;
    let rivals = ordered
        .filter(|candidate| !alternates(&candidate.optimum.evaluation.system))
        .map(|candidate| {
            (candidate.optimum.objective - optimum.objective, candidate.optimum.evaluation.system)
        })
        .filter(|(above, _)| *above < RIVAL)
        .collect();
    Some(Found { optimum, best_start: start, reports, rivals, restarts })
}

fn first_look(options: &Options) -> Options {
    let search = options.search.no_finer_than(FIRST_LOOK, FIRST_LOOK);
    Options { search, ..options.clone() }
}

/// Restarts from the best local optimum with each of its slow modes moved, in rounds, as long as that improves it.
fn restart_from_slow_modes(
    problem: &Problem,
    optima: &mut Optima,
    residuals: f64,
    options: &Options,
    finalist: f64,
) -> usize {
    let samples = problem
        .spectra
        .iter()
        .map(|spectrum| spectrum.weight.iter().sum::<f64>())
        .fold(0.0, f64::max);
    let rounds = options.search.max_restarts;
    let options = &Options { search: options.search.of_a_restart(), ..options.clone() };
    for round in 0..rounds {
        let Some(best) = optima.0.first() else { return round };
        let start = best.start;
        let (objective, cost) = (best.optimum.objective, best.optimum.evaluation.cost);
        let (system, variances) =
            (best.optimum.evaluation.system.clone(), best.optimum.variances.clone());
        let restart = |moved: &Moved| {
            let penalty = EigenvaluePenalty {
                eigenvalue: moved.eigenvalue,
                weight: (PENALTY * samples).powi(2),
            };
            let mut system = System { a: moved.a.clone(), ..system.clone() };
            if options.search.directions == InputDirections::Reestimated {
                system = with_directions(problem, &system, &variances);
            }
            let evaluation = problem.evaluate(system, &variances);
            let hopeless = HOPELESS * cost;
            let evaluation = optimise_with_penalty(
                problem, evaluation, &variances, residuals, penalty, hopeless,
            )?;
            let ceiling = Some(objective + finalist);
            let variances = variances.clone();
            let optimum = optimise(problem, evaluation, variances, residuals, options, ceiling);
            optimum.objective.is_finite().then_some(optimum)
        };
        in_order(
            &slow_mode_restarts::moved(&system.a, samples),
            problem.sharing(),
            |moved| moved.iter().map(restart).collect(),
            |optimum| {
                if let Some(optimum) = optimum {
                    optima.add(Candidate { optimum, start });
                }
            },
        );
        if optima.0.first().is_none_or(|best| best.optimum.objective >= objective) {
            return round;
        }
    }
    rounds
}

/// Refines the finalists on all frequencies.
fn on_all_frequencies(
    problem: &Problem,
    optima: Optima,
    residuals: f64,
    options: &Options,
    finalist: f64,
) -> Optima {
    let mut finals = Optima::default();
    let best = optima.0.first().map_or(f64::INFINITY, |candidate| candidate.optimum.objective);
    let finalists = optima.0.into_iter().take(MOST_FINALISTS);
    for candidate in finalists.take_while(|candidate| candidate.optimum.objective < best + finalist)
    {
        let ceiling = finals.0.first().map(|best| best.optimum.objective + RIVAL);
        let LocalOptimum { evaluation, variances, .. } = candidate.optimum;
        let evaluation = problem.evaluate_again(evaluation, &variances);
        let optimum = optimise(problem, evaluation, variances, residuals, options, ceiling);
        if optimum.objective.is_finite() {
            finals.add(Candidate { optimum, start: candidate.start });
        }
    }
    finals
}

/// Whether a real mode changes its sign with every sample, which no sampled continuous system does.
fn alternates(system: &System) -> bool {
    system.a.complex_eigenvalues().iter().any(|z| z.im == 0.0 && z.re < 0.0)
}

/// Different local optima, the most likely one, which has the lowest objective, first; one that alternates comes behind others that are nearly as likely.
#[derive(Default)]
struct Optima(Vec<Candidate>);

impl Optima {
    fn add(&mut self, candidate: Candidate) {
        let objective = candidate.optimum.objective;
        let same = |other: &Candidate| (other.optimum.objective - objective).abs() < SAME_OPTIMUM;
        if self.0.iter().any(same) {
            return;
        }
        let rank = |of: &Candidate| {
            let system = &of.optimum.evaluation.system;
            of.optimum.objective + if alternates(system) { ALTERNATING } else { 0.0 }
        };
        let own = rank(&candidate);
        let place = self.0.partition_point(|other| rank(other) <= own);
        self.0.insert(place, candidate);
    }
}

#[cfg(test)]
mod tests;
