//! The residuals at all frequencies add up to the cost that the fit minimised, whatever it was told.

use nalgebra::DVector;
use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, perturbed, system};
use crate::likelihood::{Fit, Hold, identify};
use crate::{Measurement, Offsets, Trend};

/// The cost of the fit from its parts at each frequency.
fn cost(fits: &[SpectralFit], samples: &[usize]) -> f64 {
    let weight = |fit: &SpectralFit, k: usize, samples: usize| {
        let turns = fit.frequencies_rad_s[k] * 0.1 * samples as f64 / std::f64::consts::TAU;
        let edge = turns < 0.5 || turns > 0.5 * samples as f64 - 0.25;
        if edge { 1.0 } else { 2.0 }
    };
    let record = |(fit, &samples): (&SpectralFit, &usize)| -> f64 {
        let sensors = fit.sensors.len() as f64;
        let each = fit.residuals.iter().enumerate();
        each.map(|(k, value)| weight(fit, k, samples) * value * (sensors - 1.0)).sum()
    };
    fits.iter().zip(samples).map(record).sum()
}

fn levels(fit: &Fit) -> Vec<f64> {
    fit.noise_levels.iter().flatten().map(|level| level.value).collect()
}

/// The spectra beside those of a fit.
fn fitted(records: &[Record], fit: &Fit, options: &Options) -> Vec<SpectralFit> {
    let error = fit.model_error.map(|error| error.value);
    spectral_fit(records, &fit.model, &levels(fit), error, &fit.feedthrough_sensors, options)
        .unwrap()
}

#[test]
fn adds_up_with_everything_unknown() {
    let mut normal = Normal::new(6);
    let mut truth = system(&[Complex::new(0.9, 0.3), Complex::new(0.8, 0.0)], 4, 2, &mut normal);
    let d = |x: f64| DVector::from_column_slice(&[0.0, 0.0, 0.0, x]);
    truth.feedthrough = Some(vec![d(0.8), d(-0.5)]);
    let disturbance = Disturbance { noise: 0.01, offset: 0.2, trend: 0.5, known: 1.0 };
    let samples = [600, 501];
    let flights = fly(&truth, &samples, &disturbance, &mut normal);
    let start = perturbed(&truth, 1e-3, &mut normal);
    let prior = || Offsets::PriorDeviation(vec![0.2; 4]);
    for (offsets, hold) in
        [(Offsets::Free, Hold::ZeroOrder), (prior(), Hold::ZeroOrder), (prior(), Hold::FirstOrder)]
    {
        let options = Options {
            hold: Some(hold),
            measurement: Measurement {
                offsets,
                trend: Trend::Linear,
                feedthrough_sensors: vec![3],
                known_inputs: flights.known.clone(),
            },
            ..given(&flights.levels)
        };
        let fit = identify(&flights.records, std::slice::from_ref(&start), &options).unwrap();
        let fits = fitted(&flights.records, &fit, &options);
        let (found, expected) = (cost(&fits, &samples), fit.chi_squared.value);
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} and {expected}");
    }
}

#[test]
fn response_and_noise_make_up_the_spectrum() {
    let mut normal = Normal::new(9);
    let truth = system(&[Complex::new(0.95, 0.2), Complex::new(0.9, 0.0)], 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, ..QUIET };
    let flights = fly(&truth, &[4000, 4000], &disturbance, &mut normal);
    let options = Options::default();
    let fit = identify(&flights.records, &[truth], &options).unwrap();
    let fits = fitted(&flights.records, &fit, &options);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    for (record, spectrum) in flights.records.iter().zip(&fits) {
        assert!((mean(&spectrum.residuals) - 1.0).abs() < 0.05);
        for ((sensor, channel), level) in
            spectrum.sensors.iter().zip(record.channels()).zip(&flights.levels)
        {
            // Parseval, up to the weights of the two ends.
            let power = mean(&channel.values.iter().map(|y| y * y).collect::<Vec<_>>());
            assert!((mean(&sensor.measured) / power - 1.0).abs() < 0.01);
            let noise = sensor.noise[7].sqrt();
            assert!((noise / level - 1.0).abs() < 0.1, "{noise} and {level}");
            let high = sensor.measured.len() * 9 / 10..;
            let signal =
                mean(&sensor.response[high.clone()]) - mean(&sensor.absorbed[high.clone()]);
            let expected = signal + mean(&sensor.noise[high.clone()]);
            let ratio = mean(&sensor.measured[high]) / expected;
            assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
            assert!(mean(&sensor.response) > 0.9 * power);
        }
    }
}

#[test]
fn adds_up_with_a_model_error() {
    let mut normal = Normal::new(12);
    let truth = system(&[Complex::new(0.9, 0.3), Complex::new(0.8, 0.0)], 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, ..QUIET };
    let samples = [400, 351];
    let flights = fly(&truth, &samples, &disturbance, &mut normal);
    let options = Options { noise: Noise::ModelError { first_guess: None }, ..Options::default() };
    let fit = identify(&flights.records, &[truth], &options).unwrap();
    let fits = fitted(&flights.records, &fit, &fit.options);
    let (found, expected) = (cost(&fits, &samples), fit.chi_squared.value);
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} and {expected}");
}
