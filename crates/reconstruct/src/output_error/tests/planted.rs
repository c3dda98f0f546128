use super::*;
use crate::subspace::OrderChoice;

#[test]
fn one_record_without_noise_gives_the_system_back() {
    let quiet = Flown { noise: [0.0; 3], ..BOTH };
    let (records, inputs) = flights(&[quiet], 1);
    let fit = identify(&records, &inputs, &Options::default()).unwrap();
    assert!(fit.doubts.is_empty(), "{:?}", fit.doubts);
    assert!(error(&fit.modes, &eigenvalues()) < 1e-4, "{}", error(&fit.modes, &eigenvalues()));
    assert_eq!(fit.hold, Hold::ZeroOrder);
}

#[test]
fn beside_noise_and_offsets_standard_errors_hold() {
    let (mut all, mut worst) = (Vec::new(), 0.0_f64);
    for seed in 1..=10 {
        let aileron = Flown { moved: [0.03, 0.0], offset: 0.02, ..BOTH };
        let rudder = Flown { moved: [0.0, 0.03], offset: -0.01, ..BOTH };
        let (records, inputs) = flights(&[aileron, rudder], seed);
        let fit = identify(&records, &inputs, &Options::default()).unwrap();
        assert!(fit.doubts.is_empty(), "{seed}: {:?}", fit.doubts);
        assert!(!fit.derivatives.is_empty(), "{seed}");
        worst = worst.max(error(&fit.modes, &eigenvalues()));
        all.extend(scores(&fit.modes, &eigenvalues()));
    }
    assert!(worst < 0.02, "{worst}");
    let within = all.iter().filter(|score| score.abs() < 2.0).count();
    assert!(10 * within >= 8 * all.len(), "{all:?}");
}

#[test]
fn gusts_are_no_obstacle() {
    let mut all = Vec::new();
    for seed in 1..=6 {
        let gusty = Flown { gust: 0.01, samples: 2400, ..BOTH };
        let (records, inputs) = flights(&[gusty], seed);
        let fit = identify(&records, &inputs, &Options::default()).unwrap();
        assert!(fit.doubts.is_empty(), "{seed}: {:?}", fit.doubts);
        assert!(error(&fit.modes, &eigenvalues()) < 0.2, "{seed}");
        all.extend(scores(&fit.modes, &eigenvalues()));
    }
    let within = all.iter().filter(|score| score.abs() < 3.0).count();
    assert!(10 * within >= 8 * all.len(), "{all:?}");
    // Gusts that move the aircraft more than the inputs do are as good as an input that is missing.
    let (records, inputs) = flights(&[Flown { gust: 0.03, ..BOTH }], 1);
    let fit = identify(&records, &inputs, &Options::default()).unwrap();
    assert!(fit.doubts.iter().any(Doubt::is_of_unrecorded_excitation), "{:?}", fit.doubts);
}

#[test]
fn the_derivatives_are_those_planted() {
    let (records, inputs) = flights(&[Flown { samples: 2400, ..BOTH }], 3);
    let options = Options { structure: Structure::Lateral, ..Options::default() };
    let fit = identify(&records, &inputs, &options).unwrap();
    assert!(fit.doubts.is_empty(), "{:?}", fit.doubts);
    assert_eq!(fit.derivatives.len(), DERIVATIVES.len());
    for (found, planted) in fit.derivatives.iter().zip(DERIVATIVES) {
        let off = (found.estimate.value - planted) / found.estimate.standard_error;
        assert!(off.abs() < 4.0, "{found:?}, planted {planted}");
    }
    let found = |name: &str| fit.derivatives.iter().find(|own| own.name == name).unwrap();
    assert!((found("L_aileron").estimate.value - 9.0).abs() < 0.1);
    assert_eq!(fit.correlations.shape(), (17, 17));
    assert!(fit.correlations.diagonal().iter().all(|own| (own - 1.0).abs() < 1e-12));
}

#[test]
fn a_black_box_finds_order_and_modes() {
    let (records, inputs) = flights(&[BOTH, BOTH], 4);
    let options = Options { structure: Structure::BlackBox, ..Options::default() };
    let fit = identify(&records, &inputs, &options).unwrap();
    assert_eq!(fit.model.a().nrows(), 4);
    assert!(fit.derivatives.is_empty());
    assert!(error(&fit.modes, &eigenvalues()) < 0.03);
    // Lower orders are far less likely.
    assert!(fit.compared.iter().any(|other| other.order == 3 && other.above > 100.0));
    let fixed = Options { order: OrderChoice::Fixed(5), ..options };
    assert_eq!(identify(&records, &inputs, &fixed).unwrap().model.a().nrows(), 5);
}

