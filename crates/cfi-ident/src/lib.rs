//! Least-squares identification of noncausal composite FIR/IIR (CFI) models.
//!
//! A transmissibility relates one sensor of a system, the *pseudo output* `y_o`, to another, the *pseudo input* `y_i`. Neither is an input of
//! the system, so the relation may be unstable and noncausal. It is modelled by a finite impulse response that reaches into the past and into the
//! future, divided by a short polynomial that takes the poles near or on the unit circle:
//!
//! ```text
//! D(q) y_o(k) = sum over i = -d .. r of h_i y_i(k - i),     D(q) = q^l + c_(l-1) q^(l-1) + .. + c_1 q  [+ c_0]
//! ```
//!
//! q is the forward shift. All parameters enter linearly, so one least-squares problem finds them.
//!
//! | to | use |
//! |---|---|
//! | say which coefficients the model has | [`Orders`], [`ConstantTerm`], [`Structure`] |
//! | hand in records, with gaps if need be | [`Segment`] |
//! | identify from a record that comes in pieces | [`Accumulator`] |
//! | identify, and see how far to trust it | [`fit`], [`Fit`] |
//! | use the model | [`CfiModel`], [`Prediction`] |
//! | make the model of a known transmissibility | [`ZerosAndPoles`] |
//! | penalise the impulse response (feature `regularized`) | `regularized::fit` |
//!
//! # Numerics
//!
//! The regressors are shifted copies of two channels and are never stored. The crate `hankel` sums their lag products in doubled precision, in one pass and
//! in time that grows with N (l + r + d) only; pivoted Cholesky factorisation in doubled precision, with the columns scaled to norm one, gives rank, condition
//! and solution. Where the condition number is high or the residual small, the solution is corrected on the data with the residual in
//! doubled precision: the result is the exact least-squares solution, rounded. The channels may have any magnitude, 1e-300 to 1e300.
//! [`Engine::Qr`] does the same by Householder reflections, for comparison.
//!
//! # Example
//!
//! A derivative that looks one sample ahead and one back, found from five samples of a parabola and its slope:
//!
//! ```
//! use cfi_ident::{ConstantTerm, FitOptions, Orders, Segment, Structure, fit};
//!
//! let position = [0.0, 1.0, 4.0, 9.0, 16.0]; // k^2
//! let slope = [0.0, 2.0, 4.0, 6.0, 8.0];
//! let structure = Structure::new(Orders::new(0, 1, 1)?, ConstantTerm::Omitted);
//! let found = fit(&[Segment::new(&position, &slope)?], &structure, &FitOptions::default())?;
//!
//! // slope(k) = (position(k + 1) - position(k - 1)) / 2
//! for (h, expected) in found.model.markov_parameters().iter().zip([0.5, 0.0, -0.5]) {
//!     assert!((h - expected).abs() < 1e-13);
//! }
//! assert_eq!(found.rank, 3);
//! # Ok::<(), cfi_ident::FitError>(())
//! ```
//!
//! # Features
//!
//! - `regularized` (off by default): ridge, lasso, exponentially weighted and nuclear-norm fits by the conic solver Clarabel. Needs a
//!   system OpenBLAS.

mod accumulator;
mod error;
mod factor;
mod fit;
mod gram;
mod householder;
mod laurent;
mod model;
mod options;
mod orders;
mod predict;
mod regressors;
#[cfg(feature = "regularized")]
pub mod regularized;
mod segment;
mod solution;
mod triangle;

pub use accumulator::Accumulator;
pub use error::{FitError, Signal};
pub use fit::{Fit, Unidentifiable, fit};
pub use laurent::{Split, ZerosAndPoles};
pub use model::CfiModel;
pub use options::{Engine, FitOptions};
pub use orders::{ConstantTerm, Orders, Parameter, Structure};
pub use predict::{Predicted, Prediction};
pub use segment::Segment;
pub use solution::Refinement;
