use super::*;
use crate::Channel;

fn pair() -> [Record; 2] {
    crate::shipped::pair("noise_free")
}

/// The same record with each channel changed.
fn changed(record: &Record, change: impl Fn(usize, &[f64]) -> Vec<f64>) -> Record {
    let channels = record.channels().iter().enumerate();
    let channels = channels
        .map(|(index, channel)| Channel::new(channel.name.clone(), change(index, &channel.values)));
    Record::new(record.name(), record.period(), channels.collect()).unwrap()
}

/// The aircraft's eigenvalues, tests/data/reference.json /aircraft/spec_A.
const TRUTH: [(f64, f64); 4] = [
    (-0.545_562_845_619_248_3, 0.0),
    (-0.070_594_067_703_702_26, -1.691_678_361_958_471_2),
    (-0.070_594_067_703_702_26, 1.691_678_361_958_471_2),
    (-0.001_563_638_219_256_003_3, 0.0),
];

fn distance_from_truth(result: &Solution) -> f64 {
    assert_eq!(result.modes.len(), 4, "{:?}", result.modes);
    let truth: Vec<_> = TRUTH.iter().map(|&(re, im)| Complex::new(re, im)).collect();
    let found: Vec<_> = result.modes.iter().map(|mode| mode.eigenvalue).collect();
    crate::paper::containment(&truth, &found).largest_distance()
}

#[test]
fn noise_free_records_give_the_eigenvalues() {
    let result = identify(&pair(), &Options::default()).unwrap();
    // Asked for is 1e-6; without polishing in factored form it is 7e-9.
    let distance = distance_from_truth(&result);
    assert!(distance < 1e-10, "{distance:e}");
    assert!(result.shared.largest_spread() < 1e-11);
    assert_eq!(result.doubts, []);
    for found in &result.identifications {
        assert_eq!(
            (found.fit.rank, found.realization.causal.order, found.realization.anticausal.order),
            (54, 0, 4)
        );
        assert_eq!((found.zeros.len(), found.poles.len(), found.cancelled.len()), (3, 3, 1));
    }
    // The zeros that only one difference has are the next closest thing to a shared zero.
    assert!(result.shared.closest_refused.is_some_and(|spread| spread > 1e-2));
}

#[test]
fn shapes_are_those_of_the_eigenvectors() {
    use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)
            .unwrap();
    let system =
        model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL).unwrap();
    let result = identify(&pair(), &Options::default()).unwrap();
    for mode in system.modes().unwrap() {
        let vector = mode.eigenvector.unwrap();
        let closest = |a: &&Mode, b: &&Mode| {
            let distance = |found: &Mode| (found.eigenvalue - mode.eigenvalue).norm();
            distance(a).total_cmp(&distance(b))
        };
        let found = result.modes.iter().min_by(closest).unwrap();
        for channel in 0..3 {
            let expected = vector[channel] / vector[0];
            let error = (found.shape[channel] - expected).norm() / expected.norm();
            assert!(error < 1e-6, "{} in channel {channel}: {error:e}", mode.eigenvalue);
        }
    }
}

#[test]
fn order_and_units_of_the_records_do_not_matter() {
    let [aileron, rudder] = pair();
    let swapped = identify(&[rudder.clone(), aileron.clone()], &Options::default()).unwrap();
    assert!(distance_from_truth(&swapped) < 1e-10);
    // Degrees, and a yaw rate in units that make it tiny.
    let units = [180.0 / std::f64::consts::PI, 1.0, 1e-9];
    let scaled = [aileron, rudder].map(|record| {
        changed(&record, |index, values| values.iter().map(|value| value * units[index]).collect())
    });
    assert!(distance_from_truth(&identify(&scaled, &Options::default()).unwrap()) < 1e-8);
}

#[test]
fn a_repeated_excitation_is_refused_and_a_mixed_one_doubted() {
    let [aileron, rudder] = pair();
    let third = changed(&rudder, |_, values| values[800..].to_vec());
    // The last 1200 samples of the rudder record are a record of the same excitation from other initial conditions.
    let same = identify(&[rudder.clone(), third], &Options::default());
    assert!(matches!(same, Err(ReconstructError::SameExcitation { .. })), "{same:?}");

    // Aileron and rudder together, in fixed proportion, are one excitation of another direction.
    let both = changed(&aileron, |index, values| {
        values.iter().zip(&rudder.channels()[index].values).map(|(a, r)| a + 0.3 * r).collect()
    });
    // That sum is driven by two signals, so it is no record of one excitation, and the fit says so.
    let result = identify(&[aileron, rudder, both], &Options::default()).unwrap();
    assert_eq!(result.differences.len(), 6);
    assert!(result.doubts.iter().any(
        |doubt| matches!(doubt, Doubt::Noise { record, .. } if record == "noise_free_aileron")
    ));
}

