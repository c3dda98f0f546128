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
//! | identify, and see how far to trust it | [`fit`], [`Fit`] |
//! | use the model | [`CfiModel`], [`Prediction`] |
//! | make the model of a known transmissibility | [`ZerosAndPoles`] |
//! | penalise the impulse response (feature `regularized`) | `regularized::fit` |
//!
//! # Numerics
//!
//! The N x p regressors are never stored. Blocks of rows are folded by Householder reflections into one (p + 1) x (p + 1) triangle; its columns
//! are scaled to norm one, its singular values give rank and condition, and the solution is refined against the data with the residual in
//! doubled precision. Where data obey the model to rounding, the result is the exact least-squares solution, rounded. The channels are scaled by powers
//! of two first, so that units do not matter.
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

mod doubled;
mod error;
mod factor;
mod fit;
mod laurent;
mod model;
mod orders;
mod predict;
mod refine;
mod regressors;
#[cfg(feature = "regularized")]
pub mod regularized;
mod segment;
mod triangle;

pub use error::{FitError, Signal};
pub use fit::{Fit, FitOptions, Unidentifiable, fit};
pub use laurent::{Split, ZerosAndPoles};
pub use model::CfiModel;
pub use orders::{ConstantTerm, Orders, Parameter, Structure};
pub use predict::{Predicted, Prediction};
pub use refine::Refinement;
pub use segment::Segment;
