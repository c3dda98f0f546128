//! What only floating-point polynomials have: error bounds, complex arguments, roots rounded once.

use crate::leja::leja_order;
use crate::{Poly, PolyError};
use doubled::{DoubleDouble, DoubleDoubleComplex};
use num_complex::Complex;

/// Half the distance from 1 to the next float: the relative error of one operation.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Relative error of one complex product (Brent, Percival & Zimmermann 2007: sqrt 5), rounded up.
const COMPLEX_PRODUCT: f64 = 2.24;

/// Error of one doubled-precision complex step of Horner's rule, in squares of the unit roundoff, rounded up.
const DOUBLED_STEP: f64 = 32.0;

/// A computed value with a bound on its rounding error.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct BoundedValue<T> {
    /// The computed value.
    pub value: T,
    /// The exact value lies within this distance, barring underflow.
    pub error_bound: f64,
}

/// Horner's rule with a running error bound; the first error factor belongs to one product.
pub(crate) fn horner_with_bound(
    coefficients: &[Complex<f64>],
    x: Complex<f64>,
    product_error: f64,
) -> BoundedValue<Complex<f64>> {
    let modulus = x.norm();
    let mut value = Complex::new(0.0, 0.0);
    let mut error = 0.0;
    for c in coefficients.iter().rev() {
        let product = value * x;
        value = product + c;
        error = modulus * error + product_error * product.norm() + value.norm();
    }
    let slack = 1.0 + 8.0 * UNIT_ROUNDOFF * coefficients.len() as f64;
    BoundedValue { value, error_bound: UNIT_ROUNDOFF * error * slack }
}

/// Sum of `|c_k| |x|^k`: what the rounding errors of Horner's rule are measured by.
pub(crate) fn absolute_sum(coefficients: &[Complex<f64>], modulus: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * modulus + c.norm())
}

/// Horner's rule in doubled precision: value and derivative.
pub(crate) fn horner_doubled(
    coefficients: &[Complex<f64>],
    x: DoubleDoubleComplex,
) -> (DoubleDoubleComplex, DoubleDoubleComplex) {
    let mut value = DoubleDoubleComplex::ZERO;
    let mut derivative = DoubleDoubleComplex::ZERO;
    for &c in coefficients.iter().rev() {
        derivative = derivative * x + value;
        value = value * x + c.into();
    }
    (value, derivative)
}

/// Bound on the error of [`horner_doubled`]'s value before it is rounded to a float.
pub(crate) fn doubled_bound(coefficients: &[Complex<f64>], modulus: f64) -> f64 {
    DOUBLED_STEP
        * coefficients.len() as f64
        * UNIT_ROUNDOFF
        * UNIT_ROUNDOFF
        * absolute_sum(coefficients, modulus)
}

impl Poly<f64> {
    /// The same polynomial with complex coefficients.
    pub fn to_complex(&self) -> Poly<Complex<f64>> {
        self.map(|&c| Complex::new(c, 0.0))
    }

    /// The value at a complex number, by Horner's rule.
    pub fn eval_complex(&self, x: Complex<f64>) -> Complex<f64> {
        self.coefficients.iter().rev().fold(Complex::new(0.0, 0.0), |value, &c| value * x + c)
    }

    /// The value at `x` with a running bound on its rounding error.
    ///
    /// Higham 2002, Accuracy and Stability of Numerical Algorithms, algorithm 5.1.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// // (x - 1)^7, expanded, close to its root: the bound says that no digit can be trusted.
    /// let p = Poly::from_roots(&[1.0; 7]);
    /// let near = p.eval_with_bound(1.001);
    /// assert!(near.value.abs() < near.error_bound);
    /// let far = p.eval_with_bound(3.0);
    /// assert_eq!(far.value, 128.0);
    /// assert!(far.error_bound < 1e-11);
    /// ```
    pub fn eval_with_bound(&self, x: f64) -> BoundedValue<f64> {
        let modulus = x.abs();
        let mut value = 0.0_f64;
        let mut error = 0.0_f64;
        for &c in self.coefficients.iter().rev() {
            let product = value * x;
            value = product + c;
            error = modulus * error + product.abs() + value.abs();
        }
        let slack = 1.0 + 8.0 * UNIT_ROUNDOFF * self.coefficients.len() as f64;
        BoundedValue { value, error_bound: UNIT_ROUNDOFF * error * slack }
    }

    /// The value at `x` as if computed with twice the precision and then rounded, with a bound on its error.
    ///
    /// Horner's rule in double-double arithmetic; the bound is
    /// `u |value| + 32 (n+1) u^2 sum |c_k| |x|^k` with `u = 2^-53`.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::from_roots(&[1.0; 7]); // (x - 1)^7
    /// let near = p.eval_compensated(1.0 + 1.0 / 1024.0);
    /// assert!((near.value / 2f64.powi(-70) - 1.0).abs() < 1e-7);
    /// ```
    pub fn eval_compensated(&self, x: f64) -> BoundedValue<f64> {
        let argument = DoubleDouble::from(x);
        let mut value = DoubleDouble::ZERO;
        let mut sum = 0.0;
        for &c in self.coefficients.iter().rev() {
            value = value * argument + c.into();
            sum = sum * x.abs() + c.abs();
        }
        let value = value.value();
        let tail = DOUBLED_STEP * self.coefficients.len() as f64 * UNIT_ROUNDOFF * UNIT_ROUNDOFF;
        BoundedValue { value, error_bound: UNIT_ROUNDOFF * value.abs() + tail * sum }
    }

