//! Tests of polynomial arithmetic, exact wherever the ring is exact.

use crate::{Complex, Poly, PolyError};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

type Big = Poly<BigInt>;

fn big(ascending: &[i64]) -> Big {
    Poly::new(ascending.iter().map(|&c| BigInt::from(c)).collect())
}

fn rational(ascending: &[i64]) -> Poly<BigRational> {
    big(ascending).map(|c| BigRational::from(c.clone()))
}

fn any() -> impl Strategy<Value = Vec<i64>> {
    proptest::collection::vec(-20..20_i64, 0..7)
}

#[test]
fn leading_zeros_are_trimmed() {
    let p = Poly::new(vec![1, 2, 0, 0]);
    assert_eq!((p.degree(), p.leading(), p.coefficients()), (Some(1), Some(&2), &[1, 2][..]));
    let zero = &p - &p;
    assert!(zero.is_zero() && zero.degree().is_none() && zero.leading().is_none());
    assert_eq!(zero.descending(), Vec::<i32>::new());
    assert_eq!(Poly::<i32>::new(vec![0, 0]), Poly::zero());
    assert_eq!(Poly::monomial(0, 5), Poly::zero());
    assert_eq!(p.coefficient(1) + p.coefficient(7), 2);
}

#[test]
fn small_products() {
    let x = Poly::<i64>::indeterminate();
    let p = &x * &x - Poly::constant(1);
    assert_eq!(p, Poly::from_roots(&[1, -1]));
    assert_eq!(p.pow(3).descending(), [1, 0, -3, 0, 3, 0, -1]);
    assert_eq!(p.pow(0), Poly::one());
    assert_eq!(p.derivative().descending(), [2, 0]);
    assert_eq!(p.shift(2).descending(), [1, 0, -1, 0, 0]);
    assert_eq!(Poly::from_descending(&[1, 2, 3, 0]).reversed().descending(), [3, 2, 1]);
    assert_eq!(-Poly::new(vec![1, -2]), Poly::new(vec![-1, 2]));
    let mut sum = x.clone();
    sum += Poly::one();
    sum *= &x;
    sum -= &x;
    assert_eq!(sum, &x * &x);
    assert_eq!([x.clone(), x.clone()].into_iter().sum::<Poly<i64>>(), x.scale(&2));
    assert_eq!([x.clone(), x.clone()].into_iter().product::<Poly<i64>>(), x.pow(2));
}

#[test]
fn a_polynomial_is_a_ring_element() {
    fn square<T: crate::Ring>(x: T) -> T {
        x.clone() * x + T::one()
    }
    assert_eq!(square(Poly::new(vec![0, 1])), Poly::new(vec![1, 0, 1]));
    // Two variables: (x + y)^2 with y the inner variable.
    let y = Poly::new(vec![0, 1]);
    let sum = Poly::new(vec![y.clone(), Poly::one()]);
    assert_eq!(sum.pow(2).coefficients(), [y.pow(2), y.scale(&2), Poly::one()]);
}

#[test]
fn division_by_zero_is_an_error() {
    let p = Poly::new(vec![1.0, 2.0]);
    assert_eq!(p.div_rem(&Poly::zero()), Err(PolyError::DivisionByZero));
    assert_eq!(p.pseudo_div_rem(&Poly::zero()), Err(PolyError::DivisionByZero));
    assert_eq!(p.exact_div(&Poly::zero()), Err(PolyError::DivisionByZero));
    let error = rational(&[1, 0, 1]).exact_div(&rational(&[1, 1]));
    assert_eq!(error, Err(PolyError::InexactDivision { degree: 0 }));
    assert_eq!(Poly::<f64>::zero().div_rem(&p), Ok((Poly::zero(), Poly::zero())));
    assert_eq!(Poly::<f64>::zero().monic(), Poly::zero());
    assert_eq!(rational(&[]).gcd(&rational(&[])), rational(&[]));
    assert_eq!(rational(&[]).gcd(&rational(&[2, 2])), rational(&[1, 1]));
}

#[test]
fn text() {
    fn check(p: &Poly<i32>, expected: &str) {
        assert_eq!(p.display("x").to_string(), expected);
    }
    check(&Poly::zero(), "0");
    check(&Poly::constant(-3), "-3");
    check(&Poly::constant(1), "1");
    check(&Poly::from_descending(&[-1, 1, 0, -5]), "-x^3 + x^2 - 5");
    let p =
        Poly::new(vec![Complex::new(1.0, -2.0), Complex::new(0.0, 0.0), Complex::new(0.5, 1.0)]);
    assert_eq!(p.display("z").to_string(), "(0.5+1i)z^2 + (1-2i)");
    let p = Poly::new(vec![1e-7, -2.5e-300]);
    assert_eq!(format!("{:.1}", p.display("q")), "-0.0q + 0.0");
    let half =
        Poly::new(vec![BigRational::new(BigInt::from(-1), BigInt::from(2)), BigRational::one()]);
    assert_eq!(half.display("p").to_string(), "p + (-1/2)");
}

#[test]
fn evaluation_bounds_hold() {
    // (x - 1)^12 near 1 against the exact value over the rationals.
    let p = Poly::from_roots(&[1.0; 12]);
    let exact = p.map(|&c| BigRational::from_float(c).unwrap());
    for k in 0..200 {
        let x = 1.0 + f64::from(k - 100) * 1.3e-3;
        let truth = exact.eval(&BigRational::from_float(x).unwrap());
        for evaluation in [p.eval_with_bound(x), p.eval_compensated(x)] {
            let error = (BigRational::from_float(evaluation.value).unwrap() - &truth).abs_float();
            assert!(error <= evaluation.error_bound, "{x}: {error:e} {evaluation:?}");
        }
        assert!(p.eval_compensated(x).error_bound < 1e-3 * p.eval_with_bound(x).error_bound);
        // The same through complex arithmetic.
        let z = Complex::new(x, 0.0);
        for evaluation in [p.to_complex().eval_with_bound(z), p.to_complex().eval_compensated(z)] {
            let error =
                (BigRational::from_float(evaluation.value.re).unwrap() - &truth).abs_float();
            assert!(error <= evaluation.error_bound, "{x}: {error:e} {evaluation:?}");
        }
    }
}

