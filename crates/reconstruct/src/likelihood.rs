//! Maximum likelihood for several records of one system, each under one unknown excitation.
//!
//! # The problem
//!
//! Record j = 1..J has m sensors. At each frequency of its discrete Fourier transform, z = exp(2 pi j k / N),
//!
//! Y_j = G_j U_j + z C (zI - A)^-1 t_j + V_j, G_j = C (zI - A)^-1 b_j + d_j,
//!
//! exactly: U_j is the transform of the excitation, free at every frequency; t_j holds the initial and the final state, x(0) - x(N); V_j is noise with
//! covariance S. With U_j at its best, what is left is the part of Y_j - z C (zI - A)^-1 t_j that no excitation explains, and the fit minimises
//!
//! sum over j and k of w e^H (S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g)) e, e = Y_j - z C (zI - A)^-1 t_j, g = G_j,
//!
//! with w = 2 inside and 1 at frequency zero and half the sampling frequency. Of the n^2 + m n + J n parameters in (A, C, b_j), n J + m n - J can be
//! identified: a change of basis and the scale of each b_j change nothing.
//!
//! | file | what it does |
//! |---|---|
//! | `spectrum.rs` | records to the frequency domain; offsets, trends, bands, known inputs |
//! | `direction.rs` | b_j from the spectra with A and C held |
//! | `feedback.rs`, `resolvent.rs`, `sums.rs`, `evaluation.rs` | cost, gradient, Gram matrix; t_j eliminated |
//! | `levenberg_marquardt.rs` | the search |
//! | `noise_levels.rs` | noise levels by restricted likelihood |
//! | `uncertainty.rs`, `goodness.rs`, `gamma.rs` | covariances, intervals, chi-squared, whiteness |

mod direction;
mod evaluation;
mod feedback;
#[cfg(test)]
pub(crate) mod fixtures;
mod gamma;
mod goodness;
mod lanes;
mod levenberg_marquardt;
mod noise_levels;
mod options;
mod resolvent;
mod spectrum;
mod sums;
mod system;
mod uncertainty;
mod validation;

use nalgebra::{DMatrix, DVector};
use realfft::RealFftPlanner;

pub use goodness::{ChiSquared, Whiteness};
pub use levenberg_marquardt::SearchStatus;
pub use options::{Directions, FrequencyBand, LikelihoodOptions, NoiseModel, Offsets, Trend};
pub use uncertainty::{ComplexEstimate, Ellipse, Estimate, ModeEstimate};

use crate::{ReconstructError, Record, SharedModel};
use evaluation::{Evaluation, Problem};
use levenberg_marquardt::{Limits, Search, minimise};
use spectrum::transform;
pub(crate) use spectrum::{count, rms};
use sums::Scalars;
use system::{Layout, System};

/// What the likelihood says about several records.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LikelihoodFit {
    /// The system, in the sensors' units. In its basis the states of the records have unit second moments; each (b_j, d_j) has unit length, before
    /// sensors are scaled back.
    pub model: SharedModel,
    /// The covariance of A by columns, C by columns, then b_j and the free entries of d_j of each record. It is singular along changes of basis and of
    /// scale, which it leaves out.
    pub covariance: DMatrix<f64>,
    /// The modes with their uncertainty, by real part of the eigenvalue, a complex pair once.
    pub modes: Vec<ModeEstimate>,
    /// Directions of the parameters that the records determine.
    pub determined: usize,
    /// Directions that can be identified where the records excite everything: n J + m n - J, and one more for each entry of d_j.
    pub identifiable: usize,
    /// Standard deviations of the noise in the sensors' units; `None` where the noise has a spectrum.
    pub noise_levels: Option<Vec<Estimate>>,
    /// The size of the residuals.
    pub chi_squared: ChiSquared,
    /// The same for each record alone: value per degree of freedom, parameters shared out by numbers of samples.
    pub record_chi_squared: Vec<f64>,
    /// Whether the residuals of each record are white.
    pub whiteness: Vec<Whiteness>,
    /// How the search ended.
    pub search: SearchReport,
    /// Each start that was given, in the order given.
    pub starts: Vec<StartReport>,
    /// Index of the start that led here.
    pub best_start: usize,
}

