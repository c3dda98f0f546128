//! Tests of `invariant_zeros.rs`.

use nalgebra::{DMatrix, dmatrix};

use super::*;
use crate::Continuous;

fn system(
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    d: DMatrix<f64>,
) -> StateSpace<Continuous> {
    StateSpace::<Continuous>::new(a, b, c, d).expect("a system")
}

fn check(
    system: &StateSpace<Continuous>,
    normal_rank: usize,
    wanted: &[(f64, f64)],
) -> InvariantZeros {
    let found = system.invariant_zeros().expect("zeros");
    assert_eq!(found.normal_rank, normal_rank);
    assert_eq!(found.zeros.len(), wanted.len(), "{:?}", found.values());
    for (zero, &(re, im)) in found.zeros.iter().zip(wanted) {
        let error = (zero.value - Complex::new(re, im)).norm();
        assert!(error < 1e-14 * (1.0 + re.hypot(im)), "{:?} is not {wanted:?}", found.values());
    }
    found
}

#[test]
fn one_channel() {
    let companion = || dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; -6.0, -11.0, -6.0];
    let b = || dmatrix![0.0; 0.0; 1.0];
    check(&system(companion(), b(), dmatrix![1.0, 0.0, 0.0], dmatrix![0.0]), 1, &[]);
    check(&system(companion(), b(), dmatrix![4.0, 1.0, 0.0], dmatrix![0.0]), 1, &[(-4.0, 0.0)]);
    check(
        &system(companion(), b(), dmatrix![5.0, 2.0, 1.0], dmatrix![0.0]),
        1,
        &[(-1.0, 2.0), (-1.0, -2.0)],
    );
    // A feedthrough of 1: as many zeros as states. s^3 + 6 s^2 + 11 s + 6 - 6 s^2 - 11 s + 2 = s^3 + 8.
    let root = 3.0_f64.sqrt();
    let full = system(companion(), b(), dmatrix![2.0, -11.0, -6.0], dmatrix![1.0]);
    check(&full, 1, &[(-2.0, 0.0), (1.0, root), (1.0, -root)]);
}

#[test]
fn transmission_zeros_of_a_square_system() {
    // Rosenbrock's example: no element has a zero, the matrix has one at +1.
    // G = 1/((s+1)(s+2)) [ (s+2)... ] realised as [1/(s+1), 2/(s+3); 1/(s+1), 1/(s+1)]:
    // det = (1/(s+1)) (1/(s+1) - 2/(s+3)) = (1 - s) / ((s+1)^2 (s+3)).
    let a = DMatrix::from_diagonal(&nalgebra::dvector![-1.0, -1.0, -3.0]);
    let b = dmatrix![1.0, 0.0; 0.0, 1.0; 0.0, 2.0];
    let c = dmatrix![1.0, 0.0, 1.0; 1.0, 1.0, 0.0];
    let found = check(&system(a, b, c, DMatrix::zeros(2, 2)), 2, &[(1.0, 0.0)]);
    assert!(found.zeros[0].residual < 1e-15 && found.zeros[0].condition < 100.0);
}

#[test]
fn modes_that_are_not_reached_or_not_seen() {
    let a = DMatrix::from_diagonal(&nalgebra::dvector![-1.0, -2.0, -3.0]);
    // -2 isn't reached, -3 isn't seen; 1/(s+1) itself has no zero.
    let b = dmatrix![1.0; 0.0; 1.0];
    let c = dmatrix![1.0, 1.0, 0.0];
    check(&system(a.clone(), b, c, dmatrix![0.0]), 1, &[(-3.0, 0.0), (-2.0, 0.0)]);
    // No input or no output at all: every mode.
    let all = [(-3.0, 0.0), (-2.0, 0.0), (-1.0, 0.0)];
    // An input that reaches nothing: G = 0 and [A - xI; C] keeps its rank, so there are none.
    check(&system(a.clone(), DMatrix::zeros(3, 1), dmatrix![1.0, 1.0, 1.0], dmatrix![0.0]), 0, &[]);
    // With a feedthrough G has full rank again, and every mode is out of reach.
    check(
        &system(a.clone(), DMatrix::zeros(3, 0), DMatrix::zeros(0, 3), DMatrix::zeros(0, 0)),
        0,
        &all,
    );
    check(&system(a, DMatrix::zeros(3, 1), dmatrix![1.0, 1.0, 1.0], dmatrix![2.0]), 1, &all);
}