trait AbsFloat {
    fn abs_float(&self) -> f64;
}

impl AbsFloat for BigRational {
    fn abs_float(&self) -> f64 {
        use num_traits::{Signed, ToPrimitive};
        self.abs().to_f64().unwrap()
    }
}

#[test]
fn real_from_roots_rounds_once() {
    // Over the rationals, the coefficients of the product are known exactly.
    let roots = [0.1, 0.3, -0.7, 1.9, 2.3, -3.1];
    let exact = Poly::from_roots(&roots.map(|r| BigRational::from_float(r).unwrap()));
    let complex = roots.map(|r| Complex::new(r, 0.0));
    let p = Poly::real_from_roots(&complex).unwrap();
    for (c, e) in p.coefficients().iter().zip(exact.coefficients()) {
        let error = (BigRational::from_float(*c).unwrap() - e).abs_float();
        assert!(error <= 0.5 * f64::EPSILON * c.abs(), "{c}: {error:e}");
    }
    let lone = Poly::real_from_roots(&[Complex::new(1.0, 1.0), Complex::new(1.0, -2.0)]);
    assert!(matches!(lone, Err(PolyError::NotConjugateClosed { .. })));
    let huge = Poly::real_from_roots(&[Complex::new(1e200, 0.0); 2]);
    assert_eq!(huge, Err(PolyError::Overflow { degree: 0 }));
    let nan = Poly::real_from_roots(&[Complex::new(f64::NAN, 0.0)]);
    assert!(matches!(nan, Err(PolyError::NonFiniteValue { index: 0, .. })));
    assert_eq!(Poly::real_from_roots(&[]), Ok(Poly::one()));
}

#[test]
fn trimming() {
    let p = Poly::new(vec![1.0, 5.0, 1e-3, -1e-9]);
    assert_eq!(p.trimmed(1e-9).degree(), Some(2));
    assert_eq!(p.trimmed(1e-3).degree(), Some(1));
    assert_eq!(p.trimmed(0.0), p);
    assert_eq!(p.trimmed(f64::NAN), p);
    assert_eq!(p.trimmed(1.0), Poly::zero());
    assert_eq!(p.to_complex().trimmed(1e-9).degree(), Some(2));
}

proptest! {
    #[test]
    fn ring_laws(a in any(), b in any(), c in any(), x in -9..9_i64) {
        let (a, b, c, x) = (big(&a), big(&b), big(&c), BigInt::from(x));
        prop_assert_eq!(&a * (&b + &c), &a * &b + &a * &c);
        prop_assert_eq!((&a * &b) * &c, &a * (&b * &c));
        prop_assert_eq!(&a - &b, -(&b - &a));
        prop_assert_eq!((&a * &b).eval(&x), a.eval(&x) * b.eval(&x));
        prop_assert_eq!((&a - &b).eval(&x), a.eval(&x) - b.eval(&x));
        // Leibniz's rule.
        prop_assert_eq!((&a * &b).derivative(), a.derivative() * &b + &a * b.derivative());
        prop_assert_eq!(&a + Poly::zero(), a.clone());
        prop_assert_eq!(a.reversed().reversed().shift(a.coefficients().iter().take_while(|c| c.is_zero()).count()), a);
    }

    #[test]
    fn division(a in any(), b in any()) {
        let (p, d) = (big(&a), big(&b));
        prop_assume!(!d.is_zero());
        let (q, r) = p.pseudo_div_rem(&d).unwrap();
        prop_assert!(r.degree() < d.degree());
        let steps = (p.coefficients().len() + 1).saturating_sub(d.coefficients().len());
        let factor = d.leading().unwrap().pow(u32::try_from(steps).unwrap());
        prop_assert_eq!(p.scale(&factor), &q * &d + &r);

        let (p, d) = (rational(&a), rational(&b));
        let (q, r) = p.div_rem(&d).unwrap();
        prop_assert!(r.degree() < d.degree());
        prop_assert_eq!(&p, &(&q * &d + &r));
        prop_assert_eq!((&p * &d).exact_div(&d), Ok(p));
    }

    #[test]
    fn greatest_common_divisor(a in any(), b in any(), common in any()) {
        let (a, b, common) = (rational(&a), rational(&b), rational(&common));
        prop_assume!(!a.is_zero() && !b.is_zero() && !common.is_zero());
        let g = (&a * &common).gcd(&(&b * &common));
        prop_assert!((&a * &common).exact_div(&g).is_ok() && (&b * &common).exact_div(&g).is_ok());
        prop_assert!(g.exact_div(&common).is_ok(), "every common divisor divides it");
        prop_assert_eq!(g.leading(), Some(&BigRational::one()));
    }

    /// The running bound covers the error against exact arithmetic.
    #[test]
    fn running_bound(c in proptest::collection::vec(-1.0..1.0_f64, 1..20), x in -3.0..3.0_f64) {
        let p = Poly::new(c);
        let exact = p.map(|&c| BigRational::from_float(c).unwrap());
        let truth = exact.eval(&BigRational::from_float(x).unwrap());
        for evaluation in [p.eval_with_bound(x), p.eval_compensated(x)] {
            let error = (BigRational::from_float(evaluation.value).unwrap() - &truth).abs_float();
            prop_assert!(error <= evaluation.error_bound);
        }
    }
}
