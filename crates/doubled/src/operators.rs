//! Arithmetic of [`DoubleDouble`]: the operators, and zero and one as a ring has them.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::DoubleDouble;

/// Relative error at most 3 u^2 + 13 u^3, also where the terms cancel (Joldes, Muller & Popescu 2017, algorithm 6).
impl Add for DoubleDouble {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high(), other.high());
        let low = Self::sum(self.low(), other.low());
        let first = Self::renormalised(high.high(), high.low() + low.high());
        Self::renormalised(first.high(), first.low() + low.low())
    }
}

/// As the sum with the negative.
impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Relative error at most 5 u^2 (Joldes, Muller & Popescu 2017, algorithm 10; Muller & Rideau 2022).
///
/// Of their three algorithms the one that commutes to the last bit, as a ring needs it: so `z conj(z)` is exactly real.
impl Mul for DoubleDouble {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high(), other.high());
        let cross = self.high() * other.low() + self.low() * other.high();
        Self::renormalised(product.high(), product.low() + cross)
    }
}

/// Relative error at most 15 u^2 + 56 u^3 (Joldes, Muller & Popescu 2017, algorithm 17).
///
/// `t = fl(high / other.high)`, then `t + (self - t other) / other.high`, the first two digits of Hida, Li & Bailey's long
/// division. Exact if the quotient is a double and has no error: `x / x = 1`.
impl Div for DoubleDouble {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.high() / other.high();
        // other * quotient with relative error 3/2 u^2 + 4 u^3 (algorithm 7 there).
        let product = Self::product(other.high(), quotient);
        let rounded = Self::renormalised(product.high(), other.low() * quotient);
        let back = Self::renormalised(rounded.high(), rounded.low() + product.low());
        // The difference of the high parts is exact.
        let rest = (self.high() - back.high()) + (self.low() - back.low());
        Self::renormalised(quotient, rest / other.high())
    }
}

impl AddAssign for DoubleDouble {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for DoubleDouble {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for DoubleDouble {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

/// From the first to the last. To first order the error is at most 3 (n - 1) u^2 times the sum of the moduli of the n terms.
impl Sum for DoubleDouble {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, |sum, term| sum + term)
    }
}

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self::ZERO
    }

    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self::ONE
    }
}

#[cfg(test)]
mod tests;
