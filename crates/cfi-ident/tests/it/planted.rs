//! Planted models come back, from noise-free records of any structure and, within their covariance, from noisy ones.

use cfi_ident::{
    CfiModel, ConstantTerm, Fit, FitOptions, Orders, Prediction, Segment, Structure, fit,
};
use proptest::prelude::*;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rand_distr::{Distribution, StandardNormal};

pub(crate) fn noise(samples: usize, seed: u64) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..samples).map(|_| StandardNormal.sample(&mut rng)).collect()
}

/// A record of the model under white input, from the first simulated sample on, with equation errors of the given deviation.
pub(crate) fn record(
    model: &CfiModel,
    samples: usize,
    deviation: f64,
    seed: u64,
) -> (Vec<f64>, Vec<f64>) {
    let orders = model.structure().orders;
    let (l, r, d) = (orders.iir(), orders.causal(), orders.anticausal());
    let input = noise(samples + r + l.max(d), seed);
    let errors = noise(input.len(), seed + 1);
    let mut output = vec![0.0; input.len()];
    let c = model.denominator();
    for k in r..input.len() - l.max(d) {
        let past: f64 = (0..l).map(|i| c[i] * output[k + i]).sum();
        let reach = -(d as isize)..=(r as isize);
        let forced: f64 = reach
            .map(|i| model.markov_parameter(i) * input[k.checked_add_signed(-i).unwrap()])
            .sum();
        output[k + l] = forced - past + deviation * errors[k];
    }
    let (from, to) = (r + l, input.len() - l.max(d) + l);
    (input[from..to].to_vec(), output[from..to].to_vec())
}

fn identify(input: &[f64], output: &[f64], structure: Structure) -> Fit {
    fit(&[Segment::new(input, output).unwrap()], &structure, &FitOptions::default()).unwrap()
}

