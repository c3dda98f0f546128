//! What one run leaves behind: a line of JSON.

use serde::{Deserialize, Serialize};

use super::case::Case;
use crate::study::modes::PerMode;
use crate::study::runs::Kept;

/// What became of one flight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outcome {
    pub(crate) edition: u32,
    pub(crate) case: Case,
    /// Without the quiet record.
    pub(crate) alone: Both,
    /// With the quiet record.
    pub(crate) quiet: Both,
    /// Maximum likelihood with the quiet record, from the true system: what a perfect start would give.
    pub(crate) true_start: Option<Likelihood>,
    /// Maximum likelihood with the true spectrum, from the true system: what a quiet record without an end would give.
    pub(crate) true_spectrum: Option<Likelihood>,
    /// Errors of the regression that knows the controls.
    pub(crate) inputs_known: Option<PerMode>,
    /// The information bound for unknown controls and known spectrum: variance of each s, of real and imaginary part together.
    pub(crate) bound: PerMode,
    /// Lags of the autoregression fitted to the quiet record.
    pub(crate) lags: usize,
    /// How much lower the sum of squares of the fit with the quiet record is when the search starts from the true system.
    pub(crate) missed: Option<f64>,
}

/// What both methods make of the same records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Both {
    pub(crate) subspace: Option<Subspace>,
    pub(crate) likelihood: Option<Likelihood>,
}

/// What the intersection of signal subspaces gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Subspace {
    pub(crate) errors: PerMode,
    /// The kinds of doubts that the result carries, each once.
    pub(crate) doubts: Vec<String>,
}

/// What maximum likelihood gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Likelihood {
    pub(crate) errors: PerMode,
    /// Error over its own deviation: spiral, roll, Dutch roll's real part, its imaginary part; [`LOST`](crate::study::verdict::LOST) or more
    /// where there is no deviation.
    pub(crate) scores: [f64; 4],
    /// Whether the 95 % interval (of the Dutch roll: ellipse) holds the truth.
    pub(crate) covered: [bool; 3],
    /// Chi-squared per degree of freedom: under the spectrum that the fit used, or without one under the true levels of the sensors' noise.
    pub(crate) chi_squared: f64,
    pub(crate) converged: bool,
    /// The kinds of doubts that the result carries, each once.
    pub(crate) doubts: Vec<String>,
}

impl Kept for Outcome {
    type Case = Case;
    const EDITION: u32 = 1;

    fn edition(&self) -> u32 {
        self.edition
    }

    fn case(&self) -> Case {
        self.case
    }
}