#[test]
fn a_lag_is_estimated_and_missed_where_it_is_not() {
    let late = Flown { late: 2, ..BOTH };
    let (records, inputs) = flights(&[late, late], 5);
    let mut options = Options { structure: Structure::Lateral, ..Options::default() };
    let without = identify(&records, &inputs, &options).unwrap();
    let says_so =
        |doubt: &Doubt| matches!(doubt, Doubt::LagNeeded { sensor, .. } if sensor == "beta");
    assert!(without.doubts.iter().any(says_so), "{:?}", without.doubts);
    options.sensor_lags = vec![Lag::Free, Lag::Given(0.0), Lag::Given(0.0)];
    let fit = identify(&records, &inputs, &options).unwrap();
    assert!(fit.doubts.is_empty(), "{:?}", fit.doubts);
    let lag = fit.sensor_lags[0];
    assert!((lag.value - 0.1).abs() < 0.01 && lag.standard_error < 0.01, "{lag:?}");
    options.sensor_lags = vec![Lag::Given(0.1), Lag::Given(0.0), Lag::Given(0.0)];
    let given = identify(&records, &inputs, &options).unwrap();
    assert!(given.doubts.is_empty(), "{:?}", given.doubts);
    assert!(error(&given.modes, &eigenvalues()) < 0.02);
}

#[test]
fn inputs_that_did_not_move_the_aircraft_are_doubted() {
    let (records, mut inputs) = flights(&[BOTH], 6);
    let mut normal = Normal::new(60);
    for signal in &mut inputs.signals[0] {
        signal.iter_mut().for_each(|value| *value = 0.03 * normal.next());
    }
    let fit = identify(&records, &inputs, &Options::default()).unwrap();
    let codes: Vec<_> = fit.doubts.iter().map(Doubt::code).collect();
    assert!(codes.contains(&"inputs-explain-little"), "{codes:?}");
}

/// The aileron moves the aircraft more than the rudder does, and nobody says so.
#[test]
fn an_input_that_is_missing_is_doubted() {
    for seed in 1..=4 {
        let (records, inputs) = flights(&[Flown { moved: [0.1, 0.03], ..BOTH }], seed);
        let rudder = RecordedInputs {
            names: inputs.names[1..].to_vec(),
            signals: vec![inputs.signals[0][1..].to_vec()],
        };
        let fit = identify(&records, &rudder, &Options::default()).unwrap();
        let doubted = fit.doubts.iter().any(Doubt::is_of_unrecorded_excitation);
        assert!(doubted, "{seed}: {:?}", fit.records[0].explained);
    }
}

#[test]
fn an_order_that_was_asked_for_is_used() {
    let (records, inputs) = flights(&[BOTH], 9);
    let options = Options { order: OrderChoice::Fixed(5), ..Options::default() };
    let fit = identify(&records, &inputs, &options).unwrap();
    assert_eq!((fit.model.a().nrows(), fit.derivatives.len()), (5, 0));
}

/// Twelve parameters and a few numbers more.
#[test]
fn few_samples_are_doubted() {
    let (records, inputs) = flights(&[Flown { samples: 60, ..BOTH }], 10);
    let fit = identify(&records, &inputs, &Options::default()).unwrap();
    assert!(fit.doubts.iter().any(|doubt| doubt.code() == "too-short"), "{:?}", fit.doubts);
}

#[test]
fn a_simulation_predicts_a_record_that_the_fit_has_not_seen() {
    let (records, inputs) = flights(&[BOTH, Flown { offset: 0.05, ..BOTH }], 7);
    let first = RecordedInputs { signals: inputs.signals[..1].to_vec(), ..inputs.clone() };
    let second = RecordedInputs { signals: inputs.signals[1..].to_vec(), ..inputs };
    let fit = identify(&records[..1], &first, &Options::default()).unwrap();
    let predicted = &simulate(&records[1..], &second, &(&fit).into()).unwrap()[0];
    assert!(predicted.fit.iter().all(|part| *part > 0.9), "{:?}", predicted.fit);
    let own = &simulate(&records[..1], &first, &(&fit).into()).unwrap()[0];
    assert_eq!(own.sensors.len(), 3);
    assert_eq!(own.sensors[0].len(), 1200);
}
