use num_complex::Complex;

use crate::Record;
use crate::likelihood::fixtures::{Disturbance, Normal, fly, misses, system, with_model_error};
use crate::likelihood::{Noise, Options, identify, profile_intervals};

#[test]
fn noise_free_records_send_the_levels_down_without_breaking() {
    let mut normal = Normal::new(2);
    let model = system(&[Complex::new(0.5, 0.3)], 3, 2, &mut normal);
    let flights = fly(&model, &[80, 80], &crate::likelihood::fixtures::QUIET, &mut normal);
    let fit =
        identify(&flights.records, std::slice::from_ref(&model), &Options::default()).unwrap();
    for level in fit.noise_levels.unwrap() {
        assert!(level.value.is_finite() && level.value < 1e-9, "{}", level.value);
    }
    assert!((fit.modes[0].discrete.value - Complex::new(0.5, 0.3)).norm() < 1e-9);
}

#[test]
fn a_model_error_is_found_beside_white_noise() {
    const SIZE: f64 = 0.05;
    let mut normal = Normal::new(7);
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.6, 0.0)];
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.02, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[1000, 1000], &disturbance, &mut normal);
    let records: Vec<Record> =
        flights.records.iter().map(|record| with_model_error(record, SIZE, &mut normal)).collect();
    let options = Options { noise: Noise::ModelError { first_guess: None }, ..Options::default() };
    let fit = identify(&records, std::slice::from_ref(&model), &options).unwrap();
    let found = fit.model_error.unwrap();
    // The smoothed periodogram is as large as the signal on average, and scatters about it.
    assert!((found.value / SIZE - 1.0).abs() < 0.2, "{found:?}");
    assert!(found.standard_error < 0.1 * found.value);
    assert!((fit.chi_squared.per_degree_of_freedom() - 1.0).abs() < 0.05);
    for (distance, deviations) in misses(&fit, &eigenvalues) {
        assert!(deviations < 4.0, "off by {distance}, {deviations} deviations");
    }
    // What is asked of a finished fit knows of it, too.
    let [low, high] = profile_intervals(&records, &fit).unwrap()[0].unwrap();
    let s = 0.6_f64.ln() / model.period.seconds();
    let width = 2.0 * 1.96 * fit.modes[0].continuous.real_standard_error();
    assert!(low < s && s < high, "{low} {high}");
    assert!(((high - low) / width - 1.0).abs() < 0.2, "{low} {high} {width}");
    // Without it the same records have deviations that are too small, or levels that are too large.
    let white = identify(&records, std::slice::from_ref(&model), &Options::default()).unwrap();
    assert!(white.criterion > fit.criterion + 100.0);
}

#[test]
fn linear_records_have_no_model_error() {
    let mut normal = Normal::new(8);
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.6, 0.0)];
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.02, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[1000, 1000], &disturbance, &mut normal);
    let options = Options { noise: Noise::ModelError { first_guess: None }, ..Options::default() };
    let fit = identify(&flights.records, std::slice::from_ref(&model), &options).unwrap();
    // It stays at its bound, or where its own error leaves it.
    let found = fit.model_error.unwrap();
    assert!(found.value < 3e-3, "{found:?}");
    for (level, expected) in fit.noise_levels.unwrap().iter().zip(&flights.levels) {
        assert!((level.value / expected - 1.0).abs() < 0.1);
    }
}
