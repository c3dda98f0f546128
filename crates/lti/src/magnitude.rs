//! Magnitudes: the ring operations without their signs, which turn a computation into a bound on its terms.

use core::ops::{Add, Mul, Neg, Sub};

use num_traits::{One, Zero};

/// A number that is never negative; subtraction adds and negation does nothing.
///
/// Running a division-free algorithm over the magnitudes of its data bounds the sum of the absolute values of all
/// terms that make up each result. A result below the unit roundoff times that bound may be all rounding of the
/// data: it can't be told from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Magnitude(pub(crate) f64);

impl Add for Magnitude {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Magnitude {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "magnitudes of differences add")]
    fn sub(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Neg for Magnitude {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

impl Mul for Magnitude {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Zero for Magnitude {
    fn zero() -> Self {
        Self(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Magnitude {
    fn one() -> Self {
        Self(1.0)
    }
}
