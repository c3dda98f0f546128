//! Tests of rational functions over exact rings.

use super::Rational;
use crate::{Complex, Poly, PolyError};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

type Q = BigRational;

fn q(n: i64) -> Q {
    Q::from(BigInt::from(n))
}

fn poly(ascending: &[i64]) -> Poly<Q> {
    Poly::new(ascending.iter().map(|&c| q(c)).collect())
}

fn any() -> impl Strategy<Value = Rational<Q>> {
    let list = || proptest::collection::vec(-9..9_i64, 0..4);
    (list(), list(), 1..9_i64).prop_map(|(n, d, c)| {
        let denominator = poly(&d);
        let safe = if denominator.is_zero() { poly(&[c]) } else { denominator };
        Rational::new(poly(&n), safe).unwrap()
    })
}

#[test]
fn zero_denominators_are_errors() {
    assert_eq!(Rational::new(poly(&[1]), poly(&[])), Err(PolyError::ZeroDenominator));
    let zero = Rational::from_poly(poly(&[]));
    let one = Rational::from_poly(poly(&[1]));
    assert_eq!(zero.recip(), Err(PolyError::DivisionByZero));
    assert_eq!(one.checked_div(&zero), Err(PolyError::DivisionByZero));
    // Underflow of the whole denominator.
    let tiny = Rational::new(Poly::constant(1.0), Poly::constant(1e-200)).unwrap();
    assert_eq!(tiny.checked_mul(&tiny), Err(PolyError::ZeroDenominator));
    // A map that sends the denominator to zero.
    assert_eq!(one.map(|_| 0_i64), Err(PolyError::ZeroDenominator));
}

#[test]
fn common_denominators_are_kept() {
    let part = |n: i64| Rational::new(poly(&[n]), poly(&[2, 1])).unwrap();
    let sum = part(3) + part(4);
    assert_eq!((sum.numerator(), sum.denominator()), (&poly(&[7]), &poly(&[2, 1])));
}

#[test]
fn values() {
    let r = Rational::new(poly(&[-1, 0, 1]), poly(&[1, 1])).unwrap();
    assert_eq!(r.eval(&q(3)), Some(q(2)));
    assert_eq!(r.eval(&q(-1)), None);
    assert_eq!(r.relative_degree(), Some(-1));
    assert_eq!(r.reduced().numerator(), &poly(&[-1, 1]));
    assert_eq!(Rational::from_poly(poly(&[])).relative_degree(), None);
    let f = Rational::new(Poly::new(vec![1.0]), Poly::new(vec![1.0, 1.0])).unwrap();
    assert_eq!(f.eval_complex(Complex::new(0.0, 1.0)), Complex::new(0.5, -0.5));
}

proptest! {
    #[test]
    fn field_laws(a in any(), b in any(), c in any()) {
        prop_assert!((&a * &(&b + &c)).equivalent(&(&(&a * &b) + &(&a * &c))));
        prop_assert!((&(&a - &b) + &b).equivalent(&a));
        if !b.is_zero() {
            prop_assert!((&(&a / &b) * &b).equivalent(&a));
        }
        prop_assert!((-&a + a.clone()).is_zero());
        let reduced = a.reduced();
        prop_assert!(reduced.equivalent(&a));
        prop_assert_eq!(reduced.numerator().gcd(reduced.denominator()).degree(), Some(0));
    }

    #[test]
    fn arithmetic_is_pointwise(a in any(), b in any(), x in -20..20_i64) {
        let x = q(x);
        if let (Some(u), Some(v)) = (a.eval(&x), b.eval(&x)) {
            prop_assert_eq!((&a + &b).eval(&x), Some(&u + &v));
            prop_assert_eq!((&a - &b).eval(&x), Some(&u - &v));
            prop_assert_eq!((&a * &b).eval(&x), Some(u * v));
        }
    }
}
