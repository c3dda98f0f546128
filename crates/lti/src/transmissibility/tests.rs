//! Tests of `transmissibility.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::dmatrix;

use super::*;
use crate::Continuous;

fn system(b: DMatrix<f64>, c: DMatrix<f64>) -> StateSpace<Continuous> {
    let d = DMatrix::zeros(c.nrows(), b.ncols());
    StateSpace::<Continuous>::new(dmatrix![0.0, 1.0; -2.0, -3.0], b, c, d).expect("a system")
}

const CHANNELS: Channels = Channels { excitation: 0, from_output: 0, to_output: 1 };

#[test]
fn example_4_1_of_the_paper() {
    let a = dmatrix![1, 1, 1; 0, 2, -1; 0, 1, 1];
    let (from, to) = ((&[1, 2, -1][..], &0), (&[-1, 3, -2][..], &0));
    let t = Transmissibility::new(&a, &[0, 1, 0], from, to).expect("a transmissibility");
    assert_eq!(t.numerator(), &Poly::from_descending(&[3, -9, 5]));
    assert_eq!(t.denominator(), &Poly::from_descending(&[2, -4, 3]));
    assert_eq!(t.to_rational().numerator(), t.numerator());
    let second = Transmissibility::new(&a, &[0, 1, -1], from, to).expect("a transmissibility");
    assert_eq!(second.numerator(), &Poly::from_descending(&[5, -11, 3]));
    assert_eq!(second.denominator(), &Poly::from_descending(&[3, -6, 6]));
}

#[test]
fn an_output_that_does_not_respond_is_refused() {
    // Exactly zero.
    let silent = system(dmatrix![0.0; 1.0], dmatrix![0.0, 0.0; 1.0, 0.0]);
    let error = Transmissibility::between(&silent, CHANNELS).expect_err("y_i is 0");
    assert!(matches!(error, LtiError::ZeroDenominator { largest: 0.0, .. }), "{error}");
    // Zero within rounding: b is an eigenvector up to 1e-17, c its annihilator.
    let b = dmatrix![0.1 + 0.2; -0.3];
    let nearly = system(b.clone(), dmatrix![1.0, 1.0; 1.0, 0.0]);
    assert!(matches!(
        Transmissibility::between(&nearly, CHANNELS),
        Err(LtiError::ZeroDenominator { .. })
    ));
    // A response a million times the rounding is one.
    let small = system(b + dmatrix![1e-9; 0.0], dmatrix![1.0, 1.0; 1.0, 0.0]);
    assert!(Transmissibility::between(&small, CHANNELS).is_ok());
    // Over the integers.
    let result =
        Transmissibility::new(&dmatrix![1, 0; 0, 2], &[1, 0], (&[0, 1], &0), (&[1, 0], &0));
    assert!(matches!(result, Err(LtiError::ZeroDenominator { .. })));
    assert!(Transmissibility::from_polynomials(Poly::<i64>::one(), Poly::zero()).is_err());
}

#[test]
fn zeros_and_poles_are_those_of_the_polynomials() {
    let t = Transmissibility::between(
        &system(dmatrix![0.0; 1.0], dmatrix![5.0, 1.0; 4.0, 2.0]),
        CHANNELS,
    )
    .expect("a transmissibility");
    assert_eq!(t.zeros().expect("roots").values()[0].re, -2.0);
    assert_eq!(t.poles().expect("roots").values()[0].re, -5.0);
    let zero = Transmissibility::between(
        &system(dmatrix![0.0; 1.0], dmatrix![5.0, 1.0; 0.0, 0.0]),
        CHANNELS,
    )
    .expect("a transmissibility that is 0");
    assert!(zero.numerator().is_zero());
    let error = zero.zeros().expect_err("everything is a zero");
    assert!(error.to_string().starts_with("the zeros of a transmissibility: "), "{error}");
}

#[test]
fn relation_residual_counts_samples() {
    let t = Transmissibility::from_polynomials(Poly::new(vec![0.0, 1.0]), Poly::new(vec![1.0]))
        .expect("q");
    // y_o(k) = y_i(k + 1)
    assert_eq!(t.relation_residual(&[1.0, 2.0, 4.0, 8.0], &[2.0, 4.0, 9.0, 0.0]), [0.0, 0.0, 1.0]);
    assert_eq!(t.relation_residual(&[1.0], &[2.0]), [0.0; 0]);
    assert_eq!(t.relation_residual(&[], &[2.0]), [0.0; 0]);
}

#[test]
fn bad_channels() {
    let s = system(dmatrix![0.0; 1.0], dmatrix![5.0, 1.0; 4.0, 2.0]);
    for channels in [
        Channels { excitation: 1, ..CHANNELS },
        Channels { from_output: 2, ..CHANNELS },
        Channels { to_output: 2, ..CHANNELS },
    ] {
        assert!(matches!(
            Transmissibility::between(&s, channels),
            Err(LtiError::NoSuchChannel { .. })
        ));
    }
    let result = Transmissibility::new(&dmatrix![1, 0; 0, 2], &[1], (&[0, 1], &0), (&[1, 0], &0));
    assert!(matches!(result, Err(LtiError::Shape { .. })));
}