    /// The polynomial without its leading coefficients of modulus at most `relative_tolerance` times the largest.
    ///
    /// A tolerance of zero, a negative one or NaN drops nothing.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::from_descending(&[1e-17, -3e-16, 2.0, 1.0]);
    /// assert_eq!(p.trimmed(1e-14).descending(), [2.0, 1.0]);
    /// ```
    pub fn trimmed(&self, relative_tolerance: f64) -> Self {
        let largest = self.coefficients.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let keep =
            self.coefficients.iter().rposition(|c| keeps(c.abs(), relative_tolerance * largest));
        Self::new(self.coefficients[..keep.map_or(0, |k| k + 1)].to_vec())
    }

    /// The monic real polynomial with the given roots, computed in doubled precision and rounded once.
    ///
    /// Roots that are not real must come with their conjugates, exactly and in any order.
    ///
    /// # Errors
    /// [`PolyError::NotConjugateClosed`] if a conjugate is missing, [`PolyError::NonFiniteValue`] for NaN or
    /// infinite roots, [`PolyError::Overflow`] if a coefficient leaves the range of floats.
    ///
    /// # Example
    /// ```
    /// use poly::{Complex, Poly};
    ///
    /// let p = Poly::real_from_roots(&[Complex::new(1.0, 2.0), Complex::new(3.0, 0.0), Complex::new(1.0, -2.0)])?;
    /// assert_eq!(p.descending(), [1.0, -5.0, 11.0, -15.0]);
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn real_from_roots(roots: &[Complex<f64>]) -> Result<Self, PolyError> {
        let mut unmatched: Vec<Complex<f64>> = Vec::new();
        let mut matched: Vec<Complex<f64>> = Vec::new();
        for (index, &root) in roots.iter().enumerate() {
            if !(root.re.is_finite() && root.im.is_finite()) {
                return Err(PolyError::NonFiniteValue { what: "root", index, value: root });
            }
            if root.im == 0.0 {
                matched.push(root);
            } else if let Some(k) = unmatched.iter().position(|&other| other == root.conj()) {
                unmatched.swap_remove(k);
                matched.push(root);
            } else {
                unmatched.push(root);
            }
        }
        if let Some(&value) = unmatched.first() {
            return Err(PolyError::NotConjugateClosed { value });
        }
        let mut product = vec![DoubleDouble::ONE];
        for k in leja_order(&matched) {
            let (re, im) = (DoubleDouble::from(matched[k].re), DoubleDouble::from(matched[k].im));
            if matched[k].im == 0.0 {
                multiply(&mut product, &[-re, DoubleDouble::ONE]);
            } else {
                let square = re * re + im * im;
                multiply(&mut product, &[square, -(re + re), DoubleDouble::ONE]);
            }
        }
        let coefficients: Vec<f64> = product.into_iter().map(DoubleDouble::value).collect();
        match coefficients.iter().position(|c| !c.is_finite()) {
            Some(degree) => Err(PolyError::Overflow { degree }),
            None => Ok(Self::new(coefficients)),
        }
    }
}

/// Whether a leading coefficient stays; one that cannot be compared does.
fn keeps(modulus: f64, threshold: f64) -> bool {
    modulus.partial_cmp(&threshold).is_none_or(std::cmp::Ordering::is_gt)
}

fn multiply(product: &mut Vec<DoubleDouble>, factor: &[DoubleDouble]) {
    let mut result = vec![DoubleDouble::ZERO; product.len() + factor.len() - 1];
    for (i, &a) in product.iter().enumerate() {
        for (k, &b) in factor.iter().enumerate() {
            result[i + k] += a * b;
        }
    }
    *product = result;
}

impl Poly<Complex<f64>> {
    /// The value at a complex number, by Horner's rule.
    pub fn eval_complex(&self, x: Complex<f64>) -> Complex<f64> {
        self.eval(&x)
    }

    /// The value at `x` with a running bound on its rounding error.
    ///
    /// Higham 2002, algorithm 5.1, with the larger error of complex products.
    pub fn eval_with_bound(&self, x: Complex<f64>) -> BoundedValue<Complex<f64>> {
        horner_with_bound(&self.coefficients, x, COMPLEX_PRODUCT)
    }

    /// The value at `x` as if computed with twice the precision and then rounded, with a bound on its error.
    pub fn eval_compensated(&self, x: Complex<f64>) -> BoundedValue<Complex<f64>> {
        let value = horner_doubled(&self.coefficients, x.into()).0.value();
        let tail = doubled_bound(&self.coefficients, x.norm());
        BoundedValue { value, error_bound: UNIT_ROUNDOFF * value.norm() + tail }
    }

    /// The polynomial without its leading coefficients of modulus at most `relative_tolerance` times the largest.
    ///
    /// A tolerance of zero, a negative one or NaN drops nothing.
    pub fn trimmed(&self, relative_tolerance: f64) -> Self {
        let largest = self.coefficients.iter().fold(0.0_f64, |m, c| m.max(c.norm()));
        let keep =
            self.coefficients.iter().rposition(|c| keeps(c.norm(), relative_tolerance * largest));
        Self::new(self.coefficients[..keep.map_or(0, |k| k + 1)].to_vec())
    }
}
