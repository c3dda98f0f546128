use nalgebra::{DMatrix, DVector};
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::{penalised::Penalised, program::hankel_shape, *};
use crate::{CfiModel, ConstantTerm, FitError, FitOptions, Orders, Segment, Structure};

fn noise(samples: usize, seed: u64) -> Vec<f64> {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    (0..samples).map(|_| StandardNormal.sample(&mut rng)).collect()
}

/// White input, and the output of a lightly damped second-order system with a noncausal part, plus noise.
fn record(samples: usize, deviation: f64) -> (Vec<f64>, Vec<f64>) {
    let u = noise(samples, 1);
    let v = noise(samples, 2);
    let mut y = vec![0.0; samples];
    for k in 2..samples {
        y[k] = 1.2 * y[k - 1] - 0.72 * y[k - 2] + u[k] - 0.3 * u[k - 1];
    }
    let ahead = |k: usize| u.get(k + 1).copied().unwrap_or(0.0);
    let output = (0..samples).map(|k| 5.0 * (y[k] + 0.5 * ahead(k) + deviation * v[k])).collect();
    (u, output)
}

fn structure(l: usize, r: usize, d: usize) -> Structure {
    Structure::new(Orders::new(l, r, d).unwrap(), ConstantTerm::Omitted)
}

/// The matrices of the objective 1/2 ||b - A x||^2 in the module's units, straight from its definition.
struct Dense {
    a: DMatrix<f64>,
    b: DVector<f64>,
    /// x = theta * units
    units: DVector<f64>,
}

impl Dense {
    fn new(input: &[f64], output: &[f64], s: Structure) -> Self {
        let (l, r, d) = (s.orders.iir(), s.orders.causal(), s.orders.anticausal());
        let steps: Vec<usize> = (r..input.len() - l.max(d)).collect();
        let n = steps.len() as f64;
        let rms =
            |values: &mut dyn Iterator<Item = f64>| (values.map(|x| x * x).sum::<f64>() / n).sqrt();
        let s_i = rms(&mut steps.iter().map(|k| input[*k]));
        let s_o = rms(&mut steps.iter().map(|k| output[k + l]));
        let free = s.denominator_count();
        let units =
            DVector::from_fn(s.parameter_count(), |j, _| if j < free { 1.0 } else { s_i / s_o });
        let regressor = |k: usize, j: usize| {
            if j < free { -output[k + 1 + j] } else { input[k + d - (j - free)] }
        };
        let a = DMatrix::from_fn(steps.len(), s.parameter_count(), |i, j| {
            regressor(steps[i], j) / units[j] / s_o / n.sqrt()
        });
        let b = DVector::from_fn(steps.len(), |i, _| output[steps[i] + l] / s_o / n.sqrt());
        Self { a, b, units }
    }

    fn x(&self, model: &CfiModel) -> DVector<f64> {
        DVector::from_vec(model.theta()).component_mul(&self.units)
    }

    /// Minus the gradient of the squared term.
    fn pull(&self, x: &DVector<f64>) -> DVector<f64> {
        self.a.tr_mul(&(&self.b - &self.a * x))
    }
}

fn fitted(
    input: &[f64],
    output: &[f64],
    s: Structure,
    what: Regularization,
    lambda: f64,
) -> RegularizedFit {
    let segments = [Segment::new(input, output).unwrap()];
    fit(&segments, &s, &what, &Lambda::Given(lambda), &Settings::default()).unwrap()
}

