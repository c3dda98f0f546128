//! What coefficients must be able to do.

use num_traits::{Inv, One, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A commutative ring with one: coefficients that can be added, subtracted and multiplied.
///
/// It is implemented for every type with the operations below, by value: `i64`, `BigInt`,
/// `BigRational`, `f64`, `Complex<f64>`, and [`Poly`](crate::Poly) itself.
/// Multiplication must commute; the compiler cannot check that.
///
/// Machine integers overflow as they always do: panic in debug builds, wrap in release builds.
/// Use `BigInt` where coefficients may grow.
pub trait Ring:
    Clone
    + PartialEq
    + Zero
    + One
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Clone
        + PartialEq
        + Zero
        + One
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Neg<Output = T>
{
}

/// A ring in which every nonzero element has an inverse.
///
/// It is implemented for every [`Ring`] with `/` and [`num_traits::Inv`]. Integers have no `Inv`, so they
/// stay out; `Ratio<i64>`, `BigRational`, `f64` and `Complex<f64>` are in.
/// `Complex<i64>` is let in by `num-complex` although it is no field: do not use it here.
pub trait Field: Ring + Div<Output = Self> + Inv<Output = Self> {}

impl<T> Field for T where T: Ring + Div<Output = T> + Inv<Output = T> {}
