use super::*;
use crate::shared::simulator_flights::read;
use crate::study::definition::Study;
use crate::study::simulator::SimulatorStudy;
use crate::study::simulator::kind::{Aircraft, Kind, Motion};

fn estimate(re: f64, im: f64, standard_error: Option<f64>) -> Estimate {
    Estimate { s: Complex::new(re, im), standard_error }
}

#[test]
fn the_closest_eigenvalue_is_judged() {
    let estimates = [
        estimate(-3.0, 0.0, Some(0.5)),
        estimate(-0.5, -2.25, Some(0.125)),
        estimate(0.25, 0.0, Some(0.0)),
    ];
    // A pair counts with its upper half, whichever half is given.
    let dutch_roll = judged_mode(&estimates, Complex::new(-0.25, 2.25)).unwrap();
    assert_eq!(
        dutch_roll,
        JudgedMode { error: 0.25, real_error: -0.25, standard_error: Some(0.125) }
    );
    assert_eq!(dutch_roll.score(), Some(-2.0));
    let roll = judged_mode(&estimates, Complex::from(-2.5)).unwrap();
    assert_eq!((roll.error, roll.score()), (0.5, Some(-1.0)));
    // A standard error of nothing is none.
    let spiral = judged_mode(&estimates, Complex::from(0.0)).unwrap();
    assert_eq!((spiral.error, spiral.score()), (0.25, None));
    assert_eq!(judged_mode(&[], Complex::from(0.0)), None);
}

#[test]
fn a_flight_is_judged_against_its_own_truth() {
    let study = SimulatorStudy::new().unwrap();
    let kind = Kind { motion: Motion::Multistep, aircraft: Aircraft::Concorde, recorded: false };
    let own = study.run(kind, 1).unwrap();
    let found = own.result.clone().unwrap();
    assert!(found.modes[2].error < 0.1, "{found:?}");
    // As it is kept.
    let kept = serde_json::to_string(&own).unwrap();
    assert_eq!(serde_json::from_str::<Outcome>(&kept).unwrap(), own);
    // Beside another aircraft the same estimates are wrong.
    let other = study.truth.of("737").unwrap().modes();
    let flight = read(&study.folder, kind.aircraft.name(), kind.motion.name()).unwrap();
    assert!(run(flight, false, &other).result.unwrap().modes[2].error > 0.5);
}

#[test]
fn a_refusal_is_kept() {
    let study = SimulatorStudy::new().unwrap();
    let kind = Kind { motion: Motion::Multistep, aircraft: Aircraft::Concorde, recorded: false };
    let mut flight = read(&study.folder, kind.aircraft.name(), kind.motion.name()).unwrap();
    flight.records.truncate(1);
    let truth = study.truth.of(kind.aircraft.name()).unwrap().modes();
    assert!(!run(flight, false, &truth).result.unwrap_err().is_empty());
}
