use super::super::fixtures::{Disturbance, Normal, fly, given, system};
use super::*;
use num_complex::Complex;

#[test]
fn units_are_the_levels_as_far_as_they_are_known() {
    let mut normal = Normal::new(1);
    let model = system(&[Complex::new(0.5, 0.0)], 2, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.1, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[50, 60], &disturbance, &mut normal);
    assert_eq!(units(&flights.records, &given(&flights.levels)), flights.levels);
    let guessed = units(&flights.records, &LikelihoodOptions::default());
    for (sensor, unit) in guessed.iter().enumerate() {
        let squares: f64 =
            flights.records.iter().map(|r| rms(&r.channels()[sensor].values).powi(2)).sum();
        assert!((unit - 0.01 * (squares / 2.0).sqrt()).abs() < 1e-15);
    }
}

#[test]
fn noise_free_records_send_the_levels_down_without_breaking() {
    let mut normal = Normal::new(2);
    let model = system(&[Complex::new(0.5, 0.3)], 3, 2, &mut normal);
    let flights = fly(&model, &[80, 80], &super::super::fixtures::QUIET, &mut normal);
    let fit = super::super::maximise(
        &flights.records,
        std::slice::from_ref(&model),
        &LikelihoodOptions::default(),
    )
    .unwrap();
    for level in fit.noise_levels.unwrap() {
        assert!(level.value.is_finite() && level.value < 1e-9, "{}", level.value);
    }
    assert!((fit.modes[0].discrete.value - Complex::new(0.5, 0.3)).norm() < 1e-9);
}
