use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, system, with_model_error};
use crate::likelihood::identify;

const EIGENVALUES: [Complex<f64>; 3] =
    [Complex::new(0.95, 0.25), Complex::new(0.95, -0.25), Complex::new(0.8, 0.0)];

fn statistic(seed: u64, size: f64) -> f64 {
    let mut normal = Normal::new(seed);
    let truth = system(&[EIGENVALUES[0], EIGENVALUES[2]], 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.02, ..QUIET };
    let flights = fly(&truth, &[600, 500], &disturbance, &mut normal);
    let records: Vec<_> =
        flights.records.iter().map(|record| with_model_error(record, size, &mut normal)).collect();
    let fit = identify(&records, &[truth], &Options::default()).unwrap();
    model_error_test(&records, &fit).unwrap().statistic
}

#[test]
fn white_residuals_follow_no_signal() {
    let all: Vec<f64> = (1..=30).map(|seed| statistic(seed, 0.0)).collect();
    // Standard normal but for what the fit has taken: none far out, and as many small ones as there should be.
    assert!(all.iter().all(|value| *value < 4.0), "{all:?}");
    let near = all.iter().filter(|value| value.abs() < 2.0).count();
    assert!(near >= 24, "{near} of 30: {all:?}");
}

#[test]
fn a_model_error_follows_the_signal() {
    for seed in 1..=5 {
        let value = statistic(seed, 0.1);
        assert!(value > 4.0, "{seed}: {value}");
    }
}

#[test]
fn noise_with_a_spectrum_is_not_tested() {
    let mut normal = Normal::new(3);
    let truth = system(&[EIGENVALUES[0], EIGENVALUES[2]], 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, ..QUIET };
    let flights = fly(&truth, &[300, 300], &disturbance, &mut normal);
    let options = Options { noise: Noise::ModelError { first_guess: None }, ..Options::default() };
    let fit = identify(&flights.records, &[truth], &options).unwrap();
    let error = model_error_test(&flights.records, &fit).unwrap_err();
    assert!(matches!(error, ReconstructError::Option { name: "noise", .. }), "{error}");
}
