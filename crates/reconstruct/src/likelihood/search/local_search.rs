//! From one start to its local optimum: basis, input directions, noise levels, search.

use nalgebra::DMatrix;
use num_complex::Complex;

use super::eigenvalue_penalty::EigenvaluePenalty;
use super::input_direction::input_direction;
use super::levenberg_marquardt::{Limits, Search, SearchStatus, minimise};
use super::noise_levels;
use super::report::{SearchReport, StartReport};
use crate::SharedModel;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::noise::first_variances;
use crate::likelihood::cost::parameters::System;
use crate::likelihood::cost::spectrum::RecordSpectrum;
use crate::likelihood::options::{InputDirections, Noise, Options};

/// The local optimum that one start leads to.
pub(crate) struct LocalOptimum {
    pub(crate) evaluation: Evaluation,
    pub(crate) variances: Vec<f64>,
    pub(crate) objective: f64,
    pub(crate) search: SearchReport,
    /// For each record, whether its direction was estimated anew from the spectra on the way.
    pub(crate) direction_replaced: Vec<bool>,
}

/// From one start to its local optimum.
pub(crate) fn optimise_from_start(
    problem: &Problem,
    start: &SharedModel,
    units: &[f64],
    residuals: f64,
    options: &Options,
) -> (StartReport, Option<LocalOptimum>) {
    let mut variances = first_variances(&problem.floors, problem.layout.sensors);
    let system = System::scaled(start, units, &problem.layout).normalised();
    let mut evaluation = problem.evaluate(system, &variances);
    evaluation = in_own_basis(problem, evaluation, &variances);
    let mut report = StartReport {
        cost_at_start: evaluation.cost,
        direction_replaced: vec![false; problem.layout.records],
        objective: f64::INFINITY,
        search: None,
    };
    if !evaluation.cost.is_finite() {
        return (report, None);
    }
    if options.search.directions == InputDirections::Reestimated {
        evaluation =
            better_directions(problem, evaluation, &variances, &mut report.direction_replaced);
    }
    if matches!(options.noise, Noise::Estimated { first_guess: None } | Noise::ModelError { .. }) {
        // A first idea of the levels before anything moves, since the directions depend on their ratios.
        const BEFORE_THE_SEARCH: usize = 3;
        for _ in 0..BEFORE_THE_SEARCH {
            variances = noise_levels::updated(&evaluation, &variances, &problem.floors).0;
            evaluation = problem.evaluate_again(evaluation, &variances);
        }
        if options.search.directions == InputDirections::Reestimated {
            evaluation =
                better_directions(problem, evaluation, &variances, &mut report.direction_replaced);
        }
    }
    let optimum = optimise(problem, evaluation, variances, residuals, options, None);
    for (all, later) in report.direction_replaced.iter_mut().zip(&optimum.direction_replaced) {
        *all |= later;
    }
    report.objective = optimum.objective;
    report.search = Some(optimum.search.clone());
    let optimum = optimum.objective.is_finite().then_some(optimum);
    (report, optimum)
}

/// Searches from here, the noise levels with it. Gives up where it will not come below the ceiling of the objective.
pub(crate) fn optimise(
    problem: &Problem,
    mut evaluation: Evaluation,
    mut variances: Vec<f64>,
    residuals: f64,
    options: &Options,
    ceiling: Option<f64>,
) -> LocalOptimum {
    let estimate_levels = options.noise.is_estimated();
    let mut direction_replaced = vec![false; problem.layout.records];
    let mut update = |evaluation: Evaluation, variances: &[f64]| {
        if options.search.directions == InputDirections::AsStarted {
            return evaluation;
        }
        better_directions(problem, evaluation, variances, &mut direction_replaced)
    };
    // Known levels leave it as it is.
    let determinant = |evaluation: &Evaluation| {
        if estimate_levels { evaluation.log_determinant } else { 0.0 }
    };
    let mut search = SearchReport {
        status: SearchStatus::StepLimit,
        steps: 0,
        evaluations: 0,
        level_updates: 0,
        levels_settled: !estimate_levels,
        remaining_step: f64::INFINITY,
    };
    loop {
        let parameters = (problem.identifiable() + evaluation.nuisance_rank) as f64;
        let limits = Limits {
            steps: options.search.max_steps,
            step_tolerance: options.search.step_tolerance,
            degrees_of_freedom: (residuals - parameters).max(1.0),
            energy: energy(problem, &variances),
            ceiling: ceiling.map_or(f64::INFINITY, |ceiling| ceiling - determinant(&evaluation)),
            penalty: None,
        };
        let found = rounds(problem, evaluation, &variances, limits, &mut update);
        evaluation = found.evaluation;
        search.status = found.status;
        search.steps += found.steps;
        search.evaluations += found.evaluations;
        search.remaining_step = found.remaining_step;
        let exhausted = matches!(found.status, SearchStatus::StepLimit | SearchStatus::GivenUp);
        if !estimate_levels {
            break;
        }
        let (next, change) = noise_levels::updated(&evaluation, &variances, &problem.floors);
        search.levels_settled = change <= options.search.level_tolerance;
        let updated_enough = search.level_updates >= options.search.max_noise_updates;
        if search.levels_settled || exhausted || updated_enough {
            break;
        }
        variances = next;
        search.level_updates += 1;
        evaluation = problem.evaluate_again(evaluation, &variances);
        search.evaluations += 1;
    }
    let objective = evaluation.cost + determinant(&evaluation);
    LocalOptimum { evaluation, variances, objective, search, direction_replaced }
}

