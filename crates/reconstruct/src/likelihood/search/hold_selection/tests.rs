use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::*;
use crate::Measurement;
use crate::likelihood::cost::evaluation::Problem;
use crate::likelihood::cost::first_order_hold::FirstOrder;
use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::fixtures::{
    Disturbance, Flights, Normal, QUIET, fly, given, misses, perturbed, system,
};
use crate::likelihood::options::SearchOptions;
use crate::likelihood::{Fit, InputDirections, bootstrap, fitted_transmissibilities, identify};

const EIGENVALUES: [Complex<f64>; 3] =
    [Complex::new(0.9, 0.3), Complex::new(0.6, 0.0), Complex::new(0.98, 0.0)];

/// A system, as it is seen under this hold.
fn planted(hold: Hold, normal: &mut Normal) -> SharedModel {
    let mut model = system(&EIGENVALUES, 3, 2, normal);
    if hold == Hold::FirstOrder {
        let layout = Layout { order: 4, sensors: 3, records: 2, feedthrough: vec![], hold };
        let d = vec![DVector::zeros(3); 2];
        let (a, c, b) = (model.a.clone(), model.c.clone(), model.b.clone());
        let mut seen = System { a, c, b, d, derivatives: None };
        FirstOrder::new(&seen.a).unwrap().tie(&mut seen, &layout);
        model.feedthrough = Some(seen.d);
    }
    model
}

fn flights(hold: Hold, seed: u64, noise: f64) -> (Flights, Vec<SharedModel>) {
    let mut normal = Normal::new(seed);
    let model = planted(hold, &mut normal);
    let flights = fly(&model, &[600, 500], &Disturbance { noise, ..QUIET }, &mut normal);
    let starts = vec![perturbed(&model, 0.02, &mut normal)];
    (flights, starts)
}

fn assert_close(fit: &Fit) {
    for (distance, score) in misses(fit, &EIGENVALUES) {
        assert!(score < 5.0, "off by {distance}, {score} deviations");
    }
}

#[test]
fn what_is_held_is_found_to_be() {
    let (flights, starts) = flights(Hold::ZeroOrder, 31, 0.01);
    let fit = identify(&flights.records, &starts, &given(&flights.levels)).unwrap();
    assert_eq!(fit.hold, Hold::ZeroOrder);
    assert!(fit.hold_evidence.unwrap() >= CERTAIN);
    assert!(fit.model.feedthrough.is_none() && fit.feedthrough_sensors.is_empty());
    assert_close(&fit);
}

#[test]
fn known_inputs_do_not_speak_for_straight_lines() {
    // Little tells the holds apart under so much noise, and two more inputs would bring six numbers a record.
    let mut straight = 0;
    for seed in 41..=52 {
        let mut normal = Normal::new(seed);
        let model = planted(Hold::ZeroOrder, &mut normal);
        let disturbance = Disturbance { noise: 0.3, known: 0.5, ..QUIET };
        let flights = fly(&model, &[300, 250], &disturbance, &mut normal);
        let start = perturbed(&model, 0.02, &mut normal);
        let options = Options {
            measurement: Measurement {
                known_inputs: flights.known.clone(),
                ..given(&flights.levels).measurement.clone()
            },
            ..given(&flights.levels)
        };
        let fit = identify(&flights.records, &[start], &options).unwrap();
        let decided = fit.hold_evidence.is_some_and(|evidence| evidence > DECISIVE);
        straight += usize::from(decided && fit.hold == Hold::FirstOrder);
    }
    assert!(straight <= 1, "{straight} of 12");
}

#[test]
fn what_moves_on_is_found_to() {
    let (flights, starts) = flights(Hold::FirstOrder, 32, 0.01);
    let options = given(&flights.levels);
    let fit = identify(&flights.records, &starts, &options).unwrap();
    assert_eq!(fit.hold, Hold::FirstOrder);
    assert!(fit.hold_evidence.unwrap() > 100.0);
    assert!((fit.chi_squared.per_degree_of_freedom() - 1.0).abs() < 0.15);
    assert_close(&fit);

    let held = Options { hold: Some(Hold::ZeroOrder), ..options.clone() };
    let held = identify(&flights.records, &starts, &held).unwrap();
    assert_eq!((held.hold, held.hold_evidence), (Hold::ZeroOrder, None));
    assert!(held.chi_squared.per_degree_of_freedom() > 1.5);
}

#[test]
fn a_hold_that_was_given_is_used() {
    let (flights, starts) = flights(Hold::FirstOrder, 33, 0.01);
    let options = Options { hold: Some(Hold::FirstOrder), ..given(&flights.levels) };
    let fit = identify(&flights.records, &starts, &options).unwrap();
    assert_eq!((fit.hold, fit.hold_evidence), (Hold::FirstOrder, None));
    assert_close(&fit);
    // It costs no parameter.
    assert_eq!(fit.identifiable, 4 * 2 + 3 * 4 - 2);
    assert_eq!(fit.determined, fit.identifiable);
}