#[test]
fn rectangular_systems() {
    let a = DMatrix::from_diagonal(&nalgebra::dvector![-1.0, -2.0]);
    // Two outputs (s+3)/((s+1)(s+2)) and twice that: the common zero stays.
    let b = dmatrix![2.0; -1.0];
    let tall = system(a.clone(), b.clone(), dmatrix![1.0, 1.0; 2.0, 2.0], DMatrix::zeros(2, 1));
    check(&tall, 1, &[(-3.0, 0.0)]);
    // Outputs without a common zero.
    check(&system(a.clone(), b, dmatrix![1.0, 1.0; 1.0, 0.0], DMatrix::zeros(2, 1)), 1, &[]);
    // Its dual.
    let wide = system(a, dmatrix![1.0, 2.0; 1.0, 2.0], dmatrix![2.0, -1.0], DMatrix::zeros(1, 2));
    check(&wide, 1, &[(-3.0, 0.0)]);
}

#[test]
fn degenerate_systems() {
    // Two equal outputs and two equal inputs: the 2 x 2 transfer function has rank 1, and the zero is still there.
    let a = DMatrix::from_diagonal(&nalgebra::dvector![-1.0, -2.0]);
    let b = dmatrix![2.0, 2.0; -1.0, -1.0];
    check(&system(a, b, dmatrix![1.0, 1.0; 1.0, 1.0], DMatrix::zeros(2, 2)), 1, &[(-3.0, 0.0)]);
    check(
        &system(
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 2),
            DMatrix::zeros(2, 0),
            DMatrix::identity(2, 2),
        ),
        2,
        &[],
    );
    check(
        &system(
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 0),
        ),
        0,
        &[],
    );
    check(
        &system(
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 2),
            DMatrix::zeros(2, 0),
            DMatrix::zeros(2, 2),
        ),
        0,
        &[],
    );
    check(
        &system(DMatrix::zeros(2, 2), DMatrix::zeros(2, 1), DMatrix::zeros(1, 2), dmatrix![0.0]),
        0,
        &[(0.0, 0.0); 2],
    );
}

#[test]
fn scales_of_time_states_inputs_and_outputs() {
    let a = dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; -6.0, -11.0, -6.0];
    let (b, c, d) = (dmatrix![0.0; 0.0; 1.0], dmatrix![2.0, -11.0, -6.0], dmatrix![1.0]);
    for (time, states, inputs, outputs) in [
        (1e100, 1.0, 1.0, 1.0),
        (1e-100, 1.0, 1.0, 1.0),
        (1.0, 1e30, 1.0, 1.0),
        (1.0, 1.0, 1e120, 1e-150),
        (1e8, 1e-9, 1e7, 1e6),
    ] {
        let scale = [1.0, states, states * states];
        let scaled = system(
            DMatrix::from_fn(3, 3, |i, j| a[(i, j)] * time * scale[j] / scale[i]),
            DMatrix::from_fn(3, 1, |i, _| b[i] * time * inputs / scale[i]),
            DMatrix::from_fn(1, 3, |_, j| c[j] * outputs * scale[j]),
            &d * (inputs * outputs),
        );
        let root = 3.0_f64.sqrt() * time;
        check(&scaled, 1, &[(-2.0 * time, 0.0), (time, root), (time, -root)]);
    }
}

#[test]
fn a_repeated_zero_says_so() {
    // (s + 1)^2 / (s + 2)^3: the zeros split by the root of the rounding, with a condition to match.
    let a = dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; -8.0, -12.0, -6.0];
    let found = system(a, dmatrix![0.0; 0.0; 1.0], dmatrix![1.0, 2.0, 1.0], dmatrix![0.0])
        .invariant_zeros()
        .expect("zeros");
    assert_eq!(found.zeros.len(), 2);
    for zero in &found.zeros {
        assert!((zero.value + 1.0).norm() < 1e-6 && zero.condition > 1e6, "{zero:?}");
    }
}

#[test]
fn a_noisy_system_needs_a_tolerance() {
    let (a, b) = (dmatrix![0.0, 1.0; -2.0, -3.0], dmatrix![1e-9; 1.0]);
    let noisy = system(a, b, dmatrix![1.0, 0.0], dmatrix![0.0]);
    assert_eq!(noisy.invariant_zeros().expect("zeros").zeros.len(), 1);
    let options = ZerosOptions { rank_tolerance: Some(1e-6) };
    assert_eq!(noisy.invariant_zeros_with(&options).expect("zeros").zeros.len(), 0);
    let options = ZerosOptions { rank_tolerance: Some(f64::NAN) };
    assert!(matches!(
        noisy.invariant_zeros_with(&options),
        Err(LtiError::NotFiniteArgument { .. })
    ));
}
