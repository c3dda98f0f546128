use nalgebra::DMatrix;

use super::expand;
use crate::fixtures::matrix;

/// A companion matrix of `x^2 - trace x + determinant`, with `C B` and `C A B` as given.
fn second_order(
    trace: f64,
    determinant: f64,
    first: f64,
    second: f64,
) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
    (
        matrix(&[[0.0, 1.0], [-determinant, trace]]),
        matrix(&[[first], [second]]),
        matrix(&[[1.0, 0.0]]),
    )
}

fn series(numerator: &[f64], denominator: &[f64], count: usize) -> Vec<f64> {
    let mut out: Vec<f64> = Vec::new();
    for k in 0..count {
        let mut value = numerator.get(k).copied().unwrap_or(0.0);
        for j in 1..denominator.len().min(k + 1) {
            value -= denominator[j] * out[k - j];
        }
        out.push(value);
    }
    out
}

#[test]
fn a_plain_system_is_expanded_and_nothing_dropped() {
    // (2 x + 1) / (x^2 - 0.5 x - 0.06) + 3, so that h_1 = 2 and h_2 = 1 + 2 * 0.5 = 2.
    let (a, b, c) = second_order(0.5, -0.06, 2.0, 2.0);
    let markov = series(&[3.0, 2.0 - 1.5, 1.0 - 0.18], &[1.0, -0.5, -0.06], 12);
    let half = expand(&a, &b, &c, &markov, 1e-15).unwrap();
    for (ours, expected) in half.numerator.iter().zip([3.0, 0.5, 0.82]) {
        assert!((ours - expected).abs() < 1e-14);
    }
    for (ours, expected) in half.denominator.iter().zip([1.0, -0.5, -0.06]) {
        assert!((ours - expected).abs() < 1e-14);
    }
    assert_eq!((half.dropped.denominator, half.dropped.numerator), (0, 0));
    assert!(half.dropped.deviation < 1e-14);
}

#[test]
fn a_small_coefficient_that_the_data_need_stays() {
    // The poles are 0.5 and 1e-5: the product 5e-6 moves h_2 by 5e-6, far above the uncertainty of 1e-12.
    let denominator = [1.0, -0.5 - 1e-5, 0.5e-5];
    let (a, b, c) = second_order(0.5 + 1e-5, 0.5e-5, 1.0, 1.0);
    let markov = series(&[0.0, 1.0, 1.0 + denominator[1]], &denominator, 12);
    let half = expand(&a, &b, &c, &markov, 1e-12).unwrap();
    assert_eq!(half.denominator.len(), 3);
    assert!((half.denominator[2] - 0.5e-5).abs() < 1e-18);

    // With an uncertainty of 1e-4 they cannot tell it from zero.
    let coarse = expand(&a, &b, &c, &markov, 1e-4).unwrap();
    assert_eq!((coarse.denominator.len(), coarse.dropped.denominator), (2, 1));
    assert!((coarse.dropped.largest_denominator - 0.5e-5).abs() < 1e-18);
    assert!(coarse.dropped.deviation > 1e-7 && coarse.dropped.deviation <= coarse.dropped.allowed);
    assert_eq!(coarse.dropped.allowed, 1e-4);
}

#[test]
fn a_perturbed_nilpotent_matrix_gives_a_polynomial() {
    // Eigenvalues of size 1e-8, coefficients of size 1e-16.
    let a = matrix(&[[1e-16, 1.0], [1e-16, -2e-16]]);
    let (b, c) = (matrix(&[[3.0], [5.0]]), matrix(&[[1.0, 0.0]]));
    let half = expand(&a, &b, &c, &[0.0, 3.0, 5.0, 0.0, 0.0, 0.0], 1e-15).unwrap();
    assert_eq!(half.denominator, [1.0]);
    assert_eq!(half.dropped.denominator, 2);
    assert!(half.dropped.largest_denominator > 0.0 && half.dropped.largest_denominator < 1e-15);
    assert_eq!(half.numerator.len(), 3);
    assert!((half.numerator[1] - 3.0).abs() < 1e-14 && (half.numerator[2] - 5.0).abs() < 1e-14);
}

#[test]
fn a_numerator_loses_both_vanishing_ends() {
    // x / (x^2 - 0.5 x + 0.06), written with rubbish of 1e-17 at both ends: h_1 = 1, h_2 = 0.5.
    let denominator = [1.0, -0.5, 0.06];
    let (a, b, c) = second_order(0.5, 0.06, 1.0, 0.5 + 1e-17);
    let mut markov = series(&[0.0, 1.0], &denominator, 10);
    markov[0] = 1e-17;
    let half = expand(&a, &b, &c, &markov, 1e-15).unwrap();
    assert_eq!(half.numerator, [0.0, 1.0]);
    assert_eq!(half.dropped.largest_numerator, 1e-17);
}

#[test]
fn no_state_is_a_gain_and_overflow_is_survived() {
    let (a, b, c) = (DMatrix::zeros(0, 0), DMatrix::zeros(0, 1), DMatrix::zeros(1, 0));
    let gain = expand(&a, &b, &c, &[2.0, 0.0, 0.0], 0.0).unwrap();
    assert_eq!((gain.numerator, gain.denominator), (vec![2.0], vec![1.0]));

    let huge = expand(
        &matrix(&[[1e200]]),
        &matrix(&[[1.0]]),
        &matrix(&[[1.0]]),
        &[0.0, 1.0, 1.0, 1.0, 1.0],
        1e-9,
    )
    .unwrap();
    assert_eq!(huge.dropped.deviation_before, f64::INFINITY);
}