#[test]
fn without_noise_the_system_comes_out_exactly() {
    let (flights, starts) = flights(Hold::FirstOrder, 34, 0.0);
    let fit = identify(&flights.records, &starts, &given(&flights.levels)).unwrap();
    assert_eq!(fit.hold, Hold::FirstOrder);
    for (distance, _) in misses(&fit, &EIGENVALUES) {
        assert!(distance < 1e-9, "{distance:e}");
    }
}

#[test]
fn the_model_explains_the_records_by_itself() {
    // With d_j as free numbers and not a step taken, the cost is the same: the model is complete without the hold's name.
    let (flights, starts) = flights(Hold::FirstOrder, 35, 0.02);
    let options = given(&flights.levels);
    let fit = identify(&flights.records, &starts, &options).unwrap();
    let untied = Options {
        hold: Some(Hold::ZeroOrder),
        measurement: Measurement {
            feedthrough_sensors: vec![0, 1, 2],
            ..options.measurement.clone()
        },
        search: SearchOptions {
            directions: InputDirections::AsStarted,
            max_steps: 0,
            ..options.search.clone()
        },
        ..options
    };
    let again = identify(&flights.records, std::slice::from_ref(&fit.model), &untied).unwrap();
    assert!((again.chi_squared.value / fit.chi_squared.value - 1.0).abs() < 1e-9);
}

#[test]
fn the_covariance_knows_every_entry_of_the_feedthrough() {
    let (flights, starts) = flights(Hold::FirstOrder, 36, 0.02);
    let fit = identify(&flights.records, &starts, &given(&flights.levels)).unwrap();
    assert_eq!(fit.feedthrough_sensors, [0, 1, 2]);
    let size = 4 * 4 + 3 * 4 + 2 * (4 + 3);
    assert_eq!(fit.covariance.shape(), (size, size));
    // The deviation of a transmissibility, from repetitions: also that of the feedthrough in it.
    let truth = planted(Hold::FirstOrder, &mut Normal::new(36));
    let frequency = [2.0];
    let mut scores = Vec::new();
    let found = fitted_transmissibilities(&fit, &frequency).unwrap();
    for (place, one) in found.iter().enumerate() {
        let exact = exact_transmissibility(&truth, one.record, one.from, one.to, frequency[0]);
        let response = &found[place].response[0];
        scores.push((response.value - exact).norm() / response.covariance.trace().sqrt());
    }
    assert!(scores.iter().all(|&score| score < 4.0), "{scores:?}");
    assert!(scores.iter().any(|&score| score > 0.1), "{scores:?}");
}

fn exact_transmissibility(
    model: &SharedModel,
    record: usize,
    from: usize,
    to: usize,
    frequency: f64,
) -> Complex<f64> {
    let z = Complex::from_polar(1.0, frequency * model.period.seconds());
    let pencil = DMatrix::identity(4, 4) * z - model.a.map(Complex::from);
    let states = pencil.try_inverse().unwrap() * model.b[record].map(Complex::from);
    let gains = model.c.map(Complex::from) * states
        + model.feedthrough.as_ref().unwrap()[record].map(Complex::from);
    gains[to] / gains[from]
}

#[test]
fn a_bootstrap_keeps_the_hold() {
    let (flights, starts) = flights(Hold::FirstOrder, 37, 0.002);
    let options = given(&flights.levels);
    let fit = identify(&flights.records, &starts, &options).unwrap();
    let mut normal = Normal::new(38);
    let repeated = bootstrap(&flights.records, &fit, 40, &mut || normal.next()).unwrap();
    for (mode, estimate) in repeated.modes.iter().zip(&fit.modes) {
        let [own, fitted] =
            [&mode.continuous, &estimate.continuous].map(|value| value.covariance.trace().sqrt());
        assert!((own / fitted - 1.0).abs() < 0.4, "{own} beside {fitted}");
    }
}

#[test]
fn a_problem_is_left_with_the_hold_that_was_found() {
    let (flights, starts) = flights(Hold::FirstOrder, 39, 0.01);
    let options = given(&flights.levels);
    let layout =
        Layout { order: 4, sensors: 3, records: 2, feedthrough: vec![], hold: Hold::ZeroOrder };
    let mut problem = Problem::new(layout, &flights.records, &flights.levels, &options).unwrap();
    let residuals = 2.0 * 1100.0;
    let (found, evidence) =
        search_over_holds(&mut problem, &starts, &flights.levels, residuals, &options).unwrap();
    assert_eq!(problem.layout.hold, Hold::FirstOrder);
    assert_eq!((found.reports.len(), found.best_start), (1, 0));
    assert!(evidence.unwrap() > DECISIVE);
}
