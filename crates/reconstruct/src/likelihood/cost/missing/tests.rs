use nalgebra::DVector;
use num_complex::Complex;

use crate::likelihood::FrequencyBand;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::fixtures::{Disturbance, Normal, fly, given, system};
use crate::likelihood::options::{Noise, Options};
use crate::model::Hold;
use crate::{Record, SharedModel};

const SENSORS: usize = 3;
const VARIANCES: [f64; SENSORS] = [0.8, 1.0, 1.2];

/// Two records, a system that is not theirs, and their noise levels.
fn flown() -> (Vec<Record>, SharedModel, Vec<f64>) {
    let mut normal = Normal::new(11);
    let model = system(&[Complex::new(0.8, 0.4), Complex::from(0.9)], SENSORS, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[90, 75], &disturbance, &mut normal);
    let mut off = |entry: f64| entry * (1.0 + 0.02 * normal.next());
    let b = model.b.iter().map(|b| b.map(&mut off)).collect();
    let model = SharedModel { c: model.c.map(&mut off), b, ..model };
    (flights.records, model, flights.levels)
}

/// Rows, neighbours, single sensors, and an edge.
const MISSING: [(usize, usize, usize); 9] = [
    (0, 0, 20),
    (0, 1, 20),
    (0, 2, 20),
    (0, 1, 21),
    (0, 1, 22),
    (1, 2, 0),
    (1, 0, 40),
    (1, 2, 63),
    (1, 0, 74),
];

fn with_missing(records: &[Record]) -> Vec<Record> {
    let one = |(index, record): (usize, &Record)| {
        let mut channels = record.marked();
        for &(_, sensor, sample) in MISSING.iter().filter(|(own, ..)| *own == index) {
            channels[sensor].values[sample] = f64::NAN;
        }
        Record::with_missing(record.name(), record.period(), channels).unwrap()
    };
    records.iter().enumerate().map(one).collect()
}

fn problem(records: &[Record], levels: &[f64], options: &Options) -> Problem {
    let layout = Layout {
        order: 3,
        sensors: SENSORS,
        records: 2,
        feedthrough: Vec::new(),
        hold: Hold::ZeroOrder,
    };
    Problem::new(layout, records, levels, options).unwrap()
}

fn settle(problem: &Problem, system: &System, variances: &[f64]) -> Evaluation {
    let first = problem.evaluate(system.clone(), variances);
    problem.evaluate_again(first, variances)
}

/// The cost of whole records, with these values in the places of the missing samples.
fn cost_with(
    records: &[Record],
    values: &[f64],
    model: &SharedModel,
    levels: &[f64],
    options: &Options,
) -> f64 {
    let whole = |(index, record): (usize, &Record)| {
        let mut channels = record.channels().to_vec();
        for (&(own, sensor, sample), value) in MISSING.iter().zip(values) {
            if own == index {
                channels[sensor].values[sample] = value * levels[sensor];
            }
        }
        Record::new(record.name(), record.period(), channels).unwrap()
    };
    let records: Vec<Record> = records.iter().enumerate().map(whole).collect();
    let problem = problem(&records, levels, options);
    let system = System::scaled(model, levels, &problem.layout);
    settle(&problem, &system, &VARIANCES).cost
}

/// The least cost that any values give, since the cost is a parabola in them.
fn least_cost(records: &[Record], model: &SharedModel, levels: &[f64], options: &Options) -> f64 {
    let count = MISSING.len();
    let cost = |values: &[f64]| cost_with(records, values, model, levels, options);
    let unit = |places: &[usize]| {
        let mut values = vec![0.0; count];
        places.iter().for_each(|&place| values[place] += 1.0);
        values
    };
    let nothing = cost(&unit(&[]));
    let single: Vec<f64> = (0..count).map(|i| cost(&unit(&[i]))).collect();
    let double: Vec<f64> = (0..count).map(|i| cost(&unit(&[i, i]))).collect();
    let curvature = nalgebra::DMatrix::from_fn(count, count, |i, k| {
        if i == k {
            (double[i] - 2.0 * single[i] + nothing) / 2.0
        } else {
            (cost(&unit(&[i, k])) - single[i] - single[k] + nothing) / 2.0
        }
    });
    let slope = DVector::from_fn(count, |i, _| single[i] - nothing - curvature[(i, i)]);
    nothing - slope.dot(&curvature.lu().solve(&slope).unwrap()) / 4.0
}

#[test]
fn the_cost_is_the_least_that_any_values_give() {
    let (records, model, levels) = flown();
    let band = Some(FrequencyBand { lowest_rad_s: 0.5, highest_rad_s: 20.0 });
    for options in [given(&levels), Options { band, ..given(&levels) }] {
        let gaps = with_missing(&records);
        let problem = problem(&gaps, &levels, &options);
        let system = System::scaled(&model, &levels, &problem.layout);
        let found = settle(&problem, &system, &VARIANCES).cost;
        let expected = least_cost(&records, &model, &levels, &options);
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} is not {expected}");
    }
}

