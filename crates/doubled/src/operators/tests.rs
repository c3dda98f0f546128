//! Tests of `operators.rs` against exact rationals.

use super::*;
use crate::exact::{agrees, agrees_on_scale, any_scale, cancelling, exact, scaled};
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

/// u^3 in units of u^2 is below this.
const TINY: f64 = 1e-12;

fn dd(high: f64, low: f64) -> DoubleDouble {
    DoubleDouble::sum(high, low)
}

proptest! {
    #[test]
    fn sums_and_differences(a in any_scale(), b in any_scale()) {
        prop_assert!(agrees(a + b, &(exact(a) + exact(b)), 3.0 + TINY));
        prop_assert!(agrees(a - b, &(exact(a) - exact(b)), 3.0 + TINY));
        prop_assert_eq!(a + b, b + a);
    }

    #[test]
    fn sums_of_like_scales(a in scaled(-3..=3), b in scaled(-3..=3)) {
        prop_assert!(agrees(a + b, &(exact(a) + exact(b)), 3.0 + TINY));
        prop_assert!(agrees(a - b, &(exact(a) - exact(b)), 3.0 + TINY));
    }

    #[test]
    fn sums_that_cancel((a, b) in cancelling()) {
        prop_assert!(agrees(a + b, &(exact(a) + exact(b)), 3.0 + TINY));
        prop_assert!((a - a).is_zero());
    }

    #[test]
    fn products(a in any_scale(), b in any_scale()) {
        prop_assert!(agrees(a * b, &(exact(a) * exact(b)), 5.0));
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!(a * -b, -(a * b));
        prop_assert_eq!(a * DoubleDouble::ONE, a);
    }

    #[test]
    fn quotients(a in any_scale(), b in any_scale()) {
        prop_assert!(agrees(a / b, &(exact(a) / exact(b)), 15.0 + TINY));
        prop_assert_eq!(a / a, DoubleDouble::ONE);
        prop_assert_eq!(a / DoubleDouble::ONE, a);
        prop_assert_eq!(a / -b, -(a / b));
    }

    #[test]
    fn quotients_of_like_scales(a in scaled(-1..=1), b in scaled(-1..=1)) {
        prop_assert!(agrees(a / b, &(exact(a) / exact(b)), 15.0 + TINY));
    }

    #[test]
    fn sums_of_many(terms in proptest::collection::vec(scaled(-20..=20), 0..20)) {
        let sum: DoubleDouble = terms.iter().copied().sum();
        let expected: BigRational = terms.iter().map(|&x| exact(x)).sum();
        let moduli: BigRational = terms.iter().map(|&x| exact(x).abs()).sum();
        prop_assert!(agrees_on_scale(sum, &expected, 3.0 * 20.0, &moduli));
    }

    #[test]
    fn assignments_are_the_operators(a in any_scale(), b in any_scale()) {
        let mut x = a;
        x += b;
        prop_assert_eq!(x, a + b);
        x -= a;
        prop_assert_eq!(x, (a + b) - a);
        x = a;
        x *= b;
        prop_assert_eq!(x, a * b);
        x /= a;
        prop_assert_eq!(x, (a * b) / a);
    }
}

#[test]
fn exact_where_106_bits_are_enough() {
    let e = 2f64.powi(-50);
    // (1 + e)(1 - e) = 1 - e^2
    assert_eq!(dd(1.0, e) * dd(1.0, -e), dd(1.0, -e * e));
    // (1 + e^2)^2 - 1 = 2 e^2 + e^4, whose last term is lost: 2^-200 beside 1.
    assert_eq!(dd(1.0, e * e) * dd(1.0, e * e) - dd(1.0, 0.0), dd(2.0 * e * e, 0.0));
    assert_eq!(DoubleDouble::product(0.1, 10.0) - dd(1.0, 0.0), dd(2f64.powi(-54), 0.0));
    assert_eq!((dd(1e16, 1.0) - dd(1e16, 0.0)).value(), 1.0);
    assert_eq!(-dd(1.0, e), dd(-1.0, -e));
    // (1 - e^2) / (1 + e) = 1 - e
    assert_eq!(dd(1.0, -e * e) / dd(1.0, e), dd(1.0, -e));
}

#[test]
fn opposite_signs_cancel_accurately() {
    let (x, y) = (dd(1.0, 2f64.powi(-80)), dd(-1.0, 2f64.powi(-90)));
    assert_eq!((x + y).value(), 2f64.powi(-80) + 2f64.powi(-90));
    // High parts leave 2^-52, low parts -2^-52 + 3 2^-106, which is no double: the sloppy sum, which rounds it, is
    // wrong by a third.
    let x = dd(1.0 + 2f64.powi(-52), -(2f64.powi(-53) - 2f64.powi(-106)));
    let y = dd(-1.0, -(2f64.powi(-53) - 2f64.powi(-105)));
    assert_eq!((x + y).value(), 3.0 * 2f64.powi(-106));
}

#[test]
fn ring_constants() {
    assert!(DoubleDouble::zero().is_zero() && !DoubleDouble::one().is_zero());
    assert!(!dd(0.0, f64::from_bits(1)).is_zero());
    assert_eq!(DoubleDouble::one() * dd(3.0, 1e-20), dd(3.0, 1e-20));
    assert!(core::iter::empty::<DoubleDouble>().sum::<DoubleDouble>().is_zero());
    assert!((DoubleDouble::ZERO / dd(3.0, 1e-20)).is_zero());
}

#[test]
fn what_is_not_finite_stays_so() {
    let (large, one) = (DoubleDouble::from(1e300), DoubleDouble::ONE);
    for x in [
        large * large,
        one / DoubleDouble::ZERO,
        DoubleDouble::ZERO / DoubleDouble::ZERO,
        DoubleDouble::from(f64::INFINITY) + one,
        DoubleDouble::from(f64::INFINITY) * one,
        DoubleDouble::from(f64::NAN) - one,
    ] {
        assert!(!x.value().is_finite(), "{x:?}");
        assert!(!(x + one).value().is_finite(), "{x:?}");
    }
}
