//! Tests of `time.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use core::f64::consts::PI;

use super::*;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

#[test]
fn periods() {
    for seconds in [0.1, f64::MIN_POSITIVE, 1e300] {
        assert_eq!(SamplePeriod::new(seconds).expect("positive").seconds(), seconds);
    }
    for seconds in [0.0, -0.1, f64::INFINITY, f64::NAN] {
        let error = SamplePeriod::new(seconds).expect_err("not a period");
        assert!(error.to_string().contains("positive finite"), "{error}");
    }
}

#[test]
fn logarithm_near_the_unit_circle_keeps_its_digits() {
    // 60-digit values of ln|z| for the exact doubles (mpmath).
    let cases = [
        (c(0.6, 0.8), 2.220_446_049_250_313_2e-17),
        (c(0.978_791_082_043_361_6, 0.167_177_771_232_968_56), -0.007_059_406_770_370_28),
        (c(0.999_999_999_999, 1e-7), -9.949_778_782_803_685e-13),
        (c(-0.28, 0.96), -2.664_535_259_100_375_6e-17),
    ];
    for (z, wanted) in cases {
        let got = log_modulus(z);
        assert!((got - wanted).abs() <= 1e-15 * wanted.abs(), "{z}: {got:e} {wanted:e}");
    }
}

#[test]
fn z_to_s_table() {
    let period = SamplePeriod::new(0.5).expect("positive");
    let check = |z, wanted: Complex<f64>| {
        let s = z_to_s(z, period).expect("a logarithm");
        assert!((s - wanted).norm() <= 1e-15 * (1.0 + wanted.norm()), "{z} -> {s}, not {wanted}");
    };
    check(c(1.0, 0.0), c(0.0, 0.0));
    check(c(0.0, 1.0), c(0.0, PI));
    check(c(0.0, -1.0), c(0.0, -PI));
    // The cut belongs to the upper side, for either sign of zero.
    check(c(-1.0, 0.0), c(0.0, 2.0 * PI));
    check(c(-1.0, -0.0), c(0.0, 2.0 * PI));
    check(c(1e-300, 0.0), c(2.0 * 1e-300_f64.ln(), 0.0));
    check(c(3e200, 4e200), c(2.0 * 5e200_f64.ln(), 2.0 * (4.0_f64 / 3.0).atan()));
    assert_eq!(z_to_s(c(0.0, -0.0), period), Err(LtiError::ZeroHasNoLogarithm));
    assert!(matches!(z_to_s(c(f64::NAN, 0.0), period), Err(LtiError::NotFiniteArgument { .. })));
}

#[test]
fn there_and_back() {
    let period = SamplePeriod::new(0.1).expect("positive");
    for s in [c(-0.5, 0.0), c(-0.07, 1.69), c(3.0, -20.0), c(-40.0, 31.0), c(0.0, 0.0)] {
        let back = z_to_s(s_to_z(s, period).expect("finite"), period).expect("not 0");
        assert!((back - s).norm() < 1e-13, "{s} {back}");
    }
    assert!(matches!(s_to_z(c(1e5, 0.0), period), Err(LtiError::Overflow { .. })));
    assert!(matches!(
        s_to_z(c(0.0, f64::INFINITY), period),
        Err(LtiError::NotFiniteArgument { .. })
    ));
    assert_eq!(s_to_z(c(-1e6, 0.0), period).expect("underflows to 0"), c(0.0, 0.0));
}
