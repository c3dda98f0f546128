//! Tests of `double_double.rs` against exact rationals.

use super::*;
use crate::exact::{agrees, any_scale, exact, is_normalised, rational, scaled};
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

proptest! {
    #[test]
    fn sums_of_doubles_are_exact(a in any_scale(), b in any_scale()) {
        let sum = DoubleDouble::sum(a.high(), b.high());
        prop_assert!(is_normalised(sum));
        prop_assert_eq!(exact(sum), rational(a.high()) + rational(b.high()));
    }

    #[test]
    fn products_of_doubles_are_exact(a in any_scale(), b in any_scale()) {
        let product = DoubleDouble::product(a.high(), b.high());
        prop_assert!(is_normalised(product));
        let expected = rational(a.high()) * rational(b.high());
        if product.high().abs() > 1e-290 {
            prop_assert_eq!(exact(product), expected);
        } else {
            prop_assert!(agrees(product, &expected, 0.0));
        }
    }

    #[test]
    fn square_roots(x in any_scale()) {
        let (x, root) = (x.abs(), x.abs().sqrt());
        prop_assert!(is_normalised(root));
        // s = sqrt(x) (1 + e) with |e| <= bound, without a root: |s^2 / x - 1| <= 2 bound + bound^2.
        let off = exact(root) * exact(root) / exact(x) - rational(1.0);
        let bound = rational(25.0 / 8.0 * 2f64.powi(-106));
        prop_assert!(off.abs() <= &bound + &bound + &bound * &bound);
    }

    #[test]
    fn roots_of_squares_are_exact(x in scaled(-480..=480)) {
        let x = x.high();
        prop_assert_eq!(DoubleDouble::product(x, x).sqrt(), DoubleDouble::from(x.abs()));
    }

    #[test]
    fn order_and_modulus_are_those_of_the_numbers(x in any_scale(), low in -1.0..1.0_f64) {
        // The same high part mostly, so that low parts have to decide.
        let y = DoubleDouble::sum(x.high(), low * x.high() * 2f64.powi(-53));
        prop_assert_eq!(x.partial_cmp(&y), Some(exact(x).cmp(&exact(y))));
        prop_assert_eq!(exact(x.abs()), exact(x).abs());
        prop_assert_eq!(x.abs(), (-x).abs());
    }
}

#[test]
fn a_float_is_itself() {
    let x = DoubleDouble::from(0.1);
    assert_eq!((x.high(), x.low(), x.value()), (0.1, 0.0, 0.1));
}

#[test]
fn the_root_of_two_to_thirty_digits() {
    // sqrt 2 = 1.41421356237309504880168872420969807856967...
    let digits: BigRational =
        "141421356237309504880168872420969807856967/100000000000000000000000000000000000000000"
            .parse()
            .unwrap();
    assert!(agrees(DoubleDouble::from(2.0).sqrt(), &digits, 3.125));
}

#[test]
fn roots_and_moduli_at_the_limits() {
    assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
    assert!(DoubleDouble::from(-1.0).sqrt().value().is_nan());
    assert!(DoubleDouble::from(f64::NAN).sqrt().value().is_nan());
    assert_eq!(DoubleDouble::from(f64::INFINITY).sqrt().value(), f64::INFINITY);
    assert_eq!(DoubleDouble::from(f64::NEG_INFINITY).abs().value(), f64::INFINITY);
}

#[test]
fn nan_compares_with_nothing() {
    let nan = DoubleDouble::from(f64::NAN);
    assert_eq!(nan.partial_cmp(&DoubleDouble::ONE), None);
    assert_ne!(nan, nan);
    assert_eq!(DoubleDouble::from(-0.0), DoubleDouble::ZERO);
}

#[test]
fn overflow_is_not_finite() {
    assert!(!DoubleDouble::sum(f64::MAX, f64::MAX).value().is_finite());
    assert!(!DoubleDouble::product(1e200, 1e200).value().is_finite());
}
