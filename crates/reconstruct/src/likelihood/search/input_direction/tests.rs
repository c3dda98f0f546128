use realfft::RealFftPlanner;

use super::*;
use crate::likelihood::cost::spectrum::transform;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, system};
use crate::likelihood::options::Options;
use crate::model::Hold;
use crate::model::NoiseSpectrum;
use crate::{Measurement, SharedModel, Trend};

/// The cosine of the angle between the planted and the estimated direction of record 0.
fn cosine(model: &SharedModel, disturbance: &Disturbance, options: &Options, seed: u64) -> f64 {
    let flights = fly(model, &[300], disturbance, &mut Normal::new(seed));
    let (n, m) = (model.a.nrows(), model.c.nrows());
    let mut options = options.clone();
    options.measurement.known_inputs = flights.known.clone();
    let spectrum =
        transform(&flights.records[0], 0, &flights.levels, &options, &mut RealFftPlanner::new());
    let layout = Layout {
        order: n,
        sensors: m,
        records: 1,
        feedthrough: options.measurement.feedthrough_sensors.clone(),
        hold: Hold::ZeroOrder,
    };
    let units = DVector::from_column_slice(&flights.levels);
    let system = System::scaled(model, &flights.levels, &layout);
    let (b, d) = input_direction(&spectrum.unwrap(), &system, &layout, &vec![1.0; m]).unwrap();
    let d = d.component_mul(&units);
    let truth = model.feedthrough.as_ref().map_or(DVector::zeros(m), |all| all[0].clone());
    let overlap = b.dot(&model.b[0]) + d.dot(&truth);
    overlap.abs() / (b.norm().hypot(d.norm()) * model.b[0].norm().hypot(truth.norm()))
}

fn pole(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

#[test]
fn finds_the_direction_without_noise() {
    let eigenvalues = [pole(0.9, 0.3), pole(0.7, 0.0)];
    for (seed, sensors) in [(1, 2), (2, 3), (3, 5)] {
        let model = system(&eigenvalues, sensors, 1, &mut Normal::new(seed));
        let found = cosine(&model, &QUIET, &Options::default(), seed);
        // Limited by the square root of rounding errors: squares of singular values are compared.
        assert!(1.0 - found < 1e-9, "{sensors}: {found}");
    }
}

#[test]
fn finds_it_in_noise_as_large_as_a_third_of_the_signal() {
    let eigenvalues = [pole(0.9, 0.3), pole(0.95, 0.0)];
    let disturbance = Disturbance { noise: 0.3, ..QUIET };
    for seed in 1..6 {
        let model = system(&eigenvalues, 4, 1, &mut Normal::new(seed));
        let found = cosine(&model, &disturbance, &Options::default(), seed);
        assert!(found > 0.95, "{seed}: {found}");
    }
}

#[test]
fn finds_it_beside_known_inputs_trends_and_feedthrough() {
    let mut normal = Normal::new(5);
    let mut model = system(&[pole(0.9, 0.3), pole(0.7, 0.0)], 4, 1, &mut normal);
    model.feedthrough = Some(vec![DVector::from_column_slice(&[0.0, 1.5, 0.0, 0.0])]);
    let disturbance = Disturbance { noise: 0.001, offset: 0.0, trend: 1.0, known: 1.0 };
    let options = Options {
        measurement: Measurement {
            trend: Trend::Linear,
            feedthrough_sensors: vec![1],
            ..Measurement::default()
        },
        ..Options::default()
    };
    let found = cosine(&model, &disturbance, &options, 6);
    assert!(found > 0.999, "{found}");
}

#[test]
fn whitening_takes_the_noise_to_unity() {
    let mut normal = Normal::new(7);
    let root = DMatrix::from_fn(3, 3, |_, _| Complex::new(normal.next(), normal.next()));
    let covariance = &root * root.adjoint();
    let spectrum = NoiseSpectrum::new(2, vec![covariance.clone(); 2]).unwrap();
    let options = Options {
        noise: crate::likelihood::options::Noise::Spectra(vec![spectrum]),
        ..Options::default()
    };
    let model = system(&[pole(0.7, 0.0)], 3, 1, &mut normal);
    let record = fly(&model, &[2], &QUIET, &mut normal).records.remove(0);
    let spectrum = transform(&record, 0, &[1.0; 3], &options, &mut RealFftPlanner::new()).unwrap();
    let mut factor = DMatrix::<Complex<f64>>::identity(3, 3);
    Whitening::at(&spectrum, &[1.0; 3], 1).apply(&mut factor, &mut [Complex::new(0.0, 0.0); 3]);
    let whitened = &factor * covariance * factor.adjoint();
    assert!((whitened - DMatrix::identity(3, 3)).norm() < 1e-12);
}