/// How a search went.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SearchReport {
    /// How it ended.
    pub status: SearchStatus,
    /// Steps that lowered the cost.
    pub steps: usize,
    /// Evaluations of the likelihood with its derivatives.
    pub evaluations: usize,
    /// Updates of the noise levels.
    pub level_updates: usize,
    /// Whether the noise levels settled; true where they were not estimated.
    pub levels_settled: bool,
    /// The length of the step that was not taken any more, in standard deviations of the estimate.
    pub remaining_step: f64,
}

/// Where one start led.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StartReport {
    /// The cost at the start, with its own directions.
    pub cost_at_start: f64,
    /// For each record, whether the direction that was estimated from the spectra fits better than the start's.
    pub direction_replaced: Vec<bool>,
    /// What was compared between the starts: the cost, plus the logarithms of determinants where noise levels were estimated.
    pub objective: f64,
    /// How its search went; `None` where the start has no finite cost.
    pub search: Option<SearchReport>,
}

/// Fits one system to several records.
///
/// # Errors
///
/// Records that do not fit together; [`ReconstructError::TooFewRecords`] and [`ReconstructError::TooFewSensors`] below two of each;
/// [`ReconstructError::ConstantChannel`]; [`ReconstructError::Start`] and [`ReconstructError::Option`] for starts and options that do not fit the records;
/// [`ReconstructError::Noise`] for noise that is not one; [`ReconstructError::TooFewSamples`] where there are not more residuals than parameters.
///
/// # Example
///
/// x1 and x2 decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first record is excited through
/// b = (1, 1), the second through b = (1, 2).
///
/// ```
/// use lti::SamplePeriod;
/// use nalgebra::{DMatrix, DVector};
/// use reconstruct::{Channel, LikelihoodOptions, Record, SharedModel, maximise};
///
/// let mut state = 1_u32;
/// let mut uniform = || {
///     state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
///     f64::from(state) / 2_147_483_648.0 - 1.0
/// };
/// let mut record = |name: &str, b: [f64; 2]| {
///     let mut x = [0.0, 0.0];
///     let mut outputs = vec![Vec::new(); 3];
///     for _ in 0..500 {
///         let [x1, x2] = x;
///         for (output, value) in outputs.iter_mut().zip([x1 + x2, x1 - x2, x1 + 3.0 * x2]) {
///             output.push(value + 0.01 * 3.0_f64.sqrt() * uniform());
///         }
///         let u = uniform();
///         x = [0.9 * x1 + b[0] * u, 0.5 * x2 + b[1] * u];
///     }
///     let channels = outputs.into_iter().zip(["y1", "y2", "y3"]).map(|(values, name)| Channel::new(name, values));
///     Record::new(name, SamplePeriod::new(1.0)?, channels.collect()).map_err(Box::<dyn std::error::Error>::from)
/// };
/// let records = [record("first", [1.0, 1.0])?, record("second", [1.0, 2.0])?];
/// // A start that is roughly right, and knows nothing of the directions.
/// let start = SharedModel {
///     a: DMatrix::from_row_slice(2, 2, &[0.88, 0.0, 0.0, 0.53]),
///     c: DMatrix::from_row_slice(3, 2, &[1.0, 1.1, 1.0, -0.9, 1.0, 3.0]),
///     b: vec![DVector::from_element(2, 1.0); 2],
///     feedthrough: None,
///     period: SamplePeriod::new(1.0)?,
/// };
/// let fit = maximise(&records, &[start], &LikelihoodOptions::default())?;
/// let slow = fit.modes[1].discrete;
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_deviation());
/// assert!(slow.real_deviation() < 1e-3);
/// let level = fit.noise_levels.unwrap()[0];
/// assert!((level.value - 0.01).abs() < 3.0 * level.deviation);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn maximise(
    records: &[Record],
    starts: &[SharedModel],
    options: &LikelihoodOptions,
) -> Result<LikelihoodFit, ReconstructError> {
    let layout = validation::check(records, starts, options)?;
    let units = noise_levels::units(records, options);
    let mut planner = RealFftPlanner::new();
    let spectra = records
        .iter()
        .enumerate()
        .map(|(index, record)| transform(record, index, &units, options, &mut planner))
        .collect::<Result<Vec<_>, _>>()?;
    let problem = Problem { layout, spectra };
    let residuals: f64 =
        problem.spectra.iter().map(|spectrum| spectrum.residuals(problem.layout.sensors)).sum();
    let needed = count(problem.layout.identifiable())
        + problem
            .no_coefficients()
            .iter()
            .flatten()
            .map(|_| count(problem.layout.order))
            .sum::<f64>();
    if residuals <= needed {
        return Err(ReconstructError::TooFewSamples { residuals, parameters: needed });
    }
    let mut reports = Vec::with_capacity(starts.len());
    let mut best: Option<(usize, Climb)> = None;
    for (index, start) in starts.iter().enumerate() {
        let (report, climb) = climb(&problem, start, &units, residuals, options);
        if let Some(climb) = climb {
            let better = best.as_ref().is_none_or(|(_, best)| climb.objective < best.objective);
            if better {
                best = Some((index, climb));
            }
        }
        reports.push(report);
    }
    let Some((best_start, climb)) = best else {
        return Err(ReconstructError::Start {
            start: 0,
            message: "no start has a finite likelihood".to_owned(),
        });
    };
    conclude(records, &problem, climb, &units, residuals, options, reports, best_start)
}

