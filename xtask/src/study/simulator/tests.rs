use super::*;
use crate::shared::simulator_flights::{Flight, read};

#[test]
fn every_flight_of_the_study_is_there() {
    let study = SimulatorStudy::new().unwrap();
    let kinds = study.kinds();
    assert_eq!(kinds.len(), 54 + 36);
    for kind in kinds {
        let (aircraft, motion) = (kind.aircraft.name(), kind.motion.name());
        let Flight { records, inputs } = read(&study.folder, aircraft, motion).unwrap();
        let moves = |signal: &Vec<f64>| signal.iter().any(|value| value.abs() > 0.0);
        if kind.recorded {
            for surface in 0..2 {
                assert!(inputs.signals.iter().any(|signals| moves(&signals[surface])), "{kind:?}");
            }
        }
        if kind.motion == Motion::Both {
            assert_eq!(records.len(), 1);
            continue;
        }
        let samples = if kind.motion.name() == "multistep" { 600 } else { 2400 };
        for (record, surface) in records.iter().zip(["aileron", "rudder"]) {
            assert_eq!((record.name(), record.samples()), (surface, samples), "{kind:?}");
            assert!((record.period().seconds() - 0.05).abs() < 1e-12);
        }
        assert_ne!(records[0].channels(), records[1].channels());
    }
}
