//! The complex number: exact products of doubles to sum up, and the operators.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_complex::Complex;
use num_traits::{One, Zero};

use crate::DoubleDouble;

/// A complex number in doubled precision.
///
/// Conjugation goes through all operations: the conjugates of the operands give exactly the conjugate of the result.
///
/// # Example
///
/// The residual of an eigenpair, `A v - lambda v`, row by row: products of doubles are summed and the sum is rounded once.
///
/// ```
/// use doubled::{Complex, DoubleDoubleComplex};
///
/// // A = [1, -1; 1, 1] has the eigenvalue 1 + j with the vector (1, -j).
/// let matrix = [[1.0, -1.0], [1.0, 1.0]];
/// let vector = [Complex::new(1.0, 0.0), Complex::new(0.0, -1.0)];
/// let value = Complex::new(1.0, 1.0);
/// for (row, own) in matrix.iter().zip(vector) {
///     let terms = row.iter().zip(vector).map(|(&a, v)| DoubleDoubleComplex::real_product(a, v));
///     let residual = terms.sum::<DoubleDoubleComplex>() - DoubleDoubleComplex::product(value, own);
///     assert_eq!(residual.value(), Complex::new(0.0, 0.0));
/// }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDoubleComplex {
    /// The real part.
    pub re: DoubleDouble,
    /// The imaginary part.
    pub im: DoubleDouble,
}

impl DoubleDoubleComplex {
    /// Zero.
    pub const ZERO: Self = Self { re: DoubleDouble::ZERO, im: DoubleDouble::ZERO };

    /// One.
    pub const ONE: Self = Self { re: DoubleDouble::ONE, im: DoubleDouble::ZERO };

    /// The product of a real and a complex number of doubles, exactly, as [`DoubleDouble::product`] is.
    #[inline]
    #[must_use]
    pub fn real_product(a: f64, z: Complex<f64>) -> Self {
        Self { re: DoubleDouble::product(a, z.re), im: DoubleDouble::product(a, z.im) }
    }

    /// The product of two complex numbers of doubles.
    ///
    /// Each part is one sum of two exact products: its error is at most 3 u^2 + 13 u^3 relative to that part, also where
    /// the two products cancel.
    ///
    /// # Example
    ///
    /// ```
    /// use doubled::{Complex, DoubleDoubleComplex};
    ///
    /// // (1 + e + j)(1 - e + j) = -e^2 + 2j
    /// let e = 2f64.powi(-40);
    /// let product = DoubleDoubleComplex::product(Complex::new(1.0 + e, 1.0), Complex::new(1.0 - e, 1.0));
    /// assert_eq!(product.value(), Complex::new(-e * e, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn product(z: Complex<f64>, w: Complex<f64>) -> Self {
        Self {
            re: DoubleDouble::product(z.re, w.re) - DoubleDouble::product(z.im, w.im),
            im: DoubleDouble::product(z.re, w.im) + DoubleDouble::product(z.im, w.re),
        }
    }

    /// The conjugate, exactly.
    #[inline]
    #[must_use]
    pub fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// Both parts rounded to the nearest double.
    #[inline]
    #[must_use]
    pub fn value(self) -> Complex<f64> {
        Complex::new(self.re.value(), self.im.value())
    }
}

/// Exactly.
impl From<Complex<f64>> for DoubleDoubleComplex {
    #[inline]
    fn from(value: Complex<f64>) -> Self {
        Self { re: value.re.into(), im: value.im.into() }
    }
}

/// Exactly; the imaginary part is zero.
impl From<f64> for DoubleDoubleComplex {
    #[inline]
    fn from(value: f64) -> Self {
        Self { re: value.into(), im: DoubleDouble::ZERO }
    }
}

/// Each part as a sum of [`DoubleDouble`]s.
impl Add for DoubleDoubleComplex {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

/// Exactly.
impl Neg for DoubleDoubleComplex {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

/// Each part as a difference of [`DoubleDouble`]s.
impl Sub for DoubleDoubleComplex {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

/// To first order the error of each part is at most 8 u^2 `|z| |w|`: 5 from the products, 3 from their sum.
impl Mul for DoubleDoubleComplex {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl AddAssign for DoubleDoubleComplex {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDoubleComplex {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for DoubleDoubleComplex {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

/// From the first to the last, each part as a sum of [`DoubleDouble`]s.
impl Sum for DoubleDoubleComplex {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, |sum, term| sum + term)
    }
}

impl Zero for DoubleDoubleComplex {
    fn zero() -> Self {
        Self::ZERO
    }

    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl One for DoubleDoubleComplex {
    fn one() -> Self {
        Self::ONE
    }
}

#[cfg(test)]
mod tests;
