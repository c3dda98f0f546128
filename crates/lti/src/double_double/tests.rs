//! Tests of `double_double.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use super::*;

fn dd(high: f64, low: f64) -> DoubleDouble {
    DoubleDouble::from(high) + DoubleDouble::from(low)
}

#[test]
fn exact_where_106_bits_are_enough() {
    let e = 2.0_f64.powi(-50);
    // (1 + e)(1 - e) = 1 - e^2
    assert_eq!(dd(1.0, e) * dd(1.0, -e), dd(1.0, -e * e));
    // (1 + e^2)^2 - 1 = 2 e^2 + e^4, whose last term is lost: 2^-200 beside 1.
    assert_eq!(dd(1.0, e * e) * dd(1.0, e * e) - dd(1.0, 0.0), dd(2.0 * e * e, 0.0));
    assert_eq!(DoubleDouble::product(0.1, 10.0) - dd(1.0, 0.0), dd(2.0_f64.powi(-54), 0.0));
    assert_eq!((dd(1e16, 1.0) - dd(1e16, 0.0)).value(), 1.0);
    assert_eq!(-dd(1.0, e), dd(-1.0, -e));
}

#[test]
fn opposite_signs_cancel_accurately() {
    let third = dd(1.0 / 3.0, 1.0 / 3.0 * 2.0_f64.powi(-54));
    let difference = third + -third;
    assert!(difference.is_zero());
    let (x, y) = (dd(1.0, 2.0_f64.powi(-80)), dd(-1.0, 2.0_f64.powi(-90)));
    assert_eq!((x + y).value(), 2.0_f64.powi(-80) + 2.0_f64.powi(-90));
}

#[test]
fn ring_constants() {
    assert!(DoubleDouble::zero().is_zero() && !DoubleDouble::one().is_zero());
    assert_eq!(DoubleDouble::one() * dd(3.0, 1e-20), dd(3.0, 1e-20));
}