#[test]
fn noise_raises_doubts() {
    // A fixed pseudo-random sequence of relative size 1e-3.
    let noisy = pair().map(|record| {
        changed(&record, |index, values| {
            let mut random = flight::Stream::new(12345, u64::try_from(index).unwrap());
            values.iter().map(|value| value + 3e-3 * random.normal()).collect()
        })
    });
    let result = identify(&noisy, &Options::default()).unwrap();
    let noise = result.doubts.iter().filter(|doubt| matches!(doubt, Doubt::Noise { .. })).count();
    assert_eq!(noise, 4);
    assert!(result.doubts.contains(&Doubt::NoSharedZero), "{:?}", result.shared);
    assert!(result.doubts.iter().all(|doubt| !doubt.to_string().is_empty()));
}

/// The records with their channels in another order.
fn reordered(order: [usize; 3]) -> [Record; 2] {
    pair().map(|record| {
        let channels = order.map(|index| record.channels()[index].clone());
        Record::new(record.name(), record.period(), channels.to_vec()).unwrap()
    })
}

#[test]
fn what_the_pseudo_input_never_sees_is_no_mode() {
    // The roll rate has a zero at z = 1 under both excitations: the bank angle can be anything while p = 0.
    let result = identify(&reordered([1, 0, 2]), &Options::default()).unwrap();
    assert_eq!(result.shared.zeros.len(), 5);
    assert!(distance_from_truth(&result) < 1e-6, "{:?}", result.modes);
    assert_eq!(result.unobservable_zeros.len(), 1);
    assert!((result.unobservable_zeros[0] - 1.0).norm() < 1e-9);
    assert_eq!(result.doubts, []);
}

#[test]
fn noise_far_below_any_sensor_is_seen() {
    let noisy = pair().map(|record| {
        changed(&record, |_, values| {
            let mut sign = 1.0;
            let mut flip = |k: usize| {
                sign = if (k * k + 3 * k / 7).is_multiple_of(3) { -sign } else { sign };
                sign
            };
            values.iter().enumerate().map(|(k, value)| value + 1e-10 * flip(k)).collect()
        })
    });
    let result = identify(&noisy, &Options::default()).unwrap();
    assert!(
        result.doubts.iter().any(|doubt| matches!(doubt, Doubt::Noise { .. })),
        "{:?}",
        result.doubts
    );
}

#[test]
fn copies_of_one_sensor_give_no_silent_answer() {
    let copies = pair().map(|record| changed(&record, |_, _| record.channels()[0].values.clone()));
    match identify(&copies, &Options::default()) {
        Err(ReconstructError::SameExcitation { .. }) => {}
        Ok(result) => {
            let deficient =
                |doubt: &Doubt| matches!(doubt, Doubt::RankDeficient { rank, .. } if *rank < 54);
            assert!(result.doubts.iter().any(deficient), "{:?}", result.doubts);
        }
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn noise_that_leaves_nothing_is_a_doubt_and_no_error() {
    // Records of noise alone, different in each channel.
    let noise = |seed: u64| {
        let mut random = flight::Stream::new(seed, 0);
        (0..300).map(|_| random.normal()).collect::<Vec<f64>>()
    };
    let record = |name: &str, seed: u64| {
        let channels =
            [("beta", 1), ("p", 2), ("r", 3)].map(|(name, k)| Channel::new(name, noise(seed + k)));
        Record::new(name, SamplePeriod::new(0.1).unwrap(), channels.to_vec()).unwrap()
    };
    let result =
        identify(&[record("first", 10), record("second", 20)], &Options::default()).unwrap();
    assert_eq!(result.modes, []);
    assert_eq!(result.doubts[0], Doubt::NoSharedZero);
    assert_eq!(result.doubts.len(), 5);
}

#[test]
fn refuses_what_cannot_work() {
    let [aileron, rudder] = pair();
    let options = Options::default();
    let check = |records: &[Record], expected: &str| {
        let message = identify(records, &options).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    };
    check(&[], "0 record(s), but 2 are needed");
    check(std::slice::from_ref(&aileron), "1 record(s), but 2 are needed");
    let two_sensors = |record: &Record| {
        Record::new("two", record.period(), record.channels()[..2].to_vec()).unwrap()
    };
    check(&[two_sensors(&aileron), two_sensors(&rudder)], "2 sensor channel(s), but 3 are needed");
    let short = changed(&rudder, |_, values| values[..60].to_vec());
    check(&[aileron.clone(), short], "samples");
    let dead = changed(
        &rudder,
        |index, values| if index == 0 { vec![1.5; values.len()] } else { values.to_vec() },
    );
    check(
        &[aileron.clone(), dead],
        "record \"noise_free_rudder\": channel \"beta\" is constant, 1.5 throughout",
    );
    let zero = changed(
        &rudder,
        |index, values| if index == 2 { vec![0.0; values.len()] } else { values.to_vec() },
    );
    check(&[aileron.clone(), zero], "channel \"r\" is constant, 0 throughout");
    check(&[aileron.clone(), aileron.clone()], "the same transmissibility");

    let bad = Options { shared_tolerance: 0.0, ..Options::default() };
    assert!(matches!(
        identify(&[aileron, rudder], &bad),
        Err(ReconstructError::InvalidTolerance { .. })
    ));
}