/// The top that one start leads to.
struct Climb {
    evaluation: Evaluation,
    variances: Vec<f64>,
    objective: f64,
    search: SearchReport,
}

fn climb(
    problem: &Problem,
    start: &SharedModel,
    units: &[f64],
    residuals: f64,
    options: &LikelihoodOptions,
) -> (StartReport, Option<Climb>) {
    let estimate_levels = matches!(options.noise, NoiseModel::Estimated { .. });
    let mut variances = vec![1.0; units.len()];
    let system = scaled(start, units, &problem.layout).normalised();
    let mut evaluation = settled(problem, system, &variances);
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
    let mut update = |evaluation: Evaluation, variances: &[f64]| {
        if options.directions == Directions::AsStarted {
            return evaluation;
        }
        better_directions(problem, evaluation, variances, &mut report.direction_replaced)
    };
    evaluation = update(evaluation, &variances);
    if matches!(options.noise, NoiseModel::Estimated { first_guess: None }) {
        // A first idea of the levels before anything moves, since the directions depend on their ratios.
        const BEFORE_THE_SEARCH: usize = 3;
        for _ in 0..BEFORE_THE_SEARCH {
            variances = noise_levels::updated(&evaluation, &variances).0;
            evaluation = settled_again(problem, evaluation, &variances);
        }
        evaluation = update(evaluation, &variances);
    }
    let energy = |variances: &[f64]| -> f64 {
        let part = |spectrum: &spectrum::RecordSpectrum| -> f64 {
            spectrum
                .y
                .chunks_exact(variances.len())
                .zip(&spectrum.weight)
                .map(|(y, weight)| {
                    let sum: f64 = y.iter().zip(variances).map(|(y, v)| y.norm_sqr() / v).sum();
                    weight * sum
                })
                .sum()
        };
        problem.spectra.iter().map(part).sum()
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
        let parameters = count(problem.layout.identifiable() + evaluation.nuisance_rank);
        let limits = Limits {
            steps: options.largest_steps,
            step_tolerance: options.step_tolerance,
            degrees_of_freedom: (residuals - parameters).max(1.0),
            energy: energy(&variances),
        };
        let found = rounds(problem, evaluation, &variances, limits, &mut update);
        evaluation = found.evaluation;
        search.status = found.status;
        search.steps += found.steps;
        search.evaluations += found.evaluations;
        search.remaining_step = found.remaining_step;
        let exhausted = found.status == SearchStatus::StepLimit;
        if !estimate_levels || exhausted || search.level_updates >= options.largest_updates {
            break;
        }
        let (next, change) = noise_levels::updated(&evaluation, &variances);
        search.levels_settled = change <= options.level_tolerance;
        if search.levels_settled {
            break;
        }
        variances = next;
        search.level_updates += 1;
        evaluation = settled_again(problem, evaluation, &variances);
        search.evaluations += 1;
    }
    let objective = if estimate_levels {
        evaluation.cost + evaluation.log_determinant
    } else {
        evaluation.cost
    };
    report.objective = objective;
    report.search = Some(search.clone());
    let climb = objective.is_finite().then_some(Climb { evaluation, variances, objective, search });
    (report, climb)
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

/// The start in scaled sensors.
fn scaled(start: &SharedModel, units: &[f64], layout: &Layout) -> System {
    let unit = DVector::from_column_slice(units);
    let mut c = start.c.clone();
    for (mut row, unit) in c.row_iter_mut().zip(units) {
        row /= *unit;
    }
    let d = (0..layout.records).map(|record| {
        let mut d = DVector::zeros(layout.sensors);
        if let Some(feedthrough) = &start.feedthrough {
            for &sensor in &layout.feedthrough {
                d[sensor] = feedthrough[record][sensor] / unit[sensor];
            }
        }
        d
    });
    System { a: start.a.clone(), c, b: start.b.clone(), d: d.collect() }
}

/// Evaluates twice: the coefficients of known signals first, then everything around them.
fn settled(problem: &Problem, system: System, variances: &[f64]) -> Evaluation {
    let first = problem.evaluate(system, problem.no_coefficients(), variances);
    settled_again(problem, first, variances)
}

/// Evaluates the same system around its best coefficients.
fn settled_again(problem: &Problem, evaluation: Evaluation, variances: &[f64]) -> Evaluation {
    let still = DVector::zeros(problem.layout.parameters());
    let coefficients = evaluation.coefficients_after(&still, &problem.layout);
    problem.evaluate(evaluation.system, coefficients, variances)
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
    settled(problem, system, variances)
}

/// Takes for each record the direction estimated from the spectra where it fits better than the present one.
fn better_directions(
    problem: &Problem,
    evaluation: Evaluation,
    variances: &[f64],
    replaced: &mut [bool],
) -> Evaluation {
    let mut candidate = evaluation.system.clone();
    for (record, spectrum) in problem.spectra.iter().enumerate() {
        let found = direction::direction(spectrum, &evaluation.system, &problem.layout, variances);
        if let Some((b, d)) = found {
            candidate.b[record] = b;
            candidate.d[record] = d;
        }
    }
    let trial = settled(problem, candidate.normalised(), variances);
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
    let first = problem.evaluate(mixed, coefficients, variances);
    settled_again(problem, first, variances)
}

#[expect(clippy::too_many_arguments, reason = "the parts of one result, put together in one place")]
fn conclude(
    records: &[Record],
    problem: &Problem,
    climb: Climb,
    units: &[f64],
    residuals: f64,
    options: &LikelihoodOptions,
    starts: Vec<StartReport>,
    best_start: usize,
) -> Result<LikelihoodFit, ReconstructError> {
    let layout = &problem.layout;
    let estimated = matches!(options.noise, NoiseModel::Estimated { .. });
    let Climb { mut evaluation, mut variances, search, .. } = climb;
    let parameters = count(layout.identifiable() + evaluation.nuisance_rank);
    let degrees_of_freedom = (residuals - parameters).max(1.0);
    if estimated {
        // The restricted likelihood leaves out the excitations; the parameters took their share of the residuals, too.
        let share = evaluation.cost / degrees_of_freedom;
        if share > 0.0 && share.is_finite() {
            variances.iter_mut().for_each(|variance| *variance *= share);
        }
    }
    evaluation.system = evaluation.system.normalised();
    evaluation = settled_again(problem, evaluation, &variances);
    let mut noise_part = DMatrix::zeros(layout.parameters(), layout.parameters());
    let cells = layout.local_cells();
    let mut whiteness = Vec::with_capacity(records.len());
    for (record, source) in records.iter().enumerate() {
        let sums = problem.record_sums(
            record,
            &evaluation.system,
            &evaluation.coefficients,
            &variances,
            Scalars::NoisePart,
            true,
        );
        for (local, &first) in cells.iter().enumerate() {
            for (other, &second) in cells.iter().enumerate() {
                noise_part[(layout.global(local, record), layout.global(other, record))] +=
                    sums.gram(first, second);
            }
        }
        whiteness.push(goodness::whiteness(
            source.name(),
            &problem.spectra[record],
            sums.spectrum.as_deref().unwrap_or_default(),
            layout.sensors,
        ));
    }
    let parameters = uncertainty::covariance(&evaluation, &noise_part, layout);
    let period = records[0].period();
    let n = layout.order;
    let states = parameters.matrix.view((0, 0), (n * n, n * n)).into_owned();
    let modes = uncertainty::modes(&evaluation.system.a, period, &states).map_err(|error| {
        ReconstructError::Step { step: "modes of the fitted system", message: error.to_string() }
    })?;
    let noise_levels = match options.noise {
        NoiseModel::Spectra(_) => None,
        _ => Some(noise_levels::estimates(&evaluation, &variances, units, estimated)),
    };
    let record_chi_squared = evaluation
        .record_costs
        .iter()
        .zip(&problem.spectra)
        .map(|(cost, spectrum)| {
            cost / (spectrum.residuals(layout.sensors) * degrees_of_freedom / residuals)
        })
        .collect();
    Ok(LikelihoodFit {
        covariance: in_sensor_units(&parameters.matrix, units, layout),
        model: model(&evaluation.system, units, layout, period),
        modes,
        determined: parameters.determined,
        identifiable: layout.identifiable(),
        noise_levels,
        chi_squared: ChiSquared::new(evaluation.cost, degrees_of_freedom, estimated),
        record_chi_squared,
        whiteness,
        search,
        starts,
        best_start,
    })
}

fn model(
    system: &System,
    units: &[f64],
    layout: &Layout,
    period: lti::SamplePeriod,
) -> SharedModel {
    let unit = DVector::from_column_slice(units);
    let mut c = system.c.clone();
    for (mut row, unit) in c.row_iter_mut().zip(units) {
        row *= *unit;
    }
    let feedthrough = (!layout.feedthrough.is_empty())
        .then(|| system.d.iter().map(|d| d.component_mul(&unit)).collect());
    SharedModel { a: system.a.clone(), c, b: system.b.clone(), feedthrough, period }
}

fn in_sensor_units(covariance: &DMatrix<f64>, units: &[f64], layout: &Layout) -> DMatrix<f64> {
    let (n, m) = (layout.order, layout.sensors);
    let mut scale = DVector::from_element(layout.parameters(), 1.0);
    for l in 0..n {
        for s in 0..m {
            scale[n * n + l * m + s] = units[s];
        }
    }
    for record in 0..layout.records {
        for (k, &sensor) in layout.feedthrough.iter().enumerate() {
            scale[layout.shared() + record * layout.per_record() + n + k] = units[sensor];
        }
    }
    DMatrix::from_fn(covariance.nrows(), covariance.ncols(), |i, k| {
        covariance[(i, k)] * scale[i] * scale[k]
    })
}

#[cfg(test)]
mod tests;