#[test]
fn weighted_squares_are_the_closed_form() {
    let (input, output) = record(300, 0.3);
    let s = structure(3, 7, 5);
    let dense = Dense::new(&input, &output, s);
    for (what, decay) in
        [(Regularization::Ridge, 1.0), (Regularization::ExponentiallyWeighted { decay: 0.6 }, 0.6)]
    {
        for lambda in [1e-3, 0.1, 10.0] {
            let fit = fitted(&input, &output, s, what, lambda);
            let weights = DVector::from_fn(15, |j, _| {
                if j < 2 { 0.0 } else { lambda / f64::powf(decay, (j as f64 - 7.0).abs()) }
            });
            let normal = dense.a.tr_mul(&dense.a) + DMatrix::from_diagonal(&weights);
            let expected = normal.cholesky().unwrap().solve(&dense.a.tr_mul(&dense.b));
            let error = (dense.x(&fit.model) - &expected).norm() / expected.norm();
            assert!(error < 1e-7, "{what:?} {lambda}: {error}");
            let objective = (&dense.b - &dense.a * &expected).norm_squared() / 2.0
                + expected.component_mul(&weights).dot(&expected) / 2.0;
            assert!((fit.objective - objective).abs() < 1e-9 * objective, "{what:?} {lambda}");
            assert_eq!(fit.status, Status::Solved);
            assert!(fit.relative_gap < 1e-6, "{}", fit.relative_gap);
        }
    }
}

#[test]
fn lasso_meets_its_optimality_conditions() {
    let (input, output) = record(300, 0.3);
    let s = structure(3, 7, 5);
    let dense = Dense::new(&input, &output, s);
    let mut zeros = Vec::new();
    for lambda in [1e-4, 1e-2, 0.1] {
        let x = dense.x(&fitted(&input, &output, s, Regularization::Lasso, lambda).model);
        let pull = dense.pull(&x);
        for j in 0..15 {
            let context =
                format!("lambda {lambda}, parameter {j}: x = {}, pull = {}", x[j], pull[j]);
            if j < 2 {
                assert!(pull[j].abs() < 1e-6, "free: {context}");
            } else if x[j].abs() > 1e-5 {
                assert!((pull[j] - lambda * x[j].signum()).abs() < 1e-6, "active: {context}");
            } else {
                assert!(pull[j].abs() < lambda + 1e-6, "zero: {context}");
            }
        }
        zeros.push(x.iter().skip(2).filter(|x| x.abs() < 1e-5).count());
    }
    assert!(zeros[0] < zeros[1] && zeros[1] < zeros[2], "more weight, more zeros: {zeros:?}");
}

#[test]
fn nuclear_norm_of_a_row_is_its_length() {
    // With r = d = 2 the Hankel matrices are columns of two: the penalty is a sum of two norms with a known gradient.
    let (input, output) = record(300, 0.3);
    let s = structure(3, 2, 2);
    let dense = Dense::new(&input, &output, s);
    let lambda = 0.002;
    let x = dense.x(&fitted(&input, &output, s, Regularization::NuclearNorm, lambda).model);
    let pull = dense.pull(&x);
    for pair in [[2, 3], [5, 6]] {
        let norm = x[pair[0]].hypot(x[pair[1]]);
        assert!(norm > 1e-2, "the case is meant to be smooth: {x}");
        for j in pair {
            assert!(
                (pull[j] - lambda * x[j] / norm).abs() < 1e-6,
                "{j}: {} {}",
                pull[j],
                lambda * x[j] / norm
            );
        }
    }
    for free in [0, 1, 4] {
        assert!(pull[free].abs() < 1e-6, "c_1, c_2 and h_0 are free: {free} {}", pull[free]);
    }
}

