use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::*;
use crate::SharedModel;
use crate::likelihood::Options;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, system};
use crate::likelihood::identify;

#[test]
fn the_end_is_found_on_any_curve() {
    assert!((end(Some) - NORMAL_95).abs() < 0.03);
    // Steeper and flatter than a parabola.
    assert!((end(|off| Some(off * (1.0 + off))) - 0.9868).abs() < 0.03);
    assert!((end(|off| Some((1.0 + off).ln())) - (NORMAL_95.exp() - 1.0)).abs() < 0.2);
    // Nothing can be said from 1.2 on.
    assert!((end(|off| (off < 1.2).then_some(off)) - 1.2).abs() < 0.01);
}

#[test]
fn where_the_likelihood_stays_high_there_is_no_end() {
    assert!(end(|off| Some(1.5 * (1.0 - (-off).exp()))).is_infinite());
}

/// The end of a curve.
fn end(fallen: fn(f64) -> Option<f64>) -> f64 {
    distance(fallen(CLOSE).unwrap(), |fall| *fall, |off, _| fallen(off))
}

#[test]
fn with_little_noise_it_is_the_symmetric_interval() {
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.6, 0.0), Complex::new(0.98, 0.0)];
    let mut normal = Normal::new(61);
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let flights = fly(&model, &[600, 500], &Disturbance { noise: 1e-3, ..QUIET }, &mut normal);
    for options in [given(&flights.levels), Options::default()] {
        let fit = identify(&flights.records, std::slice::from_ref(&model), &options).unwrap();
        let found = profile_intervals(&flights.records, &fit).unwrap();
        let mut real = 0;
        for (mode, interval) in fit.modes.iter().zip(&found) {
            if mode.discrete.value.im > 0.0 {
                assert_eq!(*interval, None);
                continue;
            }
            real += 1;
            let [low, high] = interval.unwrap();
            let (s, deviation) = (mode.continuous.value.re, mode.continuous.real_standard_error());
            for end in [(s - low) / deviation, (high - s) / deviation] {
                assert!((end / NORMAL_95 - 1.0).abs() < 0.03, "{end}");
            }
        }
        assert_eq!(real, 2);
    }
}

/// Two records too short for their slow mode, with much noise.
fn short(seed: u64) -> (SharedModel, Vec<Record>, Vec<f64>) {
    let mut normal = Normal::new(seed);
    let model = SharedModel {
        a: DMatrix::from_row_slice(2, 2, &[0.5, 0.0, 0.0, 0.99]),
        c: DMatrix::from_row_slice(3, 2, &[1.0, 1.0, 1.0, -1.0, 1.0, 3.0]),
        b: vec![DVector::from_vec(vec![1.0, 1.0]), DVector::from_vec(vec![2.0, 1.0])],
        feedthrough: None,
        period: SamplePeriod::new(1.0).unwrap(),
    };
    let flights = fly(&model, &[100, 100], &Disturbance { noise: 0.05, ..QUIET }, &mut normal);
    (model, flights.records, flights.levels)
}

#[test]
fn it_holds_a_slow_mode_as_often_as_it_should() {
    const RUNS: u64 = 60;
    let truth = 0.99_f64.ln();
    let (mut told, mut covered, mut skewed) = (0, 0, 0);
    for seed in 1..=RUNS {
        let (model, records, levels) = short(seed);
        let options = given(&levels);
        let fit = identify(&records, &[model], &options).unwrap();
        let Some(slow) = fit
            .modes
            .iter()
            .position(|mode| mode.discrete.value.re > 0.8 && mode.discrete.value.im == 0.0)
        else {
            continue;
        };
        let Some([low, high]) = profile_intervals(&records, &fit).unwrap()[slow] else {
            continue;
        };
        assert!(!low.is_nan() && !high.is_nan());
        told += 1;
        covered += u64::from(low <= truth && truth <= high);
        let s = fit.modes[slow].continuous.value.re;
        skewed += u64::from(((high - s) / (s - low) - 1.0).abs() > 0.05);
    }
    assert!(told >= 55, "{told} of {RUNS}");
    // 95 % less three deviations of a count of 60.
    assert!(covered >= 52, "{covered} of {told}");
    assert!(skewed >= RUNS / 4, "{skewed} of {RUNS}");
}

#[test]
fn a_neighbour_does_not_take_the_place_of_a_mode() {
    // Two real modes within a few deviations of each other.
    let eigenvalues = [Complex::new(0.80, 0.0), Complex::new(0.86, 0.0)];
    let mut told = 0;
    for seed in 71..=80 {
        let mut normal = Normal::new(seed);
        let model = system(&eigenvalues, 3, 2, &mut normal);
        let flights = fly(&model, &[150, 150], &Disturbance { noise: 0.05, ..QUIET }, &mut normal);
        let options = given(&flights.levels);
        let fit = identify(&flights.records, &[model], &options).unwrap();
        let found = profile_intervals(&flights.records, &fit).unwrap();
        for (mode, interval) in fit.modes.iter().zip(found) {
            let Some([low, high]) = interval else { continue };
            told += 1;
            let s = mode.continuous.value.re;
            assert!(low < s && s < high, "{seed}: {low} {s} {high}");
            // Beyond twenty deviations it would be the other one that is held.
            let deviation = mode.continuous.real_standard_error();
            assert!(high - low < 40.0 * deviation, "{seed}: {low} {high}, {deviation}");
        }
    }
    assert!(told >= 10, "{told}");
}

#[test]
fn an_oscillation_from_sample_to_sample_has_none() {
    let eigenvalues = [Complex::new(-0.7, 0.0), Complex::new(0.9, 0.0)];
    let mut normal = Normal::new(63);
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let flights = fly(&model, &[300, 300], &Disturbance { noise: 0.01, ..QUIET }, &mut normal);
    let options = given(&flights.levels);
    let fit = identify(&flights.records, &[model], &options).unwrap();
    let found = profile_intervals(&flights.records, &fit).unwrap();
    assert_eq!(found[0], None);
    assert!(found[1].is_some());
}
