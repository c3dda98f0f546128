//! Least-squares identification of noncausal composite FIR/IIR models.

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
