//! Tests of the scaled evaluation and of the iteration.
#![expect(clippy::float_cmp, reason = "powers of two are exact")]

use super::{C, Precision, ScaledPoly, log2_modulus, scale_by_power};

fn real(ascending: &[f64]) -> ScaledPoly {
    ScaledPoly::new(ascending.iter().map(|&c| C::new(c, 0.0)).collect())
}

#[test]
fn powers_of_two() {
    let z = C::new(3.0, -0.5);
    assert_eq!(scale_by_power(z, 3), C::new(24.0, -4.0));
    assert_eq!(scale_by_power(scale_by_power(z, 1020), -1020), z);
    assert_eq!(scale_by_power(C::new(2f64.powi(-1000), 0.0), 2000), C::new(2f64.powi(1000), 0.0));
    assert_eq!(scale_by_power(z, -9000), C::new(0.0, 0.0));
    assert_eq!(log2_modulus(C::new(0.0, -8.0)), 3.0);
    assert_eq!(log2_modulus(C::new(2f64.powi(-1070), 0.0)), -1070.0);
    assert_eq!(log2_modulus(C::new(2f64.powi(1023), 0.0)), 1023.0);
    assert_eq!(log2_modulus(C::new(0.0, 0.0)), f64::NEG_INFINITY);
}

#[test]
fn evaluation_under_scaling() {
    // p(2^e y) for e = 3 at y = 1/2: p(4) = 1 - 12 + 32 = 21 up to the common power of two.
    let mut p = real(&[1.0, -3.0, 2.0]);
    let (at, zero) = (p.evaluate(C::new(0.5, 0.0), 3, Precision::Plain), p.scaled(3)[0].re);
    assert_eq!(at.value.re / zero, 21.0);
    // dp/dy = 2^e p'(4) = 8 * 13
    assert_eq!(at.derivative.re / zero, 104.0);
    assert_eq!(at.terms / zero, 45.0);
    let doubled = p.evaluate(C::new(0.5, 0.0), 3, Precision::Doubled);
    assert_eq!((doubled.value, doubled.derivative), (at.value, at.derivative));
    assert!(doubled.bound < 1e-14 * at.bound);
}

#[test]
fn moduli_that_no_product_could_hold() {
    // Roots 1e-150 and 1e150: p(1e150) overflows term by term.
    let mut p = real(&[1.0, -1e150, 1.0]);
    let mut moduli: Vec<f64> = p.approximate(100).unwrap().roots.iter().map(|z| z.norm()).collect();
    moduli.sort_by(f64::total_cmp);
    assert!((moduli[0] / 1e-150 - 1.0).abs() < 1e-15 && (moduli[1] / 1e150 - 1.0).abs() < 1e-15);
}

#[test]
fn few_sweeps_suffice() {
    let mut unity = vec![0.0; 201];
    (unity[0], unity[200]) = (-1.0, 1.0);
    let found = real(&unity).approximate(100).unwrap();
    assert!(found.converged && found.iterations < 10, "{}", found.iterations);
    let starved = real(&[1.0, -3.0, 1.0]).approximate(1).unwrap();
    assert!(!starved.converged);
}
