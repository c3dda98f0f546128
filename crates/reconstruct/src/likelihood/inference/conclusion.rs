//! From the best local optimum to the result: standard errors, tests of fit, the sensors' units.

use std::f64::consts::TAU;

use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};

use super::derivatives::derivatives;
use super::fit::{Contrast, Fit, Rival};
use super::goodness_of_fit::{self, ChiSquared};
use super::offset_test::offset_test;
use super::uncertainty::{self, Mode, ModelBias};
use crate::likelihood::cost::accumulate::Scalars;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::first_order_hold::FirstOrder;
use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::options::{Noise, Options};
use crate::likelihood::search::hold_selection::PRICE;
use crate::likelihood::search::local_search::LocalOptimum;
use crate::likelihood::search::multistart::Found;
use crate::model::lateral_equations::NAMES;
use crate::{Offsets, ReconstructError, Record};

pub(crate) fn conclude(
    records: &[Record],
    problem: &Problem,
    (found, hold_evidence): (Found, Option<f64>),
    units: &[f64],
    residuals: f64,
    options: &Options,
) -> Result<Fit, ReconstructError> {
    let layout = &problem.layout;
    let estimated = options.noise.is_estimated();
    let Found { optimum, best_start, reports, rivals, restarts } = found;
    let LocalOptimum { mut evaluation, mut variances, search, objective, direction_replaced: _ } =
        optimum;
    let identifiable = problem.identifiable();
    let parameters = (identifiable + evaluation.nuisance_rank) as f64;
    let criterion = objective + PRICE * parameters;
    let degrees_of_freedom = (residuals - parameters).max(1.0);
    if estimated {
        // The restricted likelihood leaves out the excitations; the parameters took their share of the residuals, too.
        let share = evaluation.cost / degrees_of_freedom;
        if share > 0.0 && share.is_finite() {
            variances.iter_mut().zip(&problem.floors).for_each(|(variance, floor)| {
                *variance = (*variance * share).max(*floor);
            });
        }
    }
    if problem.lateral.is_none() {
        evaluation.system = evaluation.system.normalised();
    }
    evaluation = problem.evaluate_again(evaluation, &variances);
    let mut noise_part = DMatrix::zeros(layout.parameters(), layout.parameters());
    let cells = layout.local_cells();
    let hold = problem.tie(&mut evaluation.system);
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
        let tangent = hold.as_ref().map(|hold| hold.tangent(&evaluation.system, record, layout));
        layout.add(record, tangent.as_ref(), sums.gram_of(&cells), &mut noise_part);
        whiteness.push(goodness_of_fit::whiteness(
            source.name(),
            &problem.spectra[record],
            sums.spectrum.as_deref().unwrap_or_default(),
            layout.sensors,
        ));
    }
    let contrasts = contrasts(problem, &evaluation, &variances, degrees_of_freedom);
    let offset_test = if options.measurement.offsets == Offsets::Zero {
        offset_test(problem, &evaluation, &variances, degrees_of_freedom)
    } else {
        None
    };
    let invariants = problem.invariant_tangents(&evaluation.system);
    let of_parameters = match &evaluation.tangent {
        None => uncertainty::covariance(&evaluation.gram, &noise_part, &invariants),
        Some(tangent) => {
            let noise_part = tangent.tr_mul(&(noise_part * tangent));
            uncertainty::covariance(&evaluation.gram, &noise_part, &invariants)
        }
    };
    let determined = of_parameters.determined;
    let known_beforehand = problem.known_beforehand(&evaluation.system, &of_parameters.matrix);
    let of_entries = match &evaluation.tangent {
        None => of_parameters.matrix.clone(),
        Some(tangent) => tangent * &of_parameters.matrix * tangent.transpose(),
    };
    let period = records[0].period();
    let n = layout.order;
    let longest = records.iter().map(Record::samples).max().unwrap_or(1) as f64;
    let bias = ModelBias {
        model_error: variances.get(layout.sensors).map_or(0.0, |square| square.sqrt()),
        resolution: TAU / (longest * period.seconds()),
    };
    let states = of_entries.view((0, 0), (n * n, n * n)).into_owned();
    let modes =
        uncertainty::modes(&evaluation.system.a, period, &states, bias).map_err(|error| {
            ReconstructError::Step {
                step: "modes of the fitted system",
                message: error.to_string(),
            }
        })?;
    let noise_levels = match options.noise {
        Noise::Spectra(_) => None,
        _ => Some(uncertainty::noise_levels(&evaluation, &variances, units, estimated)),
    };
    let (derivatives, correlations) = match &evaluation.system.derivatives {
        Some(own) => derivatives(
            NAMES.iter().map(|&name| name.to_owned()).collect(),
            own,
            &of_parameters.matrix,
            bias.model_error,
        ),
        None => (Vec::new(), DMatrix::zeros(0, 0)),
    };
    let model_error = uncertainty::model_error(&evaluation, &variances, layout.sensors);
    let record_chi_squared = evaluation
        .record_costs
        .iter()
        .zip(&problem.spectra)
        .map(|(cost, spectrum)| {
            cost / (spectrum.residuals(layout.sensors) * degrees_of_freedom / residuals)
        })
        .collect();
    // The reported model has an entry of d_j for each sensor that has one, free or not.
    let untied = layout.untied();
    let covariance = match &hold {
        Some(hold) => with_tied(&of_entries, hold, &evaluation.system, layout),
        None => of_entries,
    };
    Ok(Fit {
        covariance: in_sensor_units(&covariance, units, &untied),
        model: evaluation.system.model(units, &untied, period),
        feedthrough_sensors: untied.feedthrough,
        options: Options { hold: Some(layout.hold), ..options.clone() },
        hold: layout.hold,
        hold_evidence,
        criterion,
        parameters: identifiable + evaluation.nuisance_rank,
        determined,
        identifiable,
        derivatives,
        correlations,
        lateral: evaluation.system.derivatives.clone(),
        known_beforehand,
        noise_levels,
        model_error,
        chi_squared: ChiSquared::new(evaluation.cost, degrees_of_freedom, estimated),
        record_chi_squared,
        whiteness,
        contrasts,
        offset_test,
        search,
        starts: reports,
        best_start,
        restarts,
        rivals: rivals
            .into_iter()
            .filter_map(|(above, system)| rival(above, &system.a, period))
            .filter(|rival| !is_this(rival, &modes))
            .collect(),
        modes,
    })
}

