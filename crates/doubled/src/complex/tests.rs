//! Tests of `complex.rs` against exact rationals.

use super::*;
use crate::exact::{agrees, agrees_on_scale, any_scale, exact, rational, scaled};
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

const TINY: f64 = 1e-12;

fn complex(
    part: impl Strategy<Value = DoubleDouble> + Clone,
) -> impl Strategy<Value = DoubleDoubleComplex> {
    (part.clone(), part).prop_map(|(re, im)| DoubleDoubleComplex { re, im })
}

/// Exact real and imaginary part.
type Exact = (BigRational, BigRational);

fn exactly(z: DoubleDoubleComplex) -> Exact {
    (exact(z.re), exact(z.im))
}

fn times(z: &Exact, w: &Exact) -> Exact {
    (&z.0 * &w.0 - &z.1 * &w.1, &z.0 * &w.1 + &z.1 * &w.0)
}

/// `|a| |c| + |b| |d|` and `|a| |d| + |b| |c|`: both at most the product of the moduli.
fn scales(z: &Exact, w: &Exact) -> Exact {
    let (z, w) = ((z.0.abs(), z.1.abs()), (w.0.abs(), w.1.abs()));
    (&z.0 * &w.0 + &z.1 * &w.1, &z.0 * &w.1 + &z.1 * &w.0)
}

proptest! {
    #[test]
    fn products(z in complex(scaled(-20..=20)), w in complex(scaled(-20..=20))) {
        let product = z * w;
        let (expected, scale) = (times(&exactly(z), &exactly(w)), scales(&exactly(z), &exactly(w)));
        prop_assert!(agrees_on_scale(product.re, &expected.0, 8.0 + TINY, &scale.0));
        prop_assert!(agrees_on_scale(product.im, &expected.1, 8.0 + TINY, &scale.1));
        prop_assert_eq!(product, w * z);
        // Conjugates go through the same roundings.
        prop_assert_eq!(z.conj() * w.conj(), product.conj());
        prop_assert!((z * z.conj()).im.is_zero());
    }

    #[test]
    fn products_of_doubles(z in complex(any_scale()), w in complex(any_scale())) {
        let (z, w) = (z.value(), w.value());
        let exact_float = |z: Complex<f64>| (rational(z.re), rational(z.im));
        let product = DoubleDoubleComplex::product(z, w);
        let expected = times(&exact_float(z), &exact_float(w));
        prop_assert!(agrees(product.re, &expected.0, 3.0 + TINY));
        prop_assert!(agrees(product.im, &expected.1, 3.0 + TINY));
        let real = DoubleDoubleComplex::real_product(z.re, w);
        let expected = times(&(rational(z.re), rational(0.0)), &exact_float(w));
        prop_assert!(agrees(real.re, &expected.0, 0.0) && agrees(real.im, &expected.1, 0.0));
    }

    #[test]
    fn sums_are_those_of_the_parts(z in complex(any_scale()), w in complex(any_scale())) {
        prop_assert_eq!(z + w, DoubleDoubleComplex { re: z.re + w.re, im: z.im + w.im });
        prop_assert_eq!(z - w, z + -w);
        prop_assert_eq!([z, w, z].into_iter().sum::<DoubleDoubleComplex>(), z + w + z);
        let mut sum = z;
        sum += w;
        sum -= z;
        sum *= w;
        prop_assert_eq!(sum, ((z + w) - z) * w);
    }
}

#[test]
fn a_residual_that_cancels() {
    // 3 (1/3) - 1 + j (1/3) 3 - j, with 1/3 as a double 2^-54 / 3 too small.
    let third = Complex::new(1.0 / 3.0, 1.0 / 3.0);
    let sum = DoubleDoubleComplex::real_product(3.0, third)
        - DoubleDoubleComplex::from(Complex::new(1.0, 1.0));
    assert_eq!(sum.value(), -Complex::new(2f64.powi(-54), 2f64.powi(-54)));
    let turned = DoubleDoubleComplex::product(Complex::new(0.0, 3.0), third);
    assert_eq!((turned.re + DoubleDouble::ONE).value(), 2f64.powi(-54));
    assert_eq!((turned.im - DoubleDouble::ONE).value(), -2f64.powi(-54));
}

#[test]
fn constants_and_conversions() {
    let z = DoubleDoubleComplex::from(Complex::new(3.0, -4.0));
    assert!(DoubleDoubleComplex::zero().is_zero());
    assert!(!DoubleDoubleComplex::from(Complex::new(0.0, 1.0)).is_zero());
    assert_eq!(DoubleDoubleComplex::one() * z, z);
    assert_eq!(DoubleDoubleComplex::from(2.0) * z, z + z);
    assert_eq!(z.conj().value(), Complex::new(3.0, 4.0));
    assert_eq!((z * z).value(), Complex::new(-7.0, -24.0));
}