#[test]
fn nuclear_norm_is_the_answer_of_another_method() {
    let oracle: serde_json::Value =
        serde_json::from_str(include_str!("../../tests/data/nuclear_norm.json")).unwrap();
    let list = |name: &str| -> Vec<f64> {
        oracle[name].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let s = structure(2, 8, 5);
    let lambda = oracle["lambda"].as_f64().unwrap();
    let fit = fitted(&list("input"), &list("output"), s, Regularization::NuclearNorm, lambda);
    let objective = oracle["objective"].as_f64().unwrap();
    assert!((fit.objective - objective).abs() < 1e-9 * objective, "{} {objective}", fit.objective);
    for (found, expected) in fit.model.theta().iter().zip(list("theta")) {
        assert!((found - expected).abs() < 1e-5, "{found} {expected}");
    }
}

#[test]
fn vanishing_weight_recovers_least_squares() {
    let (input, output) = record(400, 0.3);
    let s = structure(4, 6, 5);
    let segments = [Segment::new(&input, &output).unwrap()];
    let plain = crate::fit(&segments, &s, &FitOptions::default()).unwrap();
    let theta = DVector::from_vec(plain.model.theta());
    let all = [
        Regularization::Ridge,
        Regularization::Lasso,
        Regularization::ExponentiallyWeighted { decay: 0.8 },
        Regularization::NuclearNorm,
    ];
    for what in all {
        let mut last = f64::INFINITY;
        for (lambda, limit) in [(1e-3, 1.0), (1e-6, 1e-3), (0.0, 1e-7)] {
            let fit = fitted(&input, &output, s, what, lambda);
            let error = (DVector::from_vec(fit.model.theta()) - &theta).norm() / theta.norm();
            assert!(error < limit && error < last, "{what:?} {lambda}: {error}");
            assert!(fit.relative_residual >= plain.relative_residual * (1.0 - 1e-9));
            last = error;
        }
    }
}

#[test]
fn weight_has_no_unit_and_does_not_depend_on_the_number_of_samples() {
    let (input, output) = record(300, 0.3);
    let s = structure(3, 4, 3);
    let small: Vec<f64> = input.iter().map(|x| x * 1e-90).collect();
    let large: Vec<f64> = output.iter().map(|x| x * 1e120).collect();
    let (one, twice) =
        (Segment::new(&input, &output).unwrap(), Segment::new(&small, &large).unwrap());
    for what in [Regularization::Lasso, Regularization::NuclearNorm] {
        let solve = |segments: &[Segment<'_>]| {
            fit(segments, &s, &what, &Lambda::Given(0.03), &Settings::default()).unwrap()
        };
        let reference = solve(&[one]);
        let scaled = solve(&[twice]);
        let repeated = solve(&[one, one]);
        for i in -3..=4 {
            let h = reference.model.markov_parameter(i);
            assert!((repeated.model.markov_parameter(i) - h).abs() < 1e-5, "{what:?} {i}");
            assert!((scaled.model.markov_parameter(i) * 1e-210 - h).abs() < 1e-5, "{what:?} {i}");
        }
    }
}

#[test]
fn penalties_help_where_least_squares_fits_the_noise() {
    // 70 equations, 41 Markov parameters, of which the planted system needs a few: least squares spreads the noise over all.
    let (input, output) = record(110, 1.0);
    let s = structure(0, 25, 15);
    let segments = [Segment::new(&input, &output).unwrap()];
    let mut impulse = vec![0.0; 41];
    let mut y = [0.0; 28];
    for k in 2..28 {
        let u = |k: usize| if k == 2 { 1.0 } else { 0.0 };
        y[k] = 1.2 * y[k - 1] - 0.72 * y[k - 2] + u(k) - 0.3 * u(k - 1);
        impulse[15 + k - 2] = 5.0 * y[k];
    }
    impulse[14] = 2.5;
    let error = |model: &CfiModel| {
        model.theta().iter().zip(&impulse).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let plain = error(&crate::fit(&segments, &s, &FitOptions::default()).unwrap().model);
    let candidates: Vec<f64> = (-8..=0).map(|i| 10.0_f64.powf(f64::from(i) / 2.0)).collect();
    let lambda = Lambda::HoldOut { candidates, fraction: 0.45 };
    let mut errors = Vec::new();
    let all = [
        Regularization::Lasso,
        Regularization::ExponentiallyWeighted { decay: 0.7 },
        Regularization::NuclearNorm,
    ];
    for what in all {
        let fit = fit(&segments, &s, &what, &lambda, &Settings::default()).unwrap();
        assert_eq!(fit.hold_out.len(), 9);
        let best =
            fit.hold_out.iter().map(|s| s.prediction_rms.unwrap()).fold(f64::INFINITY, f64::min);
        let chosen = fit.hold_out.iter().find(|s| s.lambda.total_cmp(&fit.lambda).is_eq()).unwrap();
        assert!(chosen.prediction_rms.unwrap() <= best);
        errors.push(error(&fit.model) / plain);
    }
    assert!(errors.iter().all(|e| *e < 0.75), "{errors:?} of {plain}");
}

#[test]
fn nuclear_norm_lowers_the_rank() {
    let (input, output) = record(400, 0.2);
    let s = structure(0, 15, 5);
    let fit = fitted(&input, &output, s, Regularization::NuclearNorm, 0.05);
    let past: Vec<f64> = (1..=15).map(|i| fit.model.markov_parameter(i)).collect();
    let (rows, columns) = hankel_shape(15);
    let values = DMatrix::from_fn(rows, columns, |i, j| past[i + j]).singular_values();
    assert!(values[1] > 0.1 * values[0] && values[2] < 1e-4 * values[0], "second order: {values}");
}

#[test]
fn hankel_shapes_use_every_element_once_at_least() {
    for (count, expected) in
        [(0, (0, 0)), (1, (1, 1)), (2, (1, 2)), (3, (2, 2)), (25, (13, 13)), (8, (4, 5))]
    {
        assert_eq!(hankel_shape(count), expected);
    }
}

#[test]
fn bad_options_are_refused() {
    let (input, output) = record(100, 0.3);
    let s = structure(2, 3, 3);
    let segments = [Segment::new(&input, &output).unwrap()];
    let attempt = |what, lambda: Lambda, settings: Settings| {
        fit(&segments, &s, &what, &lambda, &settings).unwrap_err()
    };
    let hold_out = |candidates: &[f64], fraction| Lambda::HoldOut {
        candidates: candidates.to_vec(),
        fraction,
    };
    let usual = Settings::default;
    let bad = [
        attempt(Regularization::Ridge, Lambda::Given(-1.0), usual()),
        attempt(Regularization::Ridge, Lambda::Given(f64::NAN), usual()),
        attempt(Regularization::Ridge, hold_out(&[], 0.2), usual()),
        attempt(Regularization::Ridge, hold_out(&[f64::INFINITY], 0.2), usual()),
        attempt(Regularization::Ridge, hold_out(&[1.0], 0.0), usual()),
        attempt(Regularization::Ridge, hold_out(&[1.0], f64::NAN), usual()),
        attempt(Regularization::ExponentiallyWeighted { decay: 0.0 }, Lambda::Given(1.0), usual()),
        attempt(Regularization::ExponentiallyWeighted { decay: 1.5 }, Lambda::Given(1.0), usual()),
        attempt(Regularization::ExponentiallyWeighted { decay: 1e-7 }, Lambda::Given(1.0), usual()),
        attempt(Regularization::Ridge, Lambda::Given(1.0), Settings { tolerance: 0.0, ..usual() }),
        attempt(
            Regularization::Ridge,
            Lambda::Given(1.0),
            Settings { max_iterations: 0, ..usual() },
        ),
    ];
    for error in bad {
        assert!(matches!(error, FitError::BadValue { .. }), "{error:?}");
    }
    // The last 2 % of 100 samples hold no equation; the first 4 % are fewer than D(q) needs.
    let held = attempt(Regularization::Ridge, hold_out(&[1.0], 0.02), usual());
    assert!(matches!(held, FitError::TooShort { samples: 2, needed: 7, .. }), "{held:?}");
    let training = attempt(Regularization::Ridge, hold_out(&[1.0], 0.96), usual());
    assert!(matches!(training, FitError::TooFewSamples { .. }), "{training:?}");
}

#[test]
fn an_unsolved_program_is_an_error() {
    let (input, output) = record(100, 0.3);
    let penalised =
        Penalised::new(&[Segment::new(&input, &output).unwrap()], &structure(2, 3, 3)).unwrap();
    let hasty = Settings { max_iterations: 1, ..Settings::default() };
    let error = penalised.solve(Regularization::NuclearNorm, 0.1, &hasty).unwrap_err();
    assert_eq!(error, FitError::Unsolved { status: Status::IterationLimit });
    assert_eq!(
        error.to_string(),
        "the regularised problem was not solved: iteration limit reached"
    );
}