/// What it costs that one record takes the direction of another.
fn contrasts(
    problem: &Problem,
    optimum: &Evaluation,
    variances: &[f64],
    degrees_of_freedom: f64,
) -> Vec<Contrast> {
    let unit = (optimum.cost / degrees_of_freedom).max(f64::MIN_POSITIVE);
    let rise = |taken: usize, from: usize| {
        let mut system = optimum.system.clone();
        system.b[taken] = system.b[from].clone();
        system.d[taken] = system.d[from].clone();
        let there = problem.evaluate(system, variances);
        (there.record_costs[taken] - optimum.record_costs[taken]) / unit
    };
    let pairs = (0..problem.layout.records)
        .flat_map(|second| (0..second).map(move |first| (first, second)));
    pairs
        .map(|(first, second)| Contrast {
            records: [first, second],
            statistic: rise(first, second).min(rise(second, first)),
        })
        .collect()
}

/// Whether a rival is the same system, which its search came less close to.
fn is_this(rival: &Rival, modes: &[Mode]) -> bool {
    // The search ends within a thousandth of a deviation, those of rivals within a tenth.
    const CLOSE: f64 = 0.3;
    rival.eigenvalues.len() == modes.len()
        && rival.eigenvalues.iter().zip(modes).all(|(s, mode)| {
            let deviation = mode.continuous.covariance.trace().sqrt();
            (s - mode.continuous.value).norm() <= CLOSE * deviation
        })
}

/// `None` where the eigenvalues cannot be computed: then it is not reported.
fn rival(above: f64, a: &DMatrix<f64>, period: SamplePeriod) -> Option<Rival> {
    let modes =
        uncertainty::modes(a, period, &DMatrix::zeros(a.len(), a.len()), ModelBias::default())
            .ok()?;
    let eigenvalues = modes.into_iter().map(|mode| mode.continuous.value).collect();
    Some(Rival { above, eigenvalues })
}

/// The covariance with the entries of d_j that follow from the other parameters.
fn with_tied(
    covariance: &DMatrix<f64>,
    hold: &FirstOrder,
    system: &System,
    layout: &Layout,
) -> DMatrix<f64> {
    let untied = layout.untied();
    let mut slopes = DMatrix::zeros(untied.parameters(), layout.parameters());
    for record in 0..layout.records {
        let tangent = hold.tangent(system, record, layout);
        for i in 0..tangent.nrows() {
            for k in 0..tangent.ncols() {
                slopes[(untied.global(i, record), layout.global(k, record))] = tangent[(i, k)];
            }
        }
    }
    &slopes * covariance * slopes.transpose()
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
