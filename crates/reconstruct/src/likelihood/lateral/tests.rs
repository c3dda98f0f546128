use lti::SamplePeriod;
use nalgebra::DVector;

use super::*;
use crate::likelihood::ComplexEstimate;
use crate::likelihood::fixtures::Normal;
use crate::model::lateral_equations::{LateralEquations, NAMES};
use crate::output_error::Structure;
use crate::{Channel, Doubt, Reconstruction, reconstruct};

const PERIOD: f64 = 0.05;
const SAMPLES: usize = 1600;
/// Derivatives of a small aircraft in the order of the equations.
const DERIVATIVES: [f64; NAMES.len()] =
    [-0.18, 0.06, -0.98, 0.07, -8.0, -2.0, 0.8, 5.2, -0.12, -0.6, 0.05];
const AILERON: [f64; 3] = [0.0, 9.0, -0.4];
const RUDDER: [f64; 3] = [0.03, 1.2, -3.5];
/// How far each of them goes with the speed, as an exponent.
const BY_SPEED: [i32; NAMES.len()] = [1, -2, 0, -1, 2, 1, 1, 2, 1, 1, -2];

/// The aircraft with one control, so many times as fast.
fn planted(control: [f64; 3], speed: f64) -> (LateralEquations, DVector<f64>) {
    let equations = LateralEquations::new(&["beta", "p", "r"], 1, Hold::ZeroOrder, PERIOD).unwrap();
    let mut parameters = DVector::zeros(equations.parameters());
    for (k, exponent) in BY_SPEED.iter().enumerate() {
        parameters[k] = DERIVATIVES[k] * speed.powi(*exponent);
    }
    parameters.rows_mut(NAMES.len(), 3).copy_from_slice(&control);
    (equations, parameters)
}

/// A flight in which one control moves, so many times as fast; beta may be late.
fn fly(name: &str, control: [f64; 3], speed: f64, late: usize, normal: &mut Normal) -> Record {
    let equations = LateralEquations::new(&["beta", "p", "r"], 1, Hold::ZeroOrder, PERIOD).unwrap();
    let mut parameters = DVector::zeros(equations.parameters());
    for (k, exponent) in BY_SPEED.iter().enumerate() {
        parameters[k] = DERIVATIVES[k] * speed.powi(*exponent);
    }
    parameters.rows_mut(NAMES.len(), 3).copy_from_slice(&control);
    let sampled = equations.sampled(&parameters).unwrap();
    let noise = [1e-3, 2e-3, 1e-3];
    let mut state = DVector::zeros(STATES);
    let (mut sensors, mut surface) = (vec![Vec::new(); 3], 0.0);
    for k in 0..SAMPLES {
        if k % 8 == 0 {
            surface = 0.03 * normal.next();
        }
        for (sensor, values) in sensors.iter_mut().enumerate() {
            values.push(state[sensor] + noise[sensor] * normal.next());
        }
        state = &sampled.a * &state + sampled.b.column(0) * surface;
    }
    sensors[0].rotate_right(late);
    let channels = ["beta", "p", "r"].into_iter().zip(sensors);
    let channels = channels.map(|(name, values)| Channel::new(name, values)).collect();
    Record::new(name, SamplePeriod::new(PERIOD).unwrap(), channels).unwrap()
}

fn flights(speed: f64, late: usize, seed: u64) -> Vec<Record> {
    let mut normal = Normal::new(seed);
    vec![
        fly("aileron", AILERON, 1.0, late, &mut normal),
        fly("rudder", RUDDER, speed, late, &mut normal),
    ]
}

fn found(records: &[Record], structure: Structure) -> Reconstruction {
    reconstruct(records, &crate::Options { structure, ..crate::Options::default() }).unwrap()
}

#[test]
fn planted_derivatives_are_found_and_modes_scatter_less() {
    let records = flights(1.0, 0, 3);
    let lateral = found(&records, Structure::Automatic);
    assert!(lateral.doubts.is_empty(), "{:?}", lateral.doubts);
    let compared = lateral.compared_form().unwrap();
    assert!(!compared.is_lateral && compared.p_value > 0.01, "{compared:?}");
    let fit = lateral.fit().unwrap();
    assert_eq!((fit.derivatives.len(), fit.identifiable), (NAMES.len(), NAMES.len() + 4));
    for (own, planted) in fit.derivatives.iter().zip(DERIVATIVES) {
        let error = (own.estimate.value - planted).abs() / own.estimate.standard_error;
        assert!(error < 3.0, "{} is {} for {planted}", own.name, own.estimate.value);
    }
    let l_p = &fit.derivatives[NAMES.iter().position(|name| *name == "L_p").unwrap()];
    assert!(l_p.estimate.standard_error < 0.1, "{l_p:?}");
    let free = found(&records, Structure::BlackBox);
    assert!(free.compared_form().is_none());
    let scatter = |found: &Reconstruction| -> f64 {
        let modes = &found.fit().unwrap().modes;
        modes.iter().map(|mode| mode.continuous.covariance.trace()).sum::<f64>().sqrt()
    };
    assert!(scatter(&lateral) < 0.8 * scatter(&free), "{} {}", scatter(&lateral), scatter(&free));
}

