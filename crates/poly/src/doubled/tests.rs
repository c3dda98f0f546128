//! Tests of doubled precision against exact rationals.

use super::{Doubled, DoubledComplex};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

fn exact(x: Doubled) -> BigRational {
    BigRational::from_float(x.high).unwrap() + BigRational::from_float(x.low).unwrap()
}

/// Relative to `scale`, in squares of the unit roundoff.
fn units(error: &BigRational, scale: f64) -> f64 {
    error.abs().to_f64().unwrap() / scale / f64::EPSILON.powi(2) * 4.0
}

fn doubled() -> impl Strategy<Value = Doubled> {
    (-1e3..1e3_f64, -1.0..1.0_f64)
        .prop_map(|(high, low)| Doubled::new(high).add(Doubled::new(low * 1e-16)))
}

proptest! {
    #[test]
    fn sums_and_products(a in doubled(), b in doubled()) {
        let sum = exact(a.add(b)) - (exact(a) + exact(b));
        prop_assert!(units(&sum, a.high.abs() + b.high.abs()) <= 3.0);
        let difference = exact(a.sub(b)) - (exact(a) - exact(b));
        prop_assert!(units(&difference, a.high.abs() + b.high.abs()) <= 3.0);
        let product = exact(a.mul(b)) - exact(a) * exact(b);
        prop_assert!(units(&product, (a.high * b.high).abs()) <= 8.0);
    }

    #[test]
    fn complex_products(a in doubled(), b in doubled(), c in doubled(), d in doubled()) {
        let (z, w) = (DoubledComplex { re: a, im: b }, DoubledComplex { re: c, im: d });
        let product = z.mul(w);
        let re = exact(product.re) - (exact(a) * exact(c) - exact(b) * exact(d));
        let im = exact(product.im) - (exact(a) * exact(d) + exact(b) * exact(c));
        let scale = a.high.hypot(b.high) * c.high.hypot(d.high);
        prop_assert!(units(&re, scale) <= 16.0 && units(&im, scale) <= 16.0);
        // Conjugates go through the same roundings.
        prop_assert_eq!(z.conj().mul(w.conj()).value(), product.conj().value());
    }
}

#[test]
fn cancellation_leaves_the_low_part() {
    let third = Doubled::new(1.0 / 3.0);
    let rest = Doubled::new(1.0).sub(third.mul(Doubled::new(3.0)));
    // 1/3 as a float is 2^-54 / 3 too small.
    assert!((rest.value() - 2f64.powi(-54)).abs() < 1e-32);
    let z = DoubledComplex::new(Complex::new(1.0, 0.0)).add(DoubledComplex::ZERO);
    assert_eq!(z.value(), Complex::new(1.0, 0.0));
}
