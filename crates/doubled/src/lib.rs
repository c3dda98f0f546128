//! Real and complex numbers in doubled precision: unevaluated sums of two doubles, about 32 decimal digits.
//!
//! # What is here
//!
//! | item | what it is |
//! |---|---|
//! | [`DoubleDouble`] | a real number `high + low`; exact sums and products of two doubles, `+ - * /`, square root |
//! | [`DoubleDoubleComplex`] | a complex number with such parts; exact products of doubles, `+ - *` |
//! | [`exponent`], [`power_of_two`], [`times_power_of_two`] | exact scaling of doubles, from one end of their range to the other |
//!
//! Residuals, sums that cancel and polynomial coefficients are computed in it and rounded to a double once.
//!
//! # Error bounds
//!
//! With `u = 2^-53`, relative to the exact result of the operation on the operands as they are:
//!
//! | operation | bound | algorithm |
//! |---|---|---|
//! | sum or product of two doubles | 0 | TwoSum (Knuth); fused multiply-add |
//! | `+`, `-` | 3 u^2 + 13 u^3 | Joldes, Muller & Popescu 2017, algorithm 6 |
//! | `*` | 5 u^2 | the same, algorithm 10, and Muller & Rideau 2022 |
//! | `/` | 15 u^2 + 56 u^3 | the same, algorithm 17 |
//! | `sqrt` | 25/8 u^2 | Lefevre, Louvet, Muller, Picot & Rideau 2023, algorithm 8 |
//!
//! Sums keep their bound where their terms cancel.
//! The bounds hold as long as operands, results and products of operands are zero or between 1e-290 and 1e300 in
//! modulus. Below, low parts lose bits to underflow and a few times the smallest double, 5e-324, comes on top.
//! After an overflow, a division by zero or an operand that is not finite, [`DoubleDouble::value`] is not finite; it may be NaN where a
//! double would be infinite.
//!
//! # Sources
//!
//! - Y. Hida, X. S. Li, D. H. Bailey, Algorithms for quad-double precision floating point arithmetic, 15th IEEE Symposium on
//!   Computer Arithmetic, 2001: the arithmetic and its use.
//! - M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
//!   ACM Transactions on Mathematical Software 44(2), 2017: the bounds.
//! - J.-M. Muller, L. Rideau, Formalization of double-word arithmetic, and comments on the former, ACM Transactions on Mathematical
//!   Software 48(1), 2022: machine-checked proofs; the bound of the product from 7 to 5 u^2.
//! - V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, Accurate calculation of Euclidean norms using double-word
//!   arithmetic, ACM Transactions on Mathematical Software 49(1), 2023: the square root.
//!
//! # Example
//!
//! The smaller root of `x^2 - 2 b x + 1` for `b = 10^8`, about `5e-9`, cancels to nothing in plain floats.
//!
//! ```
//! use doubled::DoubleDouble;
//!
//! let b = 1e8_f64;
//! assert_eq!(b - (b * b - 1.0).sqrt(), 0.0);
//!
//! let discriminant = DoubleDouble::product(b, b) - DoubleDouble::ONE;
//! let root = DoubleDouble::from(b) - discriminant.sqrt();
//! assert_eq!(root.value(), 5e-9);
//! ```
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")
)]

mod complex;
mod double_double;
#[cfg(test)]
mod exact;
mod operators;
mod power_of_two;

pub use complex::DoubleDoubleComplex;
pub use double_double::DoubleDouble;
pub use num_complex::Complex;
pub use power_of_two::{exponent, power_of_two, times_power_of_two};