#[test]
fn phi_may_be_read_as_well() {
    let mut normal = Normal::new(9);
    let mut with_phi = |name: &str, control| {
        let record =
            fly(name, control, 1.0, 0, &mut Normal::new(if name == "rudder" { 4 } else { 6 }));
        let channels: Vec<_> = record.channels().to_vec();
        let mut phi = vec![0.0];
        for k in 1..SAMPLES {
            let rate = |k: usize| channels[1].values[k] + 0.05 * channels[2].values[k];
            phi.push(phi[k - 1] + 0.5 * PERIOD * (rate(k - 1) + rate(k)));
        }
        phi.iter_mut().for_each(|value| *value += 2e-3 * normal.next());
        let channels = channels.into_iter().chain([Channel::new("phi", phi)]).collect();
        Record::new(name, record.period(), channels).unwrap()
    };
    let records = vec![with_phi("aileron", AILERON), with_phi("rudder", RUDDER)];
    let lateral = found(&records, Structure::Lateral);
    let fit = lateral.fit().unwrap();
    assert_eq!(fit.model.c.shape(), (4, STATES));
    assert!((fit.derivatives[5].estimate.value / DERIVATIVES[5] - 1.0).abs() < 0.2, "{fit:?}");
}

#[test]
fn a_late_sensor_contradicts_the_equations() {
    let records = flights(1.0, 4, 5);
    let open = found(&records, Structure::Automatic);
    let compared = open.compared_form().unwrap();
    assert!(compared.is_lateral && compared.p_value < 1e-6, "{compared:?}");
    assert!(open.fit().unwrap().derivatives.is_empty());
    let asked = found(&records, Structure::Lateral);
    let contradicted = |doubt: &Doubt| matches!(doubt, Doubt::StructureContradicted { .. });
    assert!(asked.doubts.iter().any(contradicted), "{:?}", asked.doubts);
    assert!(!asked.fit().unwrap().derivatives.is_empty());
}

#[test]
fn records_flown_at_other_speeds_are_told_apart() {
    let at_speeds = found(&flights(1.15, 0, 7), Structure::Automatic);
    let conditions = at_speeds.doubts.iter().find_map(|doubt| match doubt {
        Doubt::ConditionsDiffer { conditions, p_value } if *p_value < 1e-4 => Some(conditions),
        _ => None,
    });
    let conditions = conditions.unwrap_or_else(|| panic!("{:?}", at_speeds.doubts));
    let ratio = conditions[1].speed_ratio;
    assert!((ratio.value - 1.15).abs() < 3.0 * ratio.standard_error, "{ratio:?}");
    assert!(ratio.standard_error < 0.08, "{ratio:?}");
    for (condition, speed) in conditions.iter().zip([1.0, 1.15]) {
        let (equations, parameters) = planted(AILERON, speed);
        for s in equations.continuous(&parameters).0.complex_eigenvalues().iter() {
            if s.im < 0.0 {
                continue;
            }
            let off = |own: &&ComplexEstimate| (own.value - s).norm();
            let all = condition.eigenvalues.iter();
            let own = all.min_by(|x, y| off(x).total_cmp(&off(y))).unwrap();
            assert!(off(&own) < 3.0 * own.covariance.trace().sqrt(), "{s}: {condition:?}");
        }
    }
}

#[test]
fn the_gradient_by_derivatives_is_that_of_the_cost() {
    const STEP: f64 = 1e-5;
    let records = flights(1.0, 0, 11);
    let free = found(&records, Structure::BlackBox);
    let free = free.fit().unwrap();
    let units = sensor_units(&records, &free.options);
    for hold in [Hold::ZeroOrder, Hold::FirstOrder] {
        let layout = Layout { order: STATES, sensors: 3, records: 2, feedthrough: vec![], hold };
        let mut problem = Problem::new(layout, &records, &units, &free.options).unwrap();
        let own = lateral(&records, &units, &problem.layout, PERIOD).unwrap();
        problem.lateral = Some(own.clone());
        let derivatives = DVector::from_column_slice(&DERIVATIVES);
        let mut there = own.of_derivatives(&derivatives, &[AILERON, RUDDER]);
        // Off the optimum.
        there[4] *= 1.02;
        there[11] += 0.01;
        there[12] += 0.02;
        let at = |parameters: DVector<f64>| {
            let first = problem.evaluate(own.system(parameters).unwrap(), &[1.0; 3]);
            problem.evaluate_again(first, &[1.0; 3])
        };
        let here = at(there.clone());
        for k in 0..own.count() {
            let moved = |sign: f64| {
                let mut moved = there.clone();
                moved[k] += sign * STEP * there[k].abs().max(0.1);
                at(moved).cost
            };
            let slope = (moved(1.0) - moved(-1.0)) / (2.0 * STEP * there[k].abs().max(0.1));
            let limit = 1e-4 * (here.gram[(k, k)].sqrt() * here.cost.sqrt()).max(1.0);
            assert!((slope + 2.0 * here.descent[k]).abs() < limit, "{hold:?} {k}: {slope}");
        }
    }
}

#[test]
fn other_sensors_are_refused() {
    let mut records = flights(1.0, 0, 2);
    for record in &mut records {
        let channels = record.channels().iter().zip(["x", "p", "r"]);
        let channels =
            channels.map(|(channel, name)| Channel::new(name, channel.values.clone())).collect();
        *record = Record::new(record.name(), record.period(), channels).unwrap();
    }
    let options = crate::Options { structure: Structure::Lateral, ..crate::Options::default() };
    let error = reconstruct(&records, &options).unwrap_err().to_string();
    assert!(error.contains("beta, p and r"), "{error}");
}
