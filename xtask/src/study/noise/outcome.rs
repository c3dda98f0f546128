//! What one run leaves behind: a line of JSON.

use serde::{Deserialize, Serialize};

use super::case::Case;

/// Changes whenever the records or the methods change, so that no study mixes old and new runs.
pub(crate) const EDITION: u32 = 1;

/// Stands for an infinite score, which JSON does not know: a real eigenvalue has taken the Dutch roll's place, and its imaginary part has no
/// deviation.
pub(crate) const LOST: f64 = 1e100;

/// Spiral, roll, Dutch roll.
pub(crate) type PerMode = [f64; 3];

/// What became of one pair of records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outcome {
    pub(crate) edition: u32,
    pub(crate) case: Case,
    /// Errors |s - true s| in 1/s of the printed method; `None` where it gives nothing.
    pub(crate) as_printed: Option<PerMode>,
    /// The same of the intersection of signal subspaces.
    pub(crate) subspace: Option<PerMode>,
    /// The number of states that the subspaces show.
    pub(crate) order_found: Option<usize>,
    pub(crate) likelihood: Option<Likelihood>,
    /// The information bound: variance of each s, of real and imaginary part together.
    pub(crate) bound: PerMode,
}

/// What maximum likelihood gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Likelihood {
    pub(crate) errors: PerMode,
    /// Error over its own deviation: spiral, roll, Dutch roll's real part, its imaginary part; [`LOST`] or more where there is no deviation.
    pub(crate) scores: [f64; 4],
    /// Whether the 95 % interval (of the Dutch roll: ellipse) holds the truth.
    pub(crate) covered: [bool; 3],
    /// Chi-squared per degree of freedom under the true noise levels.
    pub(crate) chi_squared: f64,
    pub(crate) converged: bool,
}
