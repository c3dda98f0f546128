//! Polynomials, rational functions and polynomial matrices over any ring, and the multiset of roots with multiplicities.
//!
//! # What is here
//!
//! | item | what it is |
//! |---|---|
//! | [`Ring`], [`Field`] | what coefficients must be able to do; `i64`, `BigInt`, `BigRational`, `f64`, `Complex<f64>` qualify |
//! | [`Poly`] | a polynomial in one variable, coefficients stored ascending |
//! | [`Rational`] | a quotient of two polynomials, with [`Rational::cancel`] for nearly common zeros and poles |
//! | [`PolyMatrix`] | a matrix of polynomials: product, determinant, adjugate, minors |
//! | [`characteristic_polynomial`] | det(pI - A) over any ring, without division |
//! | [`mroots()`] | the roots of a polynomial with multiplicities, condition numbers and error bounds |
//!
//! Exact coefficients give exact results: nothing divides where the ring has no division.
//! Floating-point results carry their numerical doubt: residuals, condition numbers, iterations.
//!
//! Features, both off by default: `faer` adds the finite zeros of a polynomial matrix by a pencil,
//! `nalgebra` adds conversions. Without them no linear-algebra crate is built.
//!
//! # Example
//!
//! The determinant of a polynomial matrix over the integers is exact, and its roots come with condition numbers.
//! ```
//! use poly::{MrootsOptions, Poly, PolyMatrix, mroots};
//!
//! let p = |descending: &[i64]| Poly::from_descending(descending);
//! let matrix = PolyMatrix::new(2, 2, vec![p(&[1, -1]), p(&[1]), p(&[4]), p(&[1, 2])])?;
//! let determinant = matrix.determinant()?;
//! assert_eq!(determinant.display("p").to_string(), "p^2 + p - 6");
//!
//! let roots = mroots(&determinant.map(|&c| c as f64), &MrootsOptions::default())?;
//! let values: Vec<f64> = roots.values().iter().map(|z| z.re).collect();
//! assert_eq!(values, [-3.0, 2.0]);
//! # Ok::<(), poly::PolyError>(())
//! ```

mod aberth;
mod berkowitz;
mod cancellation;
mod error;
mod least_squares;
mod leja;
mod matrix;
mod mroots;
mod newton_polygon;
mod poly;
mod rational;
mod ring;

pub use berkowitz::characteristic_polynomial;
pub use cancellation::{Cancellation, Cancelled, CancelledPair};
pub use error::PolyError;
pub use matrix::PolyMatrix;
#[cfg(feature = "faer")]
pub use matrix::finite_zeros::{FiniteZero, FiniteZeros};
pub use matrix::floating::Determinant;
pub use mroots::{Mroots, MrootsMethod, MrootsOptions, Multiplicities, Root, mroots};
pub use num_complex::Complex;
pub use poly::Poly;
pub use poly::display::PolyDisplay;
pub use poly::floating::BoundedValue;
pub use rational::Rational;
pub use ring::{Field, Ring};
