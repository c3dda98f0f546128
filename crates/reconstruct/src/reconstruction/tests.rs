mod doubts;
mod flights;
mod nonlinear;
mod options;
mod planted;

use super::*;
use crate::shipped::{pair, read};
use crate::{Channel, Method, NoiseModel, Options, subspace::OrderChoice};
use flights::TRUTH;
use num_complex::Complex;

/// Distance of each true eigenvalue from the closest one found, in 1/s, and in deviations where there are any.
fn misses(found: &Reconstruction) -> Vec<(f64, f64)> {
    let miss = |(re, im): (f64, f64)| {
        let truth = Complex::new(re, im);
        let distance = |found: &&FoundMode| (found.mode.eigenvalue - truth).norm();
        let closest = found.modes.iter().min_by(|x, y| distance(x).total_cmp(&distance(y)));
        let closest = closest.unwrap();
        let deviation = closest
            .estimate
            .as_ref()
            .map_or(f64::NAN, |estimate| estimate.continuous.covariance.trace().sqrt());
        (distance(&closest), distance(&closest) / deviation)
    };
    TRUTH.map(miss).to_vec()
}

#[test]
fn noisy_records_give_modes_levels_and_no_doubt() {
    let levels: serde_json::Value = serde_json::from_str(&read("noise_levels.json")).unwrap();
    for (name, tolerance) in
        [("white_snr100", 0.05), ("white_snr10", 0.05), ("multistep_snr100", 0.15)]
    {
        let found = reconstruct(&pair(name), &Options::default()).unwrap();
        assert_eq!(found.order().unwrap().order, 4, "{name}");
        assert_eq!(found.modes.len(), 3, "{name}");
        assert!(found.doubts.is_empty(), "{name}: {:?}", found.doubts);
        for (distance, deviations) in misses(&found) {
            assert!(deviations < 4.0, "{name}: {distance} {deviations}");
        }
        let expected = levels[name].as_array().unwrap();
        for (level, expected) in found.noise_levels().unwrap().iter().zip(expected) {
            let ratio = level.value / expected.as_f64().unwrap();
            assert!((ratio - 1.0).abs() < tolerance, "{name}: {ratio}");
        }
        assert!(found.excitations().iter().all(|excitation| excitation.rank == 1));
        assert!(found.fit().unwrap().chi_squared.p_value.is_none());
        let starts = &found.fit().unwrap().starts;
        // A clear gap needs no other number of block rows.
        let clear = found.order().unwrap().gap > 1000.0;
        assert_eq!(starts.len(), if clear { 1 } else { 3 }, "{name}");
    }
}

#[test]
fn records_without_noise_give_eigenvalues_to_seven_digits() {
    let records = pair("noise_free");
    let found = reconstruct(&records, &Options::default()).unwrap();
    assert!(found.doubts.is_empty(), "{:?}", found.doubts);
    for (distance, deviations) in misses(&found) {
        assert!(distance < 1e-7 && deviations < 4.0, "{distance:e} {deviations}");
    }
}

#[test]
fn each_method_can_be_chosen() {
    let mut options = Options { method: Method::Paper, ..Options::default() };
    let printed = reconstruct(&pair("noise_free"), &options).unwrap();
    assert_eq!(printed.modes.len(), 3);
    assert!(matches!(printed.details, Details::Paper(_)) && printed.model().is_none());
    assert!(misses(&printed).iter().all(|(distance, _)| *distance < 1e-7));
    let noisy = pair("white_snr100");
    assert!(!reconstruct(&noisy, &options).unwrap().doubts.is_empty());

    options.method = Method::Subspace;
    options.measurement.offsets = crate::Offsets::Free;
    let subspace = reconstruct(&noisy, &options).unwrap();
    assert!(matches!(subspace.details, Details::Subspace { .. }) && subspace.fit().is_none());
    assert_eq!(subspace.modes.len(), 3);
    assert!(misses(&subspace).iter().all(|(distance, _)| *distance < 0.02));
    options.method = Method::MaximumLikelihood;
    let best = reconstruct(&noisy, &options).unwrap();
    // The first stage is the same, whatever follows.
    assert_eq!(best.intersection(), subspace.intersection());
    assert!(
        best.modes.iter().all(|mode| mode.estimate.is_some() && mode.excitation_snr.len() == 2)
    );
}
