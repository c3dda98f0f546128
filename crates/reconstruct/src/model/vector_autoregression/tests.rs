use lti::SamplePeriod;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::*;
use crate::Channel;

fn record(channels: Vec<Vec<f64>>) -> Record {
    let named = channels
        .into_iter()
        .enumerate()
        .map(|(k, values)| Channel::new(format!("y{k}"), values))
        .collect();
    Record::new("quiet", SamplePeriod::new(0.1).unwrap(), named).unwrap()
}

/// v(k) = A v(k-1) + B v(k-2) + L e(k), the second sensor in units a thousand times smaller.
fn planted(samples: usize, seed: u64) -> (Record, [DMatrix<f64>; 2], DMatrix<f64>) {
    let (a, b) = (
        DMatrix::from_row_slice(2, 2, &[0.6, 0.2, -0.1, 0.4]),
        DMatrix::from_row_slice(2, 2, &[-0.3, 0.0, 0.1, 0.2]),
    );
    let l = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.5, 0.7]);
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut last, mut before) = (DVector::zeros(2), DVector::zeros(2));
    let mut channels = vec![Vec::new(); 2];
    for _ in 0..samples {
        let e = DVector::from_fn(2, |_, _| StandardNormal.sample(&mut random));
        let next = &a * &last + &b * &before + &l * e;
        channels[0].push(next[0] + 5.0);
        channels[1].push(1000.0 * next[1]);
        (before, last) = (last, next);
    }
    (record(channels), [a, b], &l * l.transpose())
}

#[test]
fn finds_a_planted_autoregression() {
    let (record, truth, sigma) = planted(40_000, 1);
    for order in [AutoregressionOrder::Fixed(2), AutoregressionOrder::Akaike { largest: 5 }] {
        let fitted = VectorAutoregression::fit(&record, order).unwrap();
        assert!(fitted.coefficients().len() >= 2, "{order:?}");
        let unit = [1.0, 1000.0];
        for (found, truth) in fitted.coefficients().iter().zip(&truth) {
            for i in 0..2 {
                for k in 0..2 {
                    // The deviation of a coefficient is about 1 / sqrt(40000).
                    let scaled = found[(i, k)] * unit[k] / unit[i];
                    assert!(
                        (scaled - truth[(i, k)]).abs() < 0.03,
                        "{scaled} for {}",
                        truth[(i, k)]
                    );
                }
            }
        }
        for i in 0..2 {
            for k in 0..2 {
                let scaled = fitted.innovation_covariance()[(i, k)] / (unit[i] * unit[k]);
                assert!((scaled - sigma[(i, k)]).abs() < 0.03);
            }
        }
    }
}

#[test]
fn the_order_is_found_and_not_less() {
    let (record, ..) = planted(4000, 2);
    let fitted =
        VectorAutoregression::fit(&record, AutoregressionOrder::Akaike { largest: 6 }).unwrap();
    assert!((2..=4).contains(&fitted.coefficients().len()));
}

#[test]
fn the_spectrum_is_that_of_the_difference_equation() {
    // v(k) = 0.5 v(k-1) + e: S = 1 / |1 - 0.5 / z|^2 is 4 at frequency zero, 4/9 at half the sampling frequency.
    let fitted = VectorAutoregression {
        coefficients: vec![DMatrix::from_row_slice(1, 1, &[0.5])],
        innovation: DMatrix::from_row_slice(1, 1, &[1.0]),
    };
    let spectrum = fitted.spectrum(8).unwrap();
    let at = |k: usize| spectrum.covariances()[k][(0, 0)].re;
    assert!((at(0) - 4.0).abs() < 1e-14 && (at(4) - 4.0 / 9.0).abs() < 1e-14);
    assert!((at(2) - 1.0 / 1.25).abs() < 1e-14);
    assert_eq!((spectrum.samples(), spectrum.covariances().len()), (8, 5));
}

#[test]
fn the_mean_of_the_spectrum_is_the_variance() {
    let (record, ..) = planted(20_000, 3);
    let fitted = VectorAutoregression::fit(&record, AutoregressionOrder::Fixed(2)).unwrap();
    let spectrum = fitted.spectrum(512).unwrap();
    let mean: f64 =
        (0..512).map(|k: usize| spectrum.covariances()[k.min(512 - k)][(0, 0)].re / 512.0).sum();
    let values = &record.channels()[0].values;
    let variance = values.iter().map(|v| (v - 5.0).powi(2)).sum::<f64>() / 20_000.0;
    assert!((mean / variance - 1.0).abs() < 0.03, "{mean} for {variance}");
}

#[test]
fn what_determines_nothing_is_refused() {
    let wave: Vec<f64> = (0..100).map(|k| f64::from(k * k % 17)).collect();
    let refused = |channels: Vec<Vec<f64>>, order: usize| {
        let found = VectorAutoregression::fit(&record(channels), AutoregressionOrder::Fixed(order));
        assert!(matches!(found, Err(ReconstructError::Noise { .. })), "{found:?}");
    };
    refused(vec![wave.clone(), wave.clone()], 1);
    refused(vec![wave.clone(), vec![3.0; 100]], 1);
    refused(vec![wave.clone()], 40);
    refused(vec![wave], usize::MAX);
}

#[test]
fn missing_samples_cost_the_equations_that_they_are_in_and_no_more() {
    let (whole, truth, _) = planted(40_000, 1);
    let mut channels = whole.channels().to_vec();
    for k in (20..40_000).step_by(50) {
        channels[k / 50 % 2].values[k] = f64::NAN;
    }
    let record = Record::with_missing("quiet", whole.period(), channels).unwrap();
    let fitted = VectorAutoregression::fit(&record, AutoregressionOrder::Fixed(2)).unwrap();
    // Interpolated samples would move it by 0.02 and more.
    for (found, truth) in fitted.coefficients().iter().zip(&truth) {
        assert!(
            (found[(0, 0)] - truth[(0, 0)]).abs() < 0.012,
            "{} {}",
            found[(0, 0)],
            truth[(0, 0)]
        );
        assert!(
            (found[(1, 1)] - truth[(1, 1)]).abs() < 0.012,
            "{} {}",
            found[(1, 1)],
            truth[(1, 1)]
        );
    }
    // Of these 300 samples every third is missing: no three in a row are there.
    let mut channels = planted(300, 2).0.channels().to_vec();
    (0..300).step_by(3).for_each(|k| channels[0].values[k] = f64::NAN);
    let record = Record::with_missing("quiet", whole.period(), channels).unwrap();
    let error = VectorAutoregression::fit(&record, AutoregressionOrder::Fixed(2)).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("has 0 runs of 3 samples of which none is missing"), "{text}");
}
