use lti::SamplePeriod;
use nalgebra::{Complex, DMatrix, DVector};
use proptest::prelude::*;

use super::{Realization, realize, realize_siso};
use crate::fixtures::matrix;
use crate::{EraError, EraOptions, FloorOrigin, Order, OrderReason};

fn period() -> SamplePeriod {
    SamplePeriod::new(0.1).unwrap()
}

/// `h_0 = 0.25`, `h_k = sum_i weight_i pole_i^(k-1)`, with the conjugate of every complex pole.
fn planted(poles: &[(f64, f64)], count: usize) -> Vec<f64> {
    let mut sequence = vec![0.25];
    for k in 0..count {
        let terms = poles.iter().zip(1_u8..).map(|(&(re, im), weight)| {
            let term = Complex::new(re, im).powu(u32::try_from(k).unwrap()) * f64::from(weight);
            if im > 0.0 { 2.0 * (term * Complex::new(1.0, 0.5)).re } else { term.re }
        });
        sequence.push(terms.sum());
    }
    sequence
}

/// Distance of every planted pole from the nearest one found.
fn pole_error(realization: &Realization, poles: &[(f64, f64)]) -> f64 {
    let found = realization.system.a().complex_eigenvalues();
    poles
        .iter()
        .map(|&(re, im)| {
            found.iter().map(|z| (z - Complex::new(re, im)).norm()).fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

#[test]
fn planted_poles_and_orders_are_recovered() {
    fn check(poles: &[(f64, f64)], tolerance: f64) {
        let order = poles.iter().map(|&(_, im)| if im > 0.0 { 2 } else { 1 }).sum::<usize>();
        let sequence = planted(poles, 25);
        for rule in [Order::Gap, Order::Fixed(order), Order::Tolerance(1e-9)] {
            let realization =
                realize_siso(&sequence, period(), &EraOptions::with_order(rule)).unwrap();
            assert_eq!(
                realization.order, order,
                "{poles:?} {rule:?} {:?}",
                realization.singular_values
            );
            let error = pole_error(&realization, poles);
            assert!(error < tolerance, "{poles:?} {rule:?}: {error:e}");
            assert!(realization.residual < 1e-13, "{:e}", realization.residual);
            assert_eq!(realization.system.d()[(0, 0)], 0.25);
        }
    }
    check(&[(0.9, 0.0)], 1e-14);
    check(&[(0.9, 0.0), (-0.5, 0.0)], 1e-13);
    check(&[(0.6, 0.7)], 1e-13);
    check(&[(1.0, 0.0)], 1e-13);
    check(&[(-1.0, 0.0), (0.6, 0.8)], 1e-13);
    check(&[(1.3, 0.0), (0.4, 0.0)], 1e-11);
    check(&[(0.999, 0.02)], 1e-11);
    check(&[(0.9469, 0.0), (0.9788, 0.1672)], 1e-9);
}

#[test]
fn a_repeated_pole_keeps_its_characteristic_polynomial() {
    // h_k = k 0.8^(k-1): a Jordan block. Its eigenvalues move by the root of the rounding error, trace and determinant do not.
    let sequence: Vec<f64> = (0..=20).map(|k| f64::from(k) * 0.8_f64.powi(k - 1)).collect();
    let realization = realize_siso(&sequence, period(), &EraOptions::default()).unwrap();
    assert_eq!(realization.order, 2);
    assert!((realization.system.a().trace() - 1.6).abs() < 1e-12);
    assert!((realization.system.a().determinant() - 0.64).abs() < 1e-12);
    assert!(pole_error(&realization, &[(0.8, 0.0)]) < 1e-5);
}

#[test]
fn nothing_is_realized_below_rounding_level() {
    let sequence = planted(&[(0.9, 0.0), (-0.5, 0.0)], 25);
    let realization =
        realize_siso(&sequence, period(), &EraOptions::with_order(Order::Fixed(6))).unwrap();
    assert_eq!(realization.order, 2);
    let reason = OrderReason::LimitedByRounding { requested: 6, floor: realization.floor.value };
    assert_eq!(realization.reason, reason);
    assert!(realization.singular_values[1] > 1e-3);
    assert!(realization.singular_values[2] < realization.floor.value);
    assert_eq!(realization.singular_values.len(), 12);
}

#[test]
fn stated_noise_raises_the_floor() {
    // The perturbation stays below 1e-6 and follows no recursion of low order.
    let mut sequence = planted(&[(0.9, 0.0), (-0.5, 0.0)], 25);
    for (k, value) in sequence.iter_mut().enumerate() {
        let k = f64::from(u8::try_from(k).unwrap());
        *value += 1e-6 * (k * k).sin();
    }
    let trusting =
        realize_siso(&sequence, period(), &EraOptions::with_order(Order::Fixed(6))).unwrap();
    assert_eq!((trusting.order, trusting.reason), (6, OrderReason::Fixed));

    let options = EraOptions::with_order(Order::Fixed(6)).noise_floor(1e-6);
    let wary = realize_siso(&sequence, period(), &options).unwrap();
    assert_eq!(wary.order, 2);
    assert_eq!(wary.floor.origin, FloorOrigin::Noise);
    // A 12 by 13 matrix.
    assert!((wary.floor.value - 1e-6 * 156.0_f64.sqrt()).abs() < 1e-18);
    assert!((wary.parameter_floor - 1e-6).abs() < 1e-18);
    assert_eq!(wary.reason, OrderReason::LimitedByNoise { requested: 6, floor: wary.floor.value });
    assert!(pole_error(&wary, &[(0.9, 0.0), (-0.5, 0.0)]) < 1e-5);
}

#[test]
fn the_scale_of_the_numbers_does_not_matter() {
    let poles = [(0.9, 0.0), (0.6, 0.7)];
    let plain = planted(&poles, 20);
    let reference = realize_siso(&plain, period(), &EraOptions::default()).unwrap();
    for scale in [1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300] {
        let scaled: Vec<f64> = plain.iter().map(|value| value * scale).collect();
        let realization = realize_siso(&scaled, period(), &EraOptions::default()).unwrap();
        assert_eq!(realization.order, 3, "{scale:e}");
        assert!(pole_error(&realization, &poles) < 1e-12, "{scale:e}");
        assert!(realization.residual < 1e-13);
        for (ours, expected) in
            realization.singular_values.iter().zip(&reference.singular_values).take(3)
        {
            assert!((ours / scale / expected - 1.0).abs() < 1e-12);
        }
        let floors = realization.floor.value / scale / reference.floor.value;
        assert!((floors - 1.0).abs() < 1e-9, "{floors}");
        let first = (realization.system.c() * realization.system.b())[(0, 0)];
        assert!((first / scaled[1] - 1.0).abs() < 1e-13);
    }
}

#[test]
fn an_all_zero_sequence_is_its_feedthrough() {
    for rule in [Order::Gap, Order::Tolerance(0.0)] {
        let realization =
            realize_siso(&[3.0, 0.0, 0.0, 0.0], period(), &EraOptions::with_order(rule)).unwrap();
        assert_eq!(realization.order, 0);
        assert!(matches!(realization.reason, OrderReason::NothingAboveFloor { .. }));
        assert_eq!((realization.residual, realization.condition), (0.0, 1.0));
        assert_eq!(realization.system.d(), &matrix(&[[3.0]]));
        assert_eq!(realization.system.a().shape(), (0, 0));
    }
    let zero = realize_siso(&[0.0; 5], period(), &EraOptions::default()).unwrap();
    assert_eq!((zero.order, zero.floor.value), (0, 0.0));
}

#[test]
fn a_finite_sequence_is_nilpotent() {
    let mut sequence = vec![0.0, 4.0, -3.0, 2.0, 1.0];
    sequence.resize(20, 0.0);
    let realization =
        realize_siso(&sequence, period(), &EraOptions::with_order(Order::Fixed(6))).unwrap();
    assert_eq!(realization.order, 4);
    let a = realization.system.a();
    assert!((a * a * a * a).norm() < 1e-13);
    assert!((a * a * a).norm() > 0.1);
}

#[test]
fn too_short_a_sequence_shows_in_the_reason() {
    // Three states need a Hankel matrix of three rows: six parameters. Two states fit any four parameters, so that the
    // residual cannot tell.
    let poles = [(0.9, 0.0), (0.6, 0.7)];
    let realization =
        realize_siso(&planted(&poles, 4), period(), &EraOptions::with_order(Order::Fixed(3)))
            .unwrap();
    assert_eq!(realization.order, 2);
    assert_eq!(realization.reason, OrderReason::LimitedByData { requested: 3, available: 2 });
    assert!(realization.residual < 1e-13);
    assert!(pole_error(&realization, &poles) > 1e-2);
}

/// Three states, two inputs, two outputs; a repeated eigenvalue 0.5 with two eigenvectors, which one channel cannot show.
fn several_channels() -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
    let a = matrix(&[[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, -0.9]]);
    let b = matrix(&[[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    let c = matrix(&[[1.0, 2.0, 0.5], [0.0, 1.0, 1.0]]);
    (a, b, c)
}

fn parameters(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    c: &DMatrix<f64>,
    count: usize,
) -> Vec<DMatrix<f64>> {
    let mut state = b.clone();
    let mut sequence = vec![DMatrix::from_element(c.nrows(), b.ncols(), 7.0)];
    for _ in 0..count {
        sequence.push(c * &state);
        state = a * state;
    }
    sequence
}

#[test]
fn several_channels_show_a_repeated_eigenvalue() {
    let (a, b, c) = several_channels();
    let sequence = parameters(&a, &b, &c, 8);
    let realization = realize(&sequence, period(), &EraOptions::default()).unwrap();
    assert_eq!(realization.order, 3);
    assert!(pole_error(&realization, &[(0.5, 0.0), (-0.9, 0.0)]) < 1e-13);
    // What it says of samples that it has not seen.
    let system = &realization.system;
    let later = parameters(&a, &b, &c, 30);
    let ours = parameters(system.a(), system.b(), system.c(), 30);
    for (ours, expected) in ours.iter().zip(&later) {
        assert!((ours - expected).norm() < 1e-12);
    }
    assert_eq!(system.d(), &sequence[0]);

    let single: Vec<f64> = sequence.iter().map(|block| block[(0, 0)]).collect();
    assert_eq!(realize_siso(&single, period(), &EraOptions::default()).unwrap().order, 2);
}

#[test]
fn more_outputs_than_inputs_and_the_other_way_round() {
    let (a, b, c) = several_channels();
    for (b, c) in [(b.columns(0, 1).into_owned(), c.clone()), (b, c.rows(0, 1).into_owned())] {
        let realization =
            realize(&parameters(&a, &b, &c, 9), period(), &EraOptions::default()).unwrap();
        assert_eq!(realization.order, 2, "one channel sees one of the two equal eigenvalues");
        assert_eq!(
            (realization.system.inputs(), realization.system.outputs()),
            (b.ncols(), c.nrows())
        );
        assert!(realization.residual < 1e-14);
    }
}

#[test]
fn the_realization_is_balanced() {
    let sequence = planted(&[(0.9, 0.0), (0.6, 0.7)], 20);
    let realization =
        realize_siso(&sequence, period(), &EraOptions::with_order(Order::Fixed(3)).blocks(8, 10))
            .unwrap();
    let system = &realization.system;
    let (mut reach, mut observe) = (DMatrix::zeros(3, 3), DMatrix::zeros(3, 3));
    let (mut x, mut y) = (system.b().clone(), system.c().transpose());
    for k in 0..10 {
        reach += &x * x.transpose();
        if k < 8 {
            observe += &y * y.transpose();
        }
        x = system.a() * x;
        y = system.a().transpose() * y;
    }
    let expected =
        DMatrix::from_diagonal(&DVector::from_column_slice(&realization.singular_values[..3]));
    assert!((reach - &expected).norm() < 1e-12);
    assert!((observe - &expected).norm() < 1e-12);
    let condition = realization.singular_values[0] / realization.singular_values[2];
    assert!((realization.condition / condition - 1.0).abs() < 1e-14);
}

#[test]
fn bad_input_is_refused_with_numbers() {
    fn check(markov: &[f64], options: &EraOptions, expected: EraError) {
        assert_eq!(realize_siso(markov, period(), options).err(), Some(expected));
    }
    let default = EraOptions::default();
    check(&[], &default, EraError::NoFeedthrough);
    check(&[1.0], &default, EraError::TooFewMarkovParameters { found: 0, needed: 2 });
    check(&[1.0, 2.0], &default, EraError::TooFewMarkovParameters { found: 1, needed: 2 });
    check(&[1.0, 2.0, f64::NAN], &default, EraError::NotFinite { index: 2 });
    check(&[f64::INFINITY, 2.0, 3.0], &default, EraError::NotFinite { index: 0 });
    check(
        &[1.0; 5],
        &default.blocks(3, 2),
        EraError::TooFewMarkovParameters { found: 4, needed: 5 },
    );
    check(&[1.0; 5], &default.blocks(0, 2), EraError::EmptyHankel { rows: 0, columns: 2 });
    check(&[1.0; 5], &default.noise_floor(-1.0), EraError::InvalidNoiseFloor { value: -1.0 });
    let wide = EraOptions::with_order(Order::Tolerance(2.0));
    check(&[1.0; 5], &wide, EraError::InvalidTolerance { value: 2.0 });

    let odd = [matrix(&[[1.0, 2.0]]), matrix(&[[1.0, 2.0]]), matrix(&[[1.0], [2.0]])];
    let expected = EraError::ShapeMismatch {
        index: 2,
        rows: 2,
        columns: 1,
        expected_rows: 1,
        expected_columns: 2,
    };
    assert_eq!(realize(&odd, period(), &default).err(), Some(expected));
    let empty = [DMatrix::zeros(1, 0), DMatrix::zeros(1, 0), DMatrix::zeros(1, 0)];
    assert_eq!(
        realize(&empty, period(), &default).err(),
        Some(EraError::NoChannels { rows: 1, columns: 0 })
    );
}

proptest! {
    /// Distinct poles, also near and on the unit circle and outside, come back with the right count.
    #[test]
    fn distinct_poles_are_recovered(
        real in proptest::collection::btree_set(-10_i8..=10, 0..=2),
        modulus in prop_oneof![0.3..0.9, 0.99..1.01_f64],
        angle in 0.6..2.4_f64,
    ) {
        let mut poles: Vec<(f64, f64)> = real.into_iter().map(|tenths| (f64::from(tenths) / 10.0, 0.0)).collect();
        poles.retain(|&(re, _)| re != 0.0);
        poles.push((modulus * angle.cos(), modulus * angle.sin()));
        let order = poles.len() + 1;
        let sequence = planted(&poles, 24);
        let realization = realize_siso(&sequence, period(), &EraOptions::with_order(Order::Fixed(8))).unwrap();
        prop_assert_eq!(realization.order, order, "{:?} {:?}", poles, realization.singular_values);
        let error = pole_error(&realization, &poles);
        let allowed = 100.0 * f64::EPSILON * realization.condition;
        prop_assert!(error < allowed, "{error:e} {allowed:e}");
        prop_assert!(realization.residual < 1e-12);
    }
}
