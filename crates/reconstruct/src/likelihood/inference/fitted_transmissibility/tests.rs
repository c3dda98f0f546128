use lti::{ExcitationPair, PairChannels};
use poly::{MrootsOptions, mroots};

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, system};
use crate::likelihood::{Options, identify};
use crate::paper::{TransmissibilityPair, containment};

fn planted(seed: u64, feedthrough: bool) -> (SharedModel, Fit) {
    let mut normal = Normal::new(seed);
    let eigenvalues = [Complex::new(0.95, 0.0), Complex::new(0.7, 0.3)];
    let mut model = system(&eigenvalues, 3, 2, &mut normal);
    let mut options = Options::default();
    if feedthrough {
        let d = |normal: &mut Normal| DVector::from_vec(vec![0.0, normal.next(), 0.0]);
        model.feedthrough = Some(vec![d(&mut normal), d(&mut normal)]);
        options.measurement.feedthrough_sensors = vec![1];
    }
    let flights = fly(&model, &[1200, 900], &Disturbance { noise: 0.01, ..QUIET }, &mut normal);
    options.noise = given(&flights.levels).noise;
    let fit = identify(&flights.records, std::slice::from_ref(&model), &options).unwrap();
    (model, fit)
}

/// The true response from the excitation of one record to all sensors.
fn truth(model: &SharedModel, record: usize, frequency: f64) -> DVector<Complex<f64>> {
    let z = Complex::from_polar(1.0, frequency * model.period.seconds());
    let at = At::new(model, record, z).unwrap();
    let direct = |sensor: usize| model.feedthrough.as_ref().map_or(0.0, |all| all[record][sensor]);
    let reading = model.c.map(Complex::from) * at.states;
    DVector::from_fn(3, |sensor, _| reading[sensor] + direct(sensor))
}

/// Squared distance in the metric of the covariance: chi-squared with two degrees of freedom, or one for a real number.
fn squared_distance(estimate: &ComplexEstimate, truth: Complex<f64>) -> f64 {
    let miss = nalgebra::Vector2::new((estimate.value - truth).re, (estimate.value - truth).im);
    let eigen = estimate.covariance.symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let along = (0..2).filter(|&k| eigen.eigenvalues[k] > 1e-9 * largest);
    along.map(|k| eigen.eigenvectors.column(k).dot(&miss).powi(2) / eigen.eigenvalues[k]).sum()
}

#[test]
fn responses_lie_within_their_bands() {
    let frequencies = [0.0, 0.3, 2.0, 9.0, 25.0];
    let (mut sum, mut count) = (0.0, 0.0);
    for seed in 0..12 {
        for feedthrough in [false, true] {
            let (model, fit) = planted(seed, feedthrough);
            let found = fitted_transmissibilities(&fit, &frequencies).unwrap();
            assert_eq!(found.len(), 6);
            for one in &found {
                for (estimate, &frequency) in one.response.iter().zip(&frequencies) {
                    let expected = truth(&model, one.record, frequency);
                    let square = squared_distance(estimate, expected[one.to] / expected[one.from]);
                    assert!(square < 30.0, "{seed} {feedthrough} {frequency}: {square}");
                    // A real number at frequency zero.
                    let freedom = if frequency > 0.0 { 2.0 } else { 1.0 };
                    (sum, count) = (sum + square / freedom, count + 1.0);
                }
            }
        }
    }
    // Responses of one fit depend on each other; far fewer than their number count.
    let mean: f64 = sum / count;
    assert!((mean - 1.0).abs() < 0.25, "{mean}");
}

#[test]
fn zeros_and_poles_lie_within_their_ellipses() {
    for seed in 0..6 {
        let (model, fit) = planted(seed, false);
        for one in fitted_transmissibilities(&fit, &[]).unwrap() {
            let exact = StateSpace::<Discrete>::new(
                model.a.clone(),
                DMatrix::from_column_slice(3, 1, model.b[one.record].as_slice()),
                model.c.rows(one.to, 1).into_owned(),
                DMatrix::zeros(1, 1),
                model.period,
            );
            let exact = exact.unwrap().invariant_zeros().unwrap().values();
            assert_eq!((exact.len(), one.zeros.len(), one.poles.len()), (2, 2, 2));
            for z in exact {
                let closest = one.zeros.iter().map(|zero| {
                    let deviation = zero.covariance.trace().sqrt();
                    (zero.value - z).norm() / deviation
                });
                // A pair that is about to become real moves faster than to first order.
                let closest = closest.fold(f64::INFINITY, f64::min);
                assert!(closest < 5.0, "{seed}: {z} {closest}");
            }
        }
    }
}

#[test]
fn slopes_are_those_of_differences() {
    let (_, fit) = planted(1, true);
    let free = Parameters::of(&fit);
    let z = Complex::from_polar(1.0, 0.3);
    let gain = At::new(&fit.model, 1, z).unwrap().gain(&fit.model, &free, 1, 1);
    const STEP: f64 = 1e-6;
    let (n, m) = (3, 3);
    for k in 0..free.count {
        let mut moved = fit.model.clone();
        if k < n * n {
            moved.a[k] += STEP;
        } else if k < n * (n + m) {
            moved.c[k - n * n] += STEP;
        } else {
            let (record, own) = ((k - n * (n + m)) / free.own, (k - n * (n + m)) % free.own);
            if own < n {
                moved.b[record][own] += STEP;
            } else if let Some(all) = &mut moved.feedthrough {
                all[record][1] += STEP;
            }
        }
        let there = At::new(&moved, 1, z).unwrap().gain(&moved, &free, 1, 1);
        let slope = (there.value - gain.value) / STEP;
        let size = 1.0 + gain.slopes[k].norm();
        assert!((slope - gain.slopes[k]).norm() < 1e-4 * size, "{k}: {slope} {}", gain.slopes[k]);
    }
}

#[test]
fn the_determinant_of_the_fitted_pair_has_the_eigenvalues_among_its_roots() {
    let (_, fit) = planted(3, false);
    let model = &fit.model;
    let b = DMatrix::from_columns(&model.b);
    let system = StateSpace::<Discrete>::new(
        model.a.clone(),
        b,
        model.c.clone(),
        DMatrix::zeros(3, 2),
        model.period,
    )
    .unwrap();
    let eigenvalues = model.poles().unwrap();
    for (from, to) in [(0, 1), (0, 2), (1, 2)] {
        let channels = PairChannels { excitations: [0, 1], from_output: from, to_output: to };
        let [first, second] =
            ExcitationPair::between(&system, channels).unwrap().transmissibilities().unwrap();
        let pair = TransmissibilityPair::new(first, second);
        let determinant = pair.theorem_rounded(3, 1e-12).unwrap().determinant;
        let roots = mroots(&determinant, &MrootsOptions::default()).unwrap().values();
        let distance = containment(&eigenvalues, &roots).largest_distance();
        assert!(distance < 1e-9, "{from} {to}: {distance:e}");
        // A system that is not the fitted one has others.
        let other: Vec<_> = eigenvalues.iter().map(|z| z * 1.001).collect();
        assert!(containment(&other, &roots).largest_distance() > 1e-5);
    }
}
