//! What one run leaves behind: a line of JSON.

use serde::{Deserialize, Serialize};

use super::case::Case;
use crate::study::modes::PerMode;
use crate::study::runs::Kept;

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

impl Kept for Outcome {
    type Case = Case;
    const EDITION: u32 = 3;

    fn edition(&self) -> u32 {
        self.edition
    }

    fn case(&self) -> Case {
        self.case
    }
}

/// What maximum likelihood gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Likelihood {
    pub(crate) errors: PerMode,
    /// Error over its own deviation: spiral, roll, Dutch roll's real part, its imaginary part; [`LOST`](crate::study::verdict::LOST) or more where there is no deviation.
    pub(crate) scores: [f64; 4],
    /// Whether the 95 % interval (of the Dutch roll: ellipse) holds the truth.
    pub(crate) covered: [bool; 3],
    /// Chi-squared per degree of freedom under the true noise levels.
    pub(crate) chi_squared: f64,
    pub(crate) converged: bool,
    /// Whether a search from the true system ended at a higher likelihood.
    pub(crate) missed: bool,
}
