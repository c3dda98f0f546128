//! The lateral equations of an aircraft under unknown excitation: the same likelihood, with derivatives as parameters instead of all entries of the matrices.
//!
//! Eleven derivatives and two numbers for each record take the place of n J + m n - J: on noisy flights the modes scatter less, the roll mode above all. Where the records
//! hold more than the equations, an actuator or a damper, the criteria of both say so.

mod conditions;
mod starts;

pub use conditions::{Condition, ConditionTest, condition_test};

use nalgebra::DVector;

use super::cost::evaluation::Problem;
use super::cost::lateral::LateralParameters;
use super::cost::noise::sensor_units;
use super::cost::parameters::Layout;
use super::inference::chi_squared::chi_squared_survival;
use super::inference::conclusion::conclude;
use super::inference::fit::Fit;
use super::inference::refit::lateral;
use super::options::{InputDirections, Options};
use super::search::hold_selection::PRICE;
use super::search::local_search::{LocalOptimum, optimise};
use super::search::multistart::Found;
use super::search::report::StartReport;
use super::validation;
use crate::error::option;
use crate::model::Hold;
use crate::model::lateral_equations::STATES;
use crate::{ReconstructError, Record};

/// Fits the lateral equations to several records, each under one unknown excitation.
///
/// ```text
/// beta' = Y_beta beta + Y_p p + Y_r r + (g/U) phi + Y_j u_j
/// p'    = L_beta beta + L_p p + L_r r             + L_j u_j
/// r'    = N_beta beta + N_p p + N_r r             + N_j u_j
/// phi'  =                   p + tan(theta) r
/// ```
///
/// u_j is free in record j, and only the ratios of Y_j, L_j and N_j count. Y_p, Y_r, g/U and tan(theta), which hardly matter to what sensors read, are held near what they are in
/// flight, and side forces of controls are small beside their moments. The sensors are beta, p, r and, if it was recorded, phi, by name, in rad and s or any other angle and s.
///
/// `free` is a fit of the same records in which all entries of the matrices are free: from it come noise, hold, band, offsets, and a start. `holds` lists the holds that may be. By [`Fit::bayesian_criterion`] the result compares with `free`.
///
/// # Errors
///
/// [`ReconstructError::Option`] for other sensors; [`ReconstructError::Start`] where no start has a finite likelihood; those of [`identify`](super::identify).
///
/// # Example
///
/// Flights of an aircraft with L_p = -2 1/s, the aileron moved in one and the rudder in the other.
///
/// ```
#[doc = include_str!("../doctest/lateral_flights.md")]
/// use reconstruct::likelihood::{Hold, identify_lateral, lateral_test};
/// use reconstruct::output_error::Structure;
/// use reconstruct::{Options, reconstruct};
///
/// let records = [flight("aileron", 9.0, -0.4, 1.0)?, flight("rudder", 1.2, -3.5, 1.0)?];
/// let mut options = Options::default();
/// options.structure = Structure::BlackBox;
/// let found = reconstruct(&records, &options)?;
/// let free = found.fit().ok_or("no likelihood")?;
/// let lateral = identify_lateral(&records, free, &[Hold::ZeroOrder])?;
/// assert!(lateral_test(&lateral, free) > 0.01);
/// let l_p = lateral.derivatives.iter().find(|own| own.name == "L_p").ok_or("no L_p")?.estimate;
/// assert!((l_p.value + 2.0).abs() < 3.0 * l_p.standard_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify_lateral(
    records: &[Record],
    free: &Fit,
    holds: &[Hold],
) -> Result<Fit, ReconstructError> {
    fitted(records, free, holds, f64::INFINITY)
}

/// The same, given up as soon as the equations are certain to be rejected: the result is then on its way to an optimum.
pub(crate) fn identify_lateral_unless_rejected(
    records: &[Record],
    free: &Fit,
    holds: &[Hold],
) -> Result<Fit, ReconstructError> {
    /// Above minus twice the logarithm of the likelihood of `free`; with ten degrees of freedom a probability of 1e-9.
    const REJECTED: f64 = 60.0;
    fitted(records, free, holds, free.objective() + REJECTED)
}

