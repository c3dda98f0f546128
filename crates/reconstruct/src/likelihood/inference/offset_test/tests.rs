use num_complex::Complex;

use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, perturbed, system};
use crate::likelihood::{Fit, Options, identify};
use crate::{Measurement, Offsets};

const EIGENVALUES: [Complex<f64>; 3] =
    [Complex::new(0.9, 0.3), Complex::new(0.6, 0.0), Complex::new(0.99, 0.0)];

/// A fit of records with offsets of this size.
fn fit(offset: f64, seed: u64, options: impl Fn(&[f64]) -> Options) -> Fit {
    let mut normal = Normal::new(seed);
    let model = system(&EIGENVALUES, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.02, offset, ..QUIET };
    let flights = fly(&model, &[400, 350], &disturbance, &mut normal);
    let start = perturbed(&model, 0.01, &mut normal);
    identify(&flights.records, &[start], &options(&flights.levels)).unwrap()
}

#[test]
fn without_offsets_its_probabilities_are_even() {
    const RUNS: u64 = 60;
    let mut below = [0; 3];
    for seed in 1..=RUNS {
        let test = fit(0.0, seed, given).offset_test.unwrap();
        assert!((test.degrees_of_freedom - 4.0).abs() < 1e-12);
        for (below, limit) in below.iter_mut().zip([0.25, 0.5, 0.75]) {
            *below += u64::from(test.p_value < limit);
        }
    }
    // Four deviations of a count of 60.
    for (below, limit) in below.into_iter().zip([0.25, 0.5, 0.75]) {
        let expected = RUNS as f64 * limit;
        let deviation = (expected * (1.0 - limit)).sqrt();
        assert!((below as f64 - expected).abs() < 4.0 * deviation, "{below} below {limit}");
    }
}

#[test]
fn offsets_are_found() {
    let mut swallowed = 0;
    for seed in 1..=5 {
        let test = fit(1.0, seed, given).offset_test.unwrap();
        assert!(test.p_value < 1e-6, "{seed}: {test:?}");
        let test = fit(1.0, seed, |_| Options::default()).offset_test.unwrap();
        swallowed += usize::from(test.p_value > 1e-4);
    }
    // From one start, with levels that may grow, a mode may end at z = 1, where it is itself an offset.
    assert!(swallowed <= 1, "{swallowed} of 5");
}

#[test]
fn where_offsets_are_free_there_is_nothing_to_test() {
    let free = |levels: &[f64]| Options {
        measurement: Measurement { offsets: Offsets::Free, ..given(levels).measurement.clone() },
        ..given(levels)
    };
    assert_eq!(fit(1.0, 1, free).offset_test, None);
}