#[test]
fn what_stands_in_the_missing_places_does_not_matter() {
    let (records, model, levels) = flown();
    let options = given(&levels);
    let gaps = with_missing(&records);
    let here = problem(&gaps, &levels, &options);
    let mut other = problem(&gaps, &levels, &options);
    let system = System::scaled(&model, &levels, &here.layout);
    let mut normal = Normal::new(3);
    for spectrum in &mut other.spectra {
        let missing = spectrum.missing.clone().unwrap();
        let samples = if missing.frequencies.len() == 46 { 90.0_f64 } else { 75.0 };
        for &(sensor, sample) in &missing.cells {
            let size = 10.0 * normal.next() / samples.sqrt();
            for (k, z) in spectrum.z.iter().enumerate() {
                let turn = -z.arg() * sample as f64;
                spectrum.y[k * SENSORS + sensor] += Complex::from_polar(size, turn);
            }
        }
    }
    let (here, other) = (settle(&here, &system, &VARIANCES), settle(&other, &system, &VARIANCES));
    assert!((here.cost / other.cost - 1.0).abs() < 1e-10);
    assert!((&here.descent - &other.descent).norm() < 1e-8 * here.descent.norm());
    assert!((&here.gram - &other.gram).norm() < 1e-8 * here.gram.norm());
    assert!((&here.score - &other.score).norm() < 1e-8 * here.score.norm());
}

#[test]
fn the_gradient_is_that_of_the_cost() {
    const STEP: f64 = 1e-5;
    let (records, model, levels) = flown();
    let problem = problem(&with_missing(&records), &levels, &given(&levels));
    let system = System::scaled(&model, &levels, &problem.layout);
    let here = settle(&problem, &system, &VARIANCES);
    for k in 0..problem.layout.parameters() {
        let cost = |sign: f64| {
            let mut step = DVector::zeros(problem.layout.parameters());
            step[k] = sign * STEP;
            settle(&problem, &system.moved(&step, &problem.layout), &VARIANCES).cost
        };
        let slope = (cost(1.0) - cost(-1.0)) / (2.0 * STEP);
        let error = (slope + 2.0 * here.descent[k]).abs();
        let limit = 1e-5 * here.gram[(k, k)].max(here.descent.norm());
        assert!(error < limit, "parameter {k}: {slope} for {}", -2.0 * here.descent[k]);
    }
}

#[test]
fn missing_samples_take_information_away() {
    let (records, model, levels) = flown();
    let options = given(&levels);
    let whole = problem(&records, &levels, &options);
    let gaps = problem(&with_missing(&records), &levels, &options);
    let system = System::scaled(&model, &levels, &whole.layout);
    let at = |problem: &Problem| settle(problem, &system, &VARIANCES);
    let (whole_at, gaps_at) = (at(&whole), at(&gaps));
    assert!(gaps_at.cost < whole_at.cost);
    let lost = (&whole_at.gram - &gaps_at.gram).symmetric_eigen().eigenvalues;
    // The estimates of the excitation differ, so that a little may be won.
    assert!(lost.max() > 1e-3 * whole_at.gram.trace());
    assert!(lost.min() > -1e-3 * whole_at.gram.trace(), "{lost}");
    let residuals = |problem: &Problem| -> f64 {
        problem.spectra.iter().map(|spectrum| spectrum.residuals(SENSORS)).sum()
    };
    assert!((residuals(&whole) - residuals(&gaps) - MISSING.len() as f64).abs() < 1e-12);
}

#[test]
fn the_score_is_the_slope_of_the_restricted_likelihood() {
    const STEP: f64 = 1e-5;
    let (records, model, levels) = flown();
    let noise = Noise::ModelError { first_guess: None };
    let with_model_error = Options { noise, ..Options::default() };
    for (options, variances) in [
        (Options::default(), VARIANCES.to_vec()),
        (with_model_error, VARIANCES.iter().copied().chain([0.01]).collect()),
    ] {
        let problem = problem(&with_missing(&records), &levels, &options);
        let system = System::scaled(&model, &levels, &problem.layout);
        let here = settle(&problem, &system, &variances);
        for level in 0..variances.len() {
            let objective = |sign: f64| {
                let mut moved = variances.clone();
                moved[level] += sign * STEP;
                let at = settle(&problem, &system, &moved);
                at.cost + at.log_determinant
            };
            let slope = (objective(1.0) - objective(-1.0)) / (2.0 * STEP);
            let error = (slope + here.score[level]).abs();
            assert!(error < 1e-4 * slope.abs().max(1.0), "{level}: {slope}, {}", here.score[level]);
        }
    }
}