/// The cost of explaining nothing.
fn energy(problem: &Problem, variances: &[f64]) -> f64 {
    let sensors = problem.layout.sensors;
    let part = |spectrum: &RecordSpectrum| -> f64 {
        let at = |(k, (y, weight)): (usize, (&[Complex<f64>], &f64))| {
            let part =
                |(s, y): (usize, &Complex<f64>)| y.norm_sqr() / spectrum.variance(k, s, variances);
            weight * y.iter().enumerate().map(part).sum::<f64>()
        };
        spectrum.y.chunks_exact(sensors).zip(&spectrum.weight).enumerate().map(at).sum()
    };
    problem.spectra.iter().map(part).sum()
}

/// A few steps around an eigenvalue that a penalty keeps in its place; `None` where they stay above a ceiling of the cost.
pub(crate) fn optimise_with_penalty(
    problem: &Problem,
    start: Evaluation,
    variances: &[f64],
    degrees_of_freedom: f64,
    penalty: EigenvaluePenalty,
    ceiling: f64,
) -> Option<Evaluation> {
    // What is left after that, or below a deviation, is for the search to come.
    const STEPS: usize = 20;
    const STEP_TOLERANCE: f64 = 1.0;
    let limits = Limits {
        steps: STEPS,
        step_tolerance: STEP_TOLERANCE,
        degrees_of_freedom,
        energy: 0.0,
        ceiling,
        penalty: Some(penalty),
    };
    let found = minimise(problem, start, variances, limits);
    // Also false where there is no cost.
    let below = found.evaluation.cost < ceiling;
    below.then(|| problem.evaluate_again(found.evaluation, variances))
}

/// Searches in rounds, and asks between them whether the spectra now tell a better direction: from a poor start the directions are what the
/// search gets stuck on.
fn rounds(
    problem: &Problem,
    start: Evaluation,
    variances: &[f64],
    limits: Limits,
    update: &mut impl FnMut(Evaluation, &[f64]) -> Evaluation,
) -> Search {
    const STEPS_IN_A_ROUND: usize = 8;
    let mut steps = 0;
    let mut evaluations = 0;
    let mut here = start;
    loop {
        let round = Limits { steps: STEPS_IN_A_ROUND.min(limits.steps - steps), ..limits };
        let mut found = minimise(problem, here, variances, round);
        steps += found.steps;
        evaluations += found.evaluations;
        found.steps = steps;
        found.evaluations = evaluations;
        let over = found.status != SearchStatus::StepLimit || steps == limits.steps;
        if over {
            return found;
        }
        here = update(found.evaluation, variances);
    }
}

/// The same system in the basis in which the states of all records have unit second moments.
fn in_own_basis(problem: &Problem, evaluation: Evaluation, variances: &[f64]) -> Evaluation {
    // A state that the records hardly move keeps this part of the largest one's scale.
    const LEAST_MOTION: f64 = 1e-10;
    let n = problem.layout.order;
    let total: f64 = problem.spectra.iter().flat_map(|spectrum| &spectrum.weight).sum();
    let moments = &evaluation.states / total;
    let scale = moments.diagonal().map(|x| if x > 0.0 { x.sqrt() } else { 1.0 });
    let mut unit = DMatrix::from_fn(n, n, |i, k| moments[(i, k)] / (scale[i] * scale[k]));
    for i in 0..n {
        unit[(i, i)] += LEAST_MOTION;
    }
    let Some(factor) = unit.cholesky() else {
        return evaluation;
    };
    let t = DMatrix::from_diagonal(&scale) * factor.l();
    let Some(inverse) = t.clone().try_inverse() else {
        return evaluation;
    };
    let system = evaluation.system.in_basis(&t, &inverse).normalised();
    if !system.is_finite() {
        return evaluation;
    }
    problem.evaluate(system, variances)
}

/// The system with the directions estimated from the spectra, where these tell any.
pub(crate) fn with_directions(problem: &Problem, system: &System, variances: &[f64]) -> System {
    let mut candidate = system.clone();
    for (record, spectrum) in problem.spectra.iter().enumerate() {
        let found = input_direction(spectrum, system, &problem.layout, variances);
        if let Some((b, d)) = found {
            candidate.b[record] = b;
            candidate.d[record] = d;
        }
    }
    candidate.normalised()
}

/// Takes for each record the direction estimated from the spectra where it fits better than the present one.
fn better_directions(
    problem: &Problem,
    evaluation: Evaluation,
    variances: &[f64],
    replaced: &mut [bool],
) -> Evaluation {
    let candidate = with_directions(problem, &evaluation.system, variances);
    let trial = problem.evaluate(candidate, variances);
    let better: Vec<bool> = trial
        .record_costs
        .iter()
        .zip(&evaluation.record_costs)
        .map(|(trial, present)| trial < present)
        .collect();
    for (replaced, better) in replaced.iter_mut().zip(&better) {
        *replaced |= better;
    }
    if better.iter().all(|better| *better) {
        return trial;
    }
    if !better.iter().any(|better| *better) {
        return evaluation;
    }
    let mut mixed = evaluation.system.clone();
    let mut coefficients = evaluation.coefficients.clone();
    for (record, _) in better.iter().enumerate().filter(|(_, better)| **better) {
        mixed.b[record].clone_from(&trial.system.b[record]);
        mixed.d[record].clone_from(&trial.system.d[record]);
        coefficients[record].clone_from(&trial.coefficients[record]);
    }
    problem.evaluate_near(mixed, coefficients, variances)
}
