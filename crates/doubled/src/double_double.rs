//! The real number: exact sums and products of two doubles, sign, square root, order.

use core::ops::Neg;

/// A real number in doubled precision: `high + low`, where `high` is the double nearest to the sum.
///
/// It has at least 106 bits, about 32 decimal digits, and the range of a double. The crate's overview lists the error bounds.
/// Comparisons are of the numbers; as with doubles, NaN compares with nothing.
///
/// Multiplication commutes to the last bit, addition as well; neither is associative.
///
/// # Example
///
/// ```
/// use doubled::DoubleDouble;
///
/// // The double nearest to 1/3 is 2^-54 / 3 too small.
/// let rest = DoubleDouble::ONE - DoubleDouble::product(3.0, 1.0 / 3.0);
/// assert_eq!(rest.value(), 2f64.powi(-54));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    // In this order: the number with the larger high part is the larger one, and low parts decide between equal ones.
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// Zero.
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// One.
    pub const ONE: Self = Self { high: 1.0, low: 0.0 };

    /// The exact sum of two doubles of any magnitudes.
    ///
    /// `high = fl(a + b)`, `low = a + b - high` (TwoSum, Knuth 1969). Exact unless it overflows.
    ///
    /// # Example
    ///
    /// ```
    /// use doubled::DoubleDouble;
    ///
    /// let sum = DoubleDouble::sum(1.0, 1e20);
    /// assert_eq!((sum.high(), sum.low()), (1e20, 1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let back = high - a;
        Self { high, low: (a - (high - back)) + (b - back) }
    }

    /// The exact product of two doubles.
    ///
    /// `high = fl(a b)`, `low = a b - high` from a fused multiply-add. Exact if `|a b|` is zero or between 1e-290 and
    /// the largest double.
    ///
    /// # Example
    ///
    /// ```
    /// use doubled::DoubleDouble;
    ///
    /// // (1 + e)(1 - e) = 1 - e^2
    /// let e = 2f64.powi(-30);
    /// let product = DoubleDouble::product(1.0 + e, 1.0 - e);
    /// assert_eq!((product.high(), product.low()), (1.0, -e * e));
    /// ```
    #[inline]
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// `high + low` for `|high| >= |low|` or `high = 0`, exactly (Fast2Sum, Dekker 1971).
    #[inline]
    pub(crate) fn renormalised(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    /// The high part: the nearest double.
    #[inline]
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// The low part: what the number is larger than its high part, at most half a unit in the last place of that.
    #[inline]
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// The nearest double; not finite if either part isn't.
    #[inline]
    #[must_use]
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// The modulus, exactly.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        if self.high.is_sign_negative() { -self } else { self }
    }

    /// The square root; NaN for a negative number.
    ///
    /// One Newton step from the root of the high part, with its exact residual:
    /// `s = sqrt(high)`, `s + (high - s^2 + low) / (2 s)`. Hida, Li & Bailey 2001 do the same from `1 / sqrt(high)`.
    /// Relative error at most 25/8 u^2 (Lefevre, Louvet, Muller, Picot & Rideau 2023, algorithm 8). The root of an exact square of a double
    /// is exact.
    ///
    /// # Example
    ///
    /// ```
    /// use doubled::DoubleDouble;
    ///
    /// assert_eq!(DoubleDouble::product(0.1, 0.1).sqrt(), DoubleDouble::from(0.1));
    /// let root = DoubleDouble::from(2.0).sqrt();
    /// let error = root * root - DoubleDouble::from(2.0);
    /// assert!(error.value().abs() < 2e-31);
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::from(root);
        }
        let residual = self.low + (-root).mul_add(root, self.high);
        Self::renormalised(root, residual / (2.0 * root))
    }
}

/// Exactly.
impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

/// Exactly.
impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

#[cfg(test)]
mod tests;
