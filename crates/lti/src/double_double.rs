//! Double-double arithmetic: an unevaluated sum of two doubles, about 32 decimal digits.
//!
//! It is a ring in the sense of [`poly::Ring`], so the same code that is exact over integers and rationals gives
//! polynomial coefficients that are correct to the last digit or two over `f64` data.

use core::ops::{Add, Mul, Neg, Sub};

use num_traits::{One, Zero};

/// high + low with |low| at most half a unit in the last place of high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The exact product of two doubles.
    pub(crate) fn product(x: f64, y: f64) -> Self {
        let high = x * y;
        Self { high, low: x.mul_add(y, -high) }
    }

    /// The nearest double.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    /// The exact sum of two doubles (Knuth's TwoSum).
    fn sum(x: f64, y: f64) -> Self {
        let high = x + y;
        let back = high - x;
        Self { high, low: (x - (high - back)) + (y - back) }
    }

    /// high + low renormalised; needs |high| >= |low|.
    fn renormalised(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        // The accurate sum: relative error 3 u^2 also for opposite signs (Joldes, Muller & Popescu 2017, alg. 6).
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::renormalised(high.high, high.low + low.high);
        Self::renormalised(first.high, first.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        Self::renormalised(product.high, product.low + cross)
    }
}

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self::from(0.0)
    }
    fn is_zero(&self) -> bool {
        self.high == 0.0 && self.low == 0.0
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self::from(1.0)
    }
}

#[cfg(test)]
mod tests;
