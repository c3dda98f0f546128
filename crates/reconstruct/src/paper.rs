//! What does the paper's method find? Transmissibilities of noise-free records, their differences, and the zeros that all differences share.
//!
//! | item | what it does |
//! |---|---|
//! | [`identify`] | the whole method: records to eigenvalues |
//! | [`TransmissibilityPair`], [`Theorem`], [`containment`] | Theorem 3.1, exact over integers and rationals |
//! | [`identify_transmissibility`] | one rational transmissibility from one record |
//! | [`difference_zeros`] | where the transmissibilities of two records agree |
//! | [`shared_zeros`] | the zeros that several differences of transmissibilities have in common |
//!
//! # Example
//!
//! Two transmissibilities of one system disagree everywhere but at its eigenvalues, here -1 and -2:
//!
//! ```
//! use lti::Transmissibility;
//! use poly::Poly;
//! use reconstruct::paper::TransmissibilityPair;
//!
//! let p = |descending: &[i64]| Poly::from_descending(descending);
//! let first = Transmissibility::from_polynomials(p(&[1, 1]), p(&[1, 2]))?;
//! let second = Transmissibility::from_polynomials(p(&[-1, -1]), p(&[1, 2]))?;
//! let determinant = TransmissibilityPair::new(first, second).determinant();
//! assert_eq!((determinant.eval(&-1), determinant.eval(&-2), determinant.eval(&0)), (0, 0, -4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod difference;
mod identification;
mod method;
mod shared_zeros;
mod theorem;

pub use difference::{Zero, difference_zeros};
pub use identification::{Identification, IdentificationOptions, identify_transmissibility};
pub use method::{Difference, Doubt, Mode, Options, Solution, identify};
pub use shared_zeros::{SharedZero, SharedZeros, shared_zeros};
pub use theorem::{Containment, Statement, Theorem, TransmissibilityPair, containment};
