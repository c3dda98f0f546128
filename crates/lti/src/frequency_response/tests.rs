//! Tests of `frequency_response.rs`.

use core::f64::consts::PI;

use nalgebra::dmatrix;

use super::*;
use crate::{Continuous, Discrete, SamplePeriod};

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

#[test]
fn a_resonance() {
    // 1/(s^2 + 2 zeta w s + w^2) at w is 1/(2 j zeta w^2).
    for (w, zeta) in [(1.0, 0.5), (1e3, 1e-6), (1e-4, 0.1)] {
        let system = StateSpace::<Continuous>::new(
            dmatrix![0.0, 1.0; -w * w, -2.0 * zeta * w],
            dmatrix![0.0; 1.0],
            dmatrix![1.0, 0.0],
            dmatrix![0.0],
        )
        .expect("a system");
        let g = system.frequency_response(&[w, -w]).expect("no pole");
        let wanted = c(0.0, -1.0 / (2.0 * zeta * w * w));
        // The rounding of w^2 detunes the resonance by 1e-16 / zeta.
        assert!(
            (g[0][0] - wanted).norm() / wanted.norm() < 1e-15 + 2e-16 / zeta,
            "{} {wanted}",
            g[0][0]
        );
        assert_eq!(g[1][0], g[0][0].conj());
    }
}

#[test]
fn discrete_time() {
    // y(k) = u(k-1): z^-1, and at half the sample rate -1.
    let delay = StateSpace::<Discrete>::new(
        dmatrix![0.0],
        dmatrix![1.0],
        dmatrix![1.0],
        dmatrix![0.0],
        SamplePeriod::new(0.25).expect("positive"),
    )
    .expect("a system");
    let g = delay.frequency_response(&[0.0, 2.0 * PI, 4.0 * PI]).expect("no pole");
    for (g, wanted) in g.iter().zip([c(1.0, 0.0), c(0.0, -1.0), c(-1.0, 0.0)]) {
        assert!((g[0] - wanted).norm() < 1e-15);
    }
    assert_eq!(delay.evaluate(c(2.0, 0.0)).expect("no pole")[0], c(0.5, 0.0));
}

#[test]
fn next_to_a_zero() {
    // (s + 1) / (s + 2)(s + 3)(s + 5) through a full matrix; 1e-9 from the zero the value is 1e-9 / 8.
    let system = StateSpace::<Continuous>::new(
        dmatrix![-10.0, -31.0, -30.0; 1.0, 0.0, 0.0; 0.0, 1.0, 0.0],
        dmatrix![1.0; 0.0; 0.0],
        dmatrix![0.0, 1.0, 1.0],
        dmatrix![0.0],
    )
    .expect("a system");
    let x = -1.0 + 1e-9;
    let wanted = (x + 1.0) / ((x + 2.0) * (x + 3.0) * (x + 5.0));
    let got = system.evaluate(c(x, 0.0)).expect("no pole")[0];
    assert!((got.re - wanted).abs() < 1e-15 * wanted && got.im == 0.0, "{got} {wanted}");
}

#[test]
fn poles_and_bad_arguments() {
    let integrator =
        StateSpace::<Continuous>::new(dmatrix![0.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])
            .expect("a system");
    let error = integrator.frequency_response(&[1.0, 0.0]).expect_err("a pole at 0");
    assert_eq!(error, LtiError::PoleAtFrequency { frequency_rad_s: 0.0 });
    assert!(matches!(integrator.evaluate(c(0.0, 0.0)), Err(LtiError::PoleAtPoint { .. })));
    assert!(matches!(
        integrator.evaluate(c(f64::NAN, 0.0)),
        Err(LtiError::NotFiniteArgument { .. })
    ));
    assert!(matches!(
        integrator.frequency_response(&[f64::INFINITY]),
        Err(LtiError::NotFiniteArgument { .. })
    ));
    assert!(integrator.frequency_response(&[]).expect("nothing asked").is_empty());
}

#[test]
fn empty_parts() {
    let gain = StateSpace::<Continuous>::new(
        DMatrix::zeros(0, 0),
        DMatrix::zeros(0, 2),
        DMatrix::zeros(1, 0),
        dmatrix![1.0, 2.0],
    )
    .expect("a system");
    assert_eq!(gain.evaluate(c(0.0, 0.0)).expect("no pole")[1], c(2.0, 0.0));
    let blind = StateSpace::<Continuous>::new(
        DMatrix::identity(3, 3),
        DMatrix::zeros(3, 0),
        DMatrix::zeros(2, 3),
        DMatrix::zeros(2, 0),
    )
    .expect("a system");
    assert_eq!(blind.frequency_response(&[1.0]).expect("no pole")[0].shape(), (2, 0));
}
