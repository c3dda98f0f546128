//! Eight frequencies at once: numbers in lanes, so that the compiler can use whatever vectors the machine has.
//!
//! Lanes never mix but in [`Real::sum`], in a fixed order, so that the result does not depend on the width of the vectors.

use std::array::from_fn;
use std::ops::{Add, AddAssign, Mul, Sub, SubAssign};

use num_complex::Complex;

/// Frequencies that are computed side by side.
pub(crate) const WIDTH: usize = 8;

/// Eight real numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Real(pub(crate) [f64; WIDTH]);

/// Eight complex numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes {
    pub(crate) re: Real,
    pub(crate) im: Real,
}

impl Real {
    pub(crate) const ZERO: Self = Self([0.0; WIDTH]);

    #[inline(always)]
    pub(crate) fn all(value: f64) -> Self {
        Self([value; WIDTH])
    }

    #[inline(always)]
    pub(crate) fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    pub(crate) fn sum(self) -> f64 {
        self.0.iter().sum()
    }
}

impl Add for Real {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Real {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Mul for Real {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] * other.0[k]))
    }
}

impl AddAssign for Real {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Lanes {
    pub(crate) const ZERO: Self = Self { re: Real::ZERO, im: Real::ZERO };

    #[inline(always)]
    pub(crate) fn all(value: Complex<f64>) -> Self {
        Self { re: Real::all(value.re), im: Real::all(value.im) }
    }

    /// Every `stride`-th number from `start` on; beyond the end the last one again.
    #[inline(always)]
    pub(crate) fn gather(
        values: &[Complex<f64>],
        start: usize,
        stride: usize,
        last: usize,
    ) -> Self {
        let value: [Complex<f64>; WIDTH] = from_fn(|k| values[(start + k * stride).min(last)]);
        Self { re: Real(from_fn(|k| value[k].re)), im: Real(from_fn(|k| value[k].im)) }
    }

    #[inline(always)]
    pub(crate) fn conj(self) -> Self {
        Self { re: self.re, im: Real::ZERO - self.im }
    }

    #[inline(always)]
    pub(crate) fn scale(self, factor: Real) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }

    #[inline(always)]
    pub(crate) fn norm_sqr(self) -> Real {
        self.re * self.re + self.im * self.im
    }

    /// Re conj(self) other.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> Real {
        self.re * other.re + self.im * other.im
    }

    /// conj(self) other.
    #[inline(always)]
    pub(crate) fn conj_mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re + self.im * other.im,
            im: self.re * other.im - self.im * other.re,
        }
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Lanes {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

#[cfg(test)]
mod tests;
