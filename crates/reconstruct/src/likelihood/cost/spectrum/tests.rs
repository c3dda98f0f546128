use nalgebra::{DMatrix, DVector};

use super::*;
use crate::likelihood::FrequencyBand;
use crate::likelihood::cost::noise::sensor_units;
use crate::likelihood::fixtures::{Disturbance, Normal, fly, given, system};
use crate::{Channel, Measurement};

/// N^(-1/2) sum v(i) z^-i.
fn plain(values: &[f64], z: Complex<f64>) -> Complex<f64> {
    let scale = 1.0 / (values.len() as f64).sqrt();
    values
        .iter()
        .enumerate()
        .map(|(i, &value)| z.powi(-i32::try_from(i).unwrap()) * value * scale)
        .sum()
}

fn spectrum(record: &Record, options: &Options, units: &[f64]) -> RecordSpectrum {
    transform(record, 0, units, options, &mut RealFftPlanner::new()).unwrap()
}

#[test]
fn the_relation_is_exact_for_any_length() {
    // Y = C (zI - A)^-1 (b U + z (x(0) - x(N)) / sqrt N), to rounding errors, for prime, odd and even lengths.
    for samples in [31, 45, 64] {
        let mut normal = Normal::new(1);
        let model = system(&[Complex::new(0.8, 0.5), Complex::new(1.01, 0.0)], 2, 1, &mut normal);
        let initial = normal.vector(3);
        let (mut x, mut inputs, mut y) = (initial.clone(), Vec::new(), vec![Vec::new(); 2]);
        for _ in 0..samples {
            let (u, now) = (normal.next(), &model.c * &x);
            y.iter_mut().zip(now.iter()).for_each(|(y, now)| y.push(*now));
            x = &model.a * &x + &model.b[0] * u;
            inputs.push(u);
        }
        let ends = (&initial - &x) / (samples as f64).sqrt();
        let channels = y.into_iter().enumerate().map(|(k, y)| Channel::new(format!("{k}"), y));
        let record = Record::new("r", model.period, channels.collect()).unwrap();
        let found = spectrum(&record, &Options::default(), &[1.0, 2.0]);
        assert_eq!(found.frequencies(), samples / 2 + 1);
        assert!((found.weight.iter().sum::<f64>() - samples as f64).abs() < 1e-12);
        for (k, &z) in found.z.iter().enumerate() {
            let pencil = DMatrix::identity(3, 3) * z - model.a.map(|x| Complex::new(x, 0.0));
            let complex = |v: &DVector<f64>| v.map(|x| Complex::new(x, 0.0));
            let driven = complex(&model.b[0]) * plain(&inputs, z) + complex(&ends) * z;
            let expected =
                model.c.map(|x| Complex::new(x, 0.0)) * pencil.try_inverse().unwrap() * driven;
            for s in 0..2 {
                let y = found.y[2 * k + s] * [1.0, 2.0][s];
                assert!(
                    (y - expected[s]).norm() < 1e-10 * expected.norm().max(1.0),
                    "{samples} {k}"
                );
            }
            assert!((found.factors[k] - z).norm() < 1e-15);
        }
    }
}

#[test]
fn a_ramp_is_a_ramp() {
    for samples in [9, 10] {
        let values: Vec<f64> = (0..samples)
            .map(|i| 12.0_f64.sqrt() * (i as f64 - 0.5 * (samples - 1) as f64) / samples as f64)
            .collect();
        let all = (0..=samples / 2).collect();
        let fourier = Fourier::new(samples, all, &mut RealFftPlanner::new());
        for (k, (ramp, z)) in fourier.ramp().into_iter().zip(fourier.z()).enumerate() {
            assert!((ramp - plain(&values, z)).norm() < 1e-13, "{samples} {k}");
        }
    }
}

#[test]
fn options_choose_frequencies_and_factors() {
    let mut normal = Normal::new(2);
    let values = |normal: &mut Normal| (0..20).map(|_| normal.next()).collect::<Vec<_>>();
    let channels =
        vec![Channel::new("x", values(&mut normal)), Channel::new("y", values(&mut normal))];
    let record = Record::new("r", lti::SamplePeriod::new(0.1).unwrap(), channels).unwrap();
    let input = values(&mut normal);
    let free = Options {
        measurement: Measurement { offsets: Offsets::Free, ..Measurement::default() },
        ..Options::default()
    };
    let found = spectrum(&record, &free, &[1.0, 1.0]);
    assert!(!found.starts_at_zero && found.frequencies() == 10);
    // (m - 1) times the 19 real numbers that are left of 20.
    assert!((found.residuals(2) - 19.0).abs() < 1e-12);
    let prior = Options {
        // pi rad/s is frequency 1 of 20, 5 pi rad/s frequency 5.
        band: Some(FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 5.0 * std::f64::consts::PI }),
        measurement: Measurement {
            offsets: Offsets::PriorDeviation(vec![0.1, 0.2]),
            known_inputs: vec![vec![input.clone()]],
            trend: Trend::Linear,
            ..Measurement::default()
        },
        ..Options::default()
    };
    let found = spectrum(&record, &prior, &[0.5, 0.1]);
    assert_eq!(found.frequencies(), 6);
    assert_eq!(found.entries, [Entry::State, Entry::StateAndFeedthrough, Entry::Sensors]);
    // An offset of deviation 0.1 in a sensor of unit 0.5 adds 20 (0.1 / 0.5)^2 at frequency zero.
    assert!((found.offset_variance[0] - 0.8).abs() < 1e-12);
    assert!((found.offset_variance[1] - 80.0).abs() < 1e-12);
    let expected = plain(&input, found.z[3]) / rms(&input);
    assert!((found.factors[3 * 3 + 1] - expected).norm() < 1e-12);
}

#[test]
fn a_root_mean_square_neither_overflows_nor_vanishes() {
    assert!((rms(&[3e200, -4e200]) / (12.5_f64.sqrt() * 1e200) - 1.0).abs() < 1e-15);
    assert!((rms(&[3e-200, 4e-200]) / (12.5_f64.sqrt() * 1e-200) - 1.0).abs() < 1e-15);
    assert!((rms(&[0.0]) - 1.0).abs() < f64::EPSILON);
}

#[test]
fn units_are_the_levels_as_far_as_they_are_known() {
    let mut normal = Normal::new(1);
    let model = system(&[Complex::new(0.5, 0.0)], 2, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.1, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[50, 60], &disturbance, &mut normal);
    assert_eq!(sensor_units(&flights.records, &given(&flights.levels)), flights.levels);
    let guessed = sensor_units(&flights.records, &Options::default());
    for (sensor, unit) in guessed.iter().enumerate() {
        let squares: f64 =
            flights.records.iter().map(|r| rms(&r.channels()[sensor].values).powi(2)).sum();
        assert!((unit - 0.01 * (squares / 2.0).sqrt()).abs() < 1e-15);
    }
}