/// D(q) with roots inside or on the unit circle: near +-1, near each other, or complex close to the circle.
fn denominator(kind: u8, near: f64) -> Vec<f64> {
    match kind {
        0 => vec![1.0],
        1 => vec![-(1.0 - near), 1.0],
        2 => vec![(1.0 - near) * 0.9, -(1.9 - near), 1.0],
        _ => vec![1.0 - near, -1.6 * (1.0 - near).sqrt(), 1.0],
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn noise_free_records_give_the_model_back(
        kind in 0_u8..4,
        near in prop::sample::select(vec![0.0, 1e-6, 1e-3, 0.05, 0.4]),
        markov in prop::collection::vec(-1.0..1.0_f64, 1..12),
        split in 0_usize..12,
        seed in 0_u64..1000,
    ) {
        let d = split.min(markov.len() - 1);
        let c = denominator(kind, near);
        let orders = Orders::new(c.len() - 1, markov.len() - 1 - d, d).unwrap();
        let structure = Structure::new(orders, ConstantTerm::Included);
        let planted = CfiModel::new(structure, &c[..c.len() - 1], &markov).unwrap();
        let (input, output) = record(&planted, 200, 0.0, seed);
        let found = identify(&input, &output, structure);
        // A FIR factor that vanishes leaves D to the rounding of the record.
        let size = markov.iter().fold(0.0, |m: f64, h| m.max(h.abs()));
        prop_assume!(size > 1e-2);
        prop_assert_eq!(found.rank, structure.parameter_count());
        for (a, b) in found.model.theta().iter().zip(planted.theta()) {
            prop_assert!((a - b).abs() < 1e-15 * found.condition.max(10.0) * 10.0, "{} {} {}", a, b, found.condition);
        }
        prop_assert!(found.refinement.converged);
    }

    #[test]
    fn residuals_of_any_fit_are_orthogonal_to_the_regressors(
        l in 0_usize..4, r in 0_usize..5, d in 0_usize..5, included in any::<bool>(), seed in 0_u64..1000,
    ) {
        // No model behind the data at all: the normal equations are what defines the answer.
        let constant_term = if included { ConstantTerm::Included } else { ConstantTerm::Omitted };
        let structure = Structure::new(Orders::new(l, r, d).unwrap(), constant_term);
        let (input, output) = (noise(80, seed), noise(80, seed + 7));
        let found = identify(&input, &output, structure);
        let residuals = found.model.residuals(&input, &output).unwrap();
        prop_assert_eq!(residuals.values.len(), found.equations);
        for (n, residual) in residuals.values.iter().enumerate() {
            let predicted = found.model.predict(&input, &output, Prediction::OneStep).unwrap().values[n];
            prop_assert!((predicted + residual - output[residuals.first + n]).abs() < 1e-14);
        }
        let against = |signal: &[f64], shift: isize| -> f64 {
            residuals.values.iter().enumerate().map(|(n, e)| e * signal[(n + r).checked_add_signed(shift).unwrap()]).sum()
        };
        for i in structure.orders.iir() - structure.denominator_count()..l {
            prop_assert!(against(&output, i as isize).abs() < 1e-11);
        }
        for i in -(d as isize)..=(r as isize) {
            prop_assert!(against(&input, -i).abs() < 1e-11);
        }
        let norm = residuals.values.iter().map(|x| x * x).sum::<f64>().sqrt();
        prop_assert!((norm - found.residual_norm).abs() < 1e-12);
    }
}

#[test]
fn covariance_is_the_scatter_of_the_estimates() {
    let structure = Structure::new(Orders::new(2, 2, 1).unwrap(), ConstantTerm::Included);
    let planted = CfiModel::new(structure, &[0.72, -1.5], &[0.3, 1.0, -0.4, 0.2]).unwrap();
    let truth = planted.theta();
    let runs = 300;
    let mut squares = vec![0.0; truth.len()];
    let mut variance = 0.0;
    for seed in 0..runs {
        let (input, output) = record(&planted, 400, 0.2, 1000 + 2 * seed);
        let found = identify(&input, &output, structure);
        variance += found.noise_variance.unwrap() / runs as f64;
        for (i, square) in squares.iter_mut().enumerate() {
            let z = (found.model.theta()[i] - truth[i]) / found.parameter_covariance[(i, i)].sqrt();
            *square += z * z / runs as f64;
        }
    }
    // Mean squares of 300 standard normal deviates scatter by 0.08.
    assert!(squares.iter().all(|s| (0.7..1.35).contains(s)), "{squares:?}");
    assert!((variance - 0.04).abs() < 0.001, "{variance}");
}

#[test]
fn covariance_transforms_with_the_units() {
    let structure = Structure::new(Orders::new(2, 1, 1).unwrap(), ConstantTerm::Included);
    let planted = CfiModel::new(structure, &[0.5, -1.2], &[1.0, 0.5, 0.25]).unwrap();
    let (input, output) = record(&planted, 200, 0.1, 5);
    let scaled: Vec<f64> = output.iter().map(|x| x * 1024.0).collect();
    let (one, two) = (identify(&input, &output, structure), identify(&input, &scaled, structure));
    for i in 0..5 {
        for j in 0..5 {
            let factor = if i < 2 { 1.0 } else { 1024.0 } * if j < 2 { 1.0 } else { 1024.0 };
            let (a, b) =
                (one.parameter_covariance[(i, j)] * factor, two.parameter_covariance[(i, j)]);
            assert_eq!(a.to_bits(), b.to_bits(), "powers of two change nothing: {i} {j}");
        }
    }
    assert_eq!(
        (one.noise_variance.unwrap() * 1024.0 * 1024.0).to_bits(),
        two.noise_variance.unwrap().to_bits()
    );
    assert_eq!((one.residual_rms * 1024.0).to_bits(), two.residual_rms.to_bits());
}

#[test]
fn repeated_segment_halves_the_covariance() {
    let structure = Structure::new(Orders::new(2, 1, 1).unwrap(), ConstantTerm::Included);
    let planted = CfiModel::new(structure, &[0.5, -1.2], &[1.0, 0.5, 0.25]).unwrap();
    let (input, output) = record(&planted, 300, 0.1, 9);
    let segment = Segment::new(&input, &output).unwrap();
    let one = fit(&[segment], &structure, &FitOptions::default()).unwrap();
    let two = fit(&[segment, segment], &structure, &FitOptions::default()).unwrap();
    assert_eq!(two.equations, 2 * one.equations);
    for (a, b) in one.model.theta().iter().zip(two.model.theta()) {
        assert!((a - b).abs() < 1e-14);
    }
    let freedom = two.degrees_of_freedom as f64 / one.degrees_of_freedom as f64;
    let ratio = one.parameter_covariance[(0, 0)] / two.parameter_covariance[(0, 0)];
    assert!((ratio - freedom).abs() < 1e-10, "{ratio} {freedom}");
}