fn fitted(
    records: &[Record],
    free: &Fit,
    holds: &[Hold],
    ceiling: f64,
) -> Result<Fit, ReconstructError> {
    let options = &free.options;
    let of_free = validation::check(records, std::slice::from_ref(&free.model), options)?;
    // The criteria compare in the same units.
    let units = sensor_units(records, options);
    let variances = variances(free, &units);
    let mut found: Vec<(Problem, Candidate)> = Vec::new();
    for &hold in holds {
        let layout = Layout { order: STATES, hold, ..of_free.clone() };
        let mut problem = Problem::new(layout, records, &units, options)?;
        let period = records[0].period().seconds();
        let own = lateral(records, &units, &problem.layout, period).ok_or_else(|| {
            let needed = "the lateral equations need sensors beta, p and r, none but phi beside them, and none with feedthrough";
            option("structure", needed.to_owned())
        })?;
        // The other hold moves the derivatives little.
        let starts = match found.last().and_then(|(_, last)| last.derivatives()) {
            Some(derivatives) => vec![derivatives.clone()],
            None => starts::starts(&own, &free.model, &problem.spectra),
        };
        problem.lateral = Some(own.clone());
        let best = best_optimum(&problem, &own, &starts, &variances, options, ceiling);
        found.extend(best.map(|best| (problem, best)));
    }
    found.sort_by(|(_, x), (_, y)| x.priced().total_cmp(&y.priced()));
    let evidence = found.get(1).map(|(_, other)| other.priced() - found[0].1.priced());
    let (problem, Candidate { optimum, reports, start }) =
        found.into_iter().next().ok_or_else(|| ReconstructError::Start {
            start: 0,
            message: "no start has a finite likelihood".to_owned(),
        })?;
    let found = Found { optimum, best_start: start, reports, rivals: Vec::new(), restarts: 0 };
    let sensors = problem.layout.sensors;
    let residuals = problem.spectra.iter().map(|spectrum| spectrum.residuals(sensors)).sum();
    conclude(records, &problem, (found, evidence), &units, residuals, options)
}

/// The probability that records which obey the lateral equations gain as much likelihood where all entries of the matrices are free: the likelihood-ratio test of `lateral`
/// against `free`, the fit that it was made from. What is known of derivatives beforehand takes the place of parameters; so many of them as rest on it are
/// degrees of freedom, too.
#[must_use]
pub fn lateral_test(lateral: &Fit, free: &Fit) -> f64 {
    let gain = lateral.objective() - free.objective();
    let fewer = free.parameters as f64 - lateral.parameters as f64;
    let degrees_of_freedom = (fewer + lateral.known_beforehand).max(1.0);
    chi_squared_survival(gain, degrees_of_freedom)
}

/// The best of all starts, and how each went.
struct Candidate {
    optimum: LocalOptimum,
    reports: Vec<StartReport>,
    start: usize,
}

impl Candidate {
    fn derivatives(&self) -> Option<&DVector<f64>> {
        self.optimum.evaluation.system.derivatives.as_ref()
    }

    /// The objective with the price of the coefficients that the records determine.
    fn priced(&self) -> f64 {
        self.optimum.objective + PRICE * self.optimum.evaluation.nuisance_rank as f64
    }
}

/// A short search from each start, and on from the best of them.
fn best_optimum(
    problem: &Problem,
    own: &LateralParameters,
    starts: &[DVector<f64>],
    variances: &[f64],
    options: &Options,
    ceiling: f64,
) -> Option<Candidate> {
    const STEPS: usize = 15;
    const UPDATES: usize = 2;
    const TOLERANCE: f64 = 0.3;
    let residuals: f64 =
        problem.spectra.iter().map(|spectrum| spectrum.residuals(problem.layout.sensors)).sum();
    let mut full = options.clone();
    full.search.directions = InputDirections::AsStarted;
    let search = full.search.at_most(STEPS, UPDATES).no_finer_than(TOLERANCE, TOLERANCE);
    let short = Options { search, ..full.clone() };
    let mut reports = Vec::with_capacity(starts.len());
    let mut best: Option<(usize, LocalOptimum)> = None;
    for (index, start) in starts.iter().enumerate() {
        let evaluation = own.system(start.clone()).map(|own| problem.evaluate(own, variances));
        let cost_at_start = evaluation.as_ref().map_or(f64::NAN, |there| there.cost);
        let found = evaluation.filter(|there| there.cost.is_finite()).map(|there| {
            optimise(problem, there, variances.to_vec(), residuals, &short, Some(ceiling))
        });
        reports.push(StartReport {
            cost_at_start,
            direction_replaced: vec![false; problem.layout.records],
            objective: found.as_ref().map_or(f64::INFINITY, |found| found.objective),
            search: found.as_ref().map(|found| found.search.clone()),
        });
        if let Some(found) = found.filter(|found| found.objective.is_finite())
            && best.as_ref().is_none_or(|(_, best)| found.objective < best.objective)
        {
            best = Some((index, found));
        }
        // Derivatives that are not rejected are those of this aircraft.
        if best.as_ref().is_some_and(|(_, best)| best.objective < ceiling) && ceiling.is_finite() {
            break;
        }
    }
    let (start, mut optimum) = best?;
    if optimum.objective < ceiling {
        let LocalOptimum { evaluation, variances, .. } = optimum;
        optimum = optimise(problem, evaluation, variances, residuals, &full, Some(ceiling));
    }
    optimum.objective.is_finite().then_some(Candidate { optimum, reports, start })
}

/// The variances of a fit's noise in these units, and the square of its model error.
fn variances(fit: &Fit, units: &[f64]) -> Vec<f64> {
    let mut variances = vec![1.0; units.len()];
    for ((variance, level), unit) in
        variances.iter_mut().zip(fit.noise_levels.iter().flatten()).zip(units)
    {
        *variance = (level.value / unit).powi(2);
    }
    variances.extend(fit.model_error.map(|error| error.value * error.value));
    variances
}

#[cfg(test)]
mod tests;
