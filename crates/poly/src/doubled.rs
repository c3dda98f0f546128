//! Sums and products in doubled precision: a number as an unevaluated sum of two 64-bit floats (about 106 bits).
//!
//! Dekker 1971; Hida, Li & Bailey 2001. Products take the rounding error from a fused multiply-add.

#[cfg(test)]
mod tests;

use num_complex::Complex;

/// The sum `high + low` with `|low| <= ulp(high) / 2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Doubled {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// The sum of `a` and `b` and its rounding error, for any magnitudes (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// As [`two_sum`], for `|a| >= |b|` (Dekker).
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

impl Doubled {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    pub(crate) fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    pub(crate) fn add(self, other: Self) -> Self {
        let (high, low) = two_sum(self.high, other.high);
        let (high_low, low_low) = two_sum(self.low, other.low);
        let (high, low) = quick_two_sum(high, low + high_low);
        let (high, low) = quick_two_sum(high, low + low_low);
        Self { high, low }
    }

    pub(crate) fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    pub(crate) fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    pub(crate) fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        let low = error + (self.high * other.low + self.low * other.high);
        let (high, low) = quick_two_sum(high, low);
        Self { high, low }
    }

    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

/// A complex number in doubled precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubledComplex {
    pub(crate) re: Doubled,
    pub(crate) im: Doubled,
}

impl DoubledComplex {
    pub(crate) const ZERO: Self = Self { re: Doubled::ZERO, im: Doubled::ZERO };

    pub(crate) fn new(value: Complex<f64>) -> Self {
        Self { re: Doubled::new(value.re), im: Doubled::new(value.im) }
    }

    pub(crate) fn add(self, other: Self) -> Self {
        Self { re: self.re.add(other.re), im: self.im.add(other.im) }
    }

    pub(crate) fn sub(self, other: Self) -> Self {
        Self { re: self.re.sub(other.re), im: self.im.sub(other.im) }
    }

    pub(crate) fn mul(self, other: Self) -> Self {
        Self {
            re: self.re.mul(other.re).sub(self.im.mul(other.im)),
            im: self.re.mul(other.im).add(self.im.mul(other.re)),
        }
    }

    pub(crate) fn conj(self) -> Self {
        Self { re: self.re, im: self.im.neg() }
    }

    pub(crate) fn value(self) -> Complex<f64> {
        Complex::new(self.re.value(), self.im.value())
    }
}
