//! Planted systems other than the aircraft, and what is refused.

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, system};
use crate::{Measurement, ReconstructError};
use lti::s_to_z;

/// The distance of each eigenvalue in z from the closest one found, and that in deviations.
fn misses(found: &Reconstruction, eigenvalues: &[Complex<f64>]) -> Vec<(f64, f64)> {
    let miss = |z: &Complex<f64>| {
        let estimates = found.modes.iter().filter_map(|mode| mode.estimate.as_ref());
        let all = estimates.map(|estimate| {
            let distance = (estimate.discrete.value - z).norm();
            (distance, distance / estimate.discrete.covariance.trace().sqrt())
        });
        all.min_by(|x, y| x.0.total_cmp(&y.0)).unwrap()
    };
    eigenvalues.iter().map(miss).collect()
}

#[test]
fn systems_of_any_shape_are_found() {
    let z = Complex::new;
    // Sensors, lengths of the records, eigenvalues: with two sensors three records; growing, integrating, hardly damped modes.
    let cases = [
        (2, vec![900, 1000, 1100], vec![z(0.9, 0.0), z(0.3, 0.5)]),
        (3, vec![800, 600], vec![z(1.0, 0.0), z(0.6, 0.0)]),
        (4, vec![500, 600, 700], vec![z(1.002, 0.0), z(0.8, 0.55), z(-0.4, 0.0)]),
        (5, vec![1000, 1000], vec![z(0.97, 0.1), z(0.2, 0.9), z(0.5, 0.0), z(-0.6, 0.0)]),
    ];
    for (case, (sensors, samples, eigenvalues)) in cases.into_iter().enumerate() {
        let mut normal = Normal::new(40 + case as u64);
        let model = system(&eigenvalues, sensors, samples.len(), &mut normal);
        let quiet = fly(&model, &samples, &QUIET, &mut normal);
        let found = reconstruct(&quiet.records, &Options::default()).unwrap();
        assert_eq!(found.order().unwrap().order, model.order(), "{case}");
        for (distance, _) in misses(&found, &eigenvalues) {
            assert!(distance < 1e-7, "{case}: {distance:e}");
        }
        let noisy = fly(&model, &samples, &Disturbance { noise: 0.01, ..QUIET }, &mut normal);
        let order = OrderChoice::Fixed(model.order());
        let found = reconstruct(&noisy.records, &Options { order, ..Options::default() }).unwrap();
        for (distance, deviations) in misses(&found, &eigenvalues) {
            assert!(deviations < 5.0, "{case}: {distance:e} {deviations}");
        }
    }
}

#[test]
fn the_criterion_is_lowest_at_the_true_order() {
    let mut normal = Normal::new(60);
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.7, 0.0), Complex::new(0.95, 0.0)];
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let noisy = fly(&model, &[800, 900], &Disturbance { noise: 0.05, ..QUIET }, &mut normal);
    // One noise for all orders: where it starts is part of the criterion's constant.
    let noise = NoiseModel::Levels(noisy.levels.clone());
    let criterion = |order: usize| {
        let order = OrderChoice::Fixed(order);
        let options = Options { order, noise: noise.clone(), ..Options::default() };
        reconstruct(&noisy.records, &options).unwrap().fit().unwrap().criterion
    };
    let [lower, right, higher] = [3, 4, 5].map(criterion);
    assert!(lower > right + 100.0, "{lower} {right}");
    // Five more numbers fit noise: they gain about five and pay ten.
    assert!((0.0..20.0).contains(&(higher - right)), "{higher} {right}");
}

#[test]
fn a_mode_that_is_not_excited_is_doubted() {
    let mut normal = Normal::new(50);
    let mut model = system(&[Complex::new(0.9, 0.0), Complex::new(0.4, 0.0)], 4, 2, &mut normal);
    // In modal coordinates: the second record does not move the faster mode.
    model.a = DMatrix::from_row_slice(2, 2, &[0.9, 0.0, 0.0, 0.4]);
    let mut doubted = |weak: f64| {
        model.b[1] = nalgebra::DVector::from_row_slice(&[1.0, weak]);
        let flights =
            fly(&model, &[1000, 1000], &Disturbance { noise: 0.03, ..QUIET }, &mut normal);
        let order = OrderChoice::Fixed(2);
        let found =
            reconstruct(&flights.records, &Options { order, ..Options::default() }).unwrap();
        found.doubts.iter().any(|doubt| {
            matches!(
                doubt,
                Doubt::Subspace(subspace::Doubt::HardlyExcited { record, pole, .. })
                    if record == "record 1" && (pole.re - 0.4).abs() < 0.2
            )
        })
    };
    assert!(doubted(0.0));
    assert!(!doubted(2.0));
}

#[test]
fn the_same_records_give_the_same_result() {
    let records = pair("multistep_snr100");
    let run = || reconstruct(&records, &Options::default()).unwrap().fit().unwrap().clone();
    assert_eq!(run().model, run().model);
}

#[test]
fn what_cannot_be_computed_is_refused_with_numbers() {
    let records = pair("multistep_snr100");
    let refuse = |records: &[Record], options: &Options| {
        let error = reconstruct(records, options).unwrap_err();
        let said = error.to_string();
        (error, said)
    };
    for method in [Method::Subspace, Method::MaximumLikelihood] {
        let options = Options { method, ..Options::default() };
        let (error, said) = refuse(&records[..1], &options);
        assert!(
            matches!(error, ReconstructError::NotIdentifiable { records: 1, sensors: 3 }),
            "{said}"
        );
        let order = OrderChoice::Fixed(90);
        let (error, said) = refuse(&records, &Options { order, ..options.clone() });
        assert!(matches!(error, ReconstructError::OrderTooHigh { order: 90, .. }), "{said}");
        let noise = NoiseModel::Levels(vec![1.0, 1.0]);
        let (error, said) = refuse(&records, &Options { noise, ..options.clone() });
        assert!(
            matches!(error, ReconstructError::NoiseLevelCount { found: 2, sensors: 3 }),
            "{said}"
        );
        assert!(refuse(&[], &options).1.contains('0'));
    }
    let known_inputs = vec![vec![vec![1.0; 10]], Vec::new()];
    let (_, said) = refuse(
        &records,
        &Options {
            measurement: Measurement { known_inputs, ..Measurement::default() },
            ..Options::default()
        },
    );
    assert!(said.contains("300") && said.contains("10"), "{said}");
    let printed = Options { method: Method::Paper, ..Options::default() };
    assert!(matches!(
        refuse(&records[..1], &printed).0,
        ReconstructError::TooFewRecords { found: 1, needed: 2 }
    ));
}

#[test]
fn modes_come_by_real_part_of_z() {
    let found = reconstruct(&pair("white_snr100"), &Options::default()).unwrap();
    let period = found.model().unwrap().period;
    let z: Vec<_> =
        found.modes.iter().map(|mode| s_to_z(mode.mode.eigenvalue, period).unwrap().re).collect();
    assert!(z.windows(2).all(|pair| pair[0] <= pair[1]), "{z:?}");
}
