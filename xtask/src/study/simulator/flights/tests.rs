use super::*;
use crate::study::definition::Study;
use crate::study::simulator::SimulatorStudy;

#[test]
fn every_flight_of_the_study_is_there() {
    let study = SimulatorStudy::new().unwrap();
    let kinds = study.kinds();
    assert_eq!(kinds.len(), 54 + 36);
    for kind in kinds {
        let Flight { records, inputs } = read(&study.folder, kind).unwrap();
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

#[test]
fn the_truth_has_the_aircraft_of_the_study() {
    let truth = SimulatorStudy::new().unwrap().truth;
    assert_eq!(truth.0.len(), Aircraft::ALL.len());
    for aircraft in Aircraft::ALL {
        let modes = truth.of(aircraft).unwrap().modes();
        assert!(modes.roll.re < modes.spiral.re && modes.dutch_roll.im > 0.0, "{aircraft:?}");
    }
    // The 787-8's spiral is unstable, the Cub's roll the fastest.
    assert!(truth.of(Aircraft::Boeing787).unwrap().modes().spiral.re > 0.01);
    assert!(truth.of(Aircraft::Cub).unwrap().modes().roll.re < -12.0);
}

#[test]
fn columns_become_sensors() {
    let text = "time,beta,p,r,d_rudder\n0,1,2,3,4\n0.5,-4e-1,5,6,5\n1,7,8,9,6\n";
    let (record, moved) = parse("rudder", text).unwrap();
    assert_eq!(moved, [vec![0.0; 3], vec![4.0, 5.0, 6.0]]);
    assert_eq!((record.name(), record.period().seconds()), ("rudder", 0.5));
    let found: Vec<_> =
        record.channels().iter().map(|c| (c.name.as_str(), c.values.as_slice())).collect();
    let expected: [(&str, &[f64]); 3] =
        [("beta", &[1.0, -0.4, 7.0]), ("p", &[2.0, 5.0, 8.0]), ("r", &[3.0, 6.0, 9.0])];
    assert_eq!(found, expected);
}

#[test]
fn a_bad_file_says_where() {
    for (text, expected) in [
        ("", "the first columns must be time,beta,p,r"),
        ("time,beta,r,p\n", "the first columns must be time,beta,p,r"),
        ("time,beta,p,r\n0,1,2,3\n", "fewer than two samples"),
        ("time,beta,p,r\n0,1,2\n", "line 2: \"0,1,2\" is not 4 numbers"),
        ("time,beta,p,r\n0,1,2,3\n1,1,x,3\n", "line 3: \"1,1,x,3\" is not 4 numbers"),
        ("time,beta,p,r\n0,1,2,3\n1,1,2,3\n3,1,2,3\n", "line 3: a step other than 1.5 s"),
    ] {
        assert_eq!(parse("x", text).unwrap_err(), expected);
    }
}
