//! Tests of the zero-pole-gain form.
#![expect(clippy::float_cmp, reason = "exact values are promised where they are compared")]

use super::ZeroPoleGain;
use crate::{Complex, MrootsOptions, Poly, PolyError, Rational};

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

#[test]
fn conjugates_are_made_exact() {
    let list = vec![c(0.5, 0.3), c(2.0, 1e-12), c(0.5 + 1e-12, -0.3), c(-1.0, 0.0)];
    let g = ZeroPoleGain::new(list, vec![], 1.0).unwrap();
    assert_eq!(g.zeros()[0], c(-1.0, 0.0));
    assert_eq!(g.zeros()[1], g.zeros()[2].conj());
    assert!(g.zeros()[1].im > 0.0);
    assert_eq!(g.zeros()[3], c(2.0, 0.0));
}

#[test]
fn nearly_equal_pairs_keep_their_partners() {
    let (a, b) = (c(1.0, 0.5), c(1.0 + 1e-9, 0.5));
    let g = ZeroPoleGain::new(vec![], vec![a, b, b.conj(), a.conj()], 1.0).unwrap();
    assert_eq!(g.poles(), [a, a.conj(), b, b.conj()]);
}

#[test]
fn bad_input() {
    let lone = ZeroPoleGain::new(vec![c(0.0, 1.0)], vec![], 1.0);
    assert!(matches!(lone, Err(PolyError::NotConjugateClosed { .. })));
    let nan = ZeroPoleGain::new(vec![], vec![c(1.0, 0.0), c(f64::NAN, 0.0)], 1.0);
    assert!(matches!(nan, Err(PolyError::NonFiniteValue { what: "pole", index: 1, .. })));
    let infinite = ZeroPoleGain::new(vec![], vec![], f64::INFINITY);
    assert!(matches!(infinite, Err(PolyError::NonFiniteValue { what: "gain", .. })));
    let huge = ZeroPoleGain::new(vec![c(1e200, 0.0), c(1e200, 0.0)], vec![], 1.0).unwrap();
    assert_eq!(huge.to_rational(), Err(PolyError::Overflow { degree: 0 }));
}

#[test]
fn round_trip() {
    let numerator = Poly::from_descending(&[3.0, -9.0, 6.0]);
    let denominator = Poly::from_descending(&[1.0, -2.0, 5.0, 0.0]);
    let r = Rational::new(numerator, denominator).unwrap();
    let g = ZeroPoleGain::from_rational(&r, &MrootsOptions::default()).unwrap();
    assert_eq!(g.gain(), 3.0);
    assert_eq!(g.to_rational().unwrap(), r);
    let x = c(0.3, -0.9);
    assert!((g.eval(x) - r.eval_complex(x)).norm() < 1e-14);
    let square = g.product(&g).unwrap();
    assert!((square.eval(x) - g.eval(x) * g.eval(x)).norm() < 1e-13);
    // Factors in turn: 200 zeros and poles of modulus 1e5 don't overflow.
    let many = ZeroPoleGain::new(vec![c(1e5, 0.0); 200], vec![c(-1e5, 0.0); 200], 2.0).unwrap();
    assert!((many.eval(c(0.0, 0.0)) - 2.0).norm() < 1e-12);
}
