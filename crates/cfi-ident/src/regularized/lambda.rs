//! The weight of the penalty, given or to be chosen, and how well the candidates did.

use crate::FitError;

/// The weight of the penalty.
///
/// # Example
///
/// ```
/// use cfi_ident::regularized::Lambda;
///
/// // The last quarter of each segment decides between five decades.
/// let lambda = Lambda::HoldOut { candidates: vec![1e-5, 1e-4, 1e-3, 1e-2, 1e-1], fraction: 0.25 };
/// # let _ = lambda;
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Lambda {
    /// This value, at least 0.
    Given(f64),
    /// The candidate whose model predicts the held-out samples best, one step ahead. The fit is then repeated on all samples.
    ///
    /// With noise on both sensors the one-step prediction favours small weights: it rewards a model of the noise as well.
    HoldOut {
        /// Values to try, each at least 0.
        candidates: Vec<f64>,
        /// The share of each segment, taken from its end, that is held out: above 0 and below 1.
        fraction: f64,
    },
}

/// What one candidate reached.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct HoldOutScore {
    /// The candidate.
    pub lambda: f64,
    /// Root mean square of the one-step prediction error on the held-out samples, in the unit of the pseudo output; `None` where
    /// the solver failed.
    pub prediction_rms: Option<f64>,
}

impl Lambda {
    pub(crate) fn check(&self) -> Result<(), FitError> {
        let weight = |value: f64| {
            let needed = "finite and at least 0";
            let good = value.is_finite() && value >= 0.0;
            if good { Ok(()) } else { Err(FitError::BadValue { what: "lambda", value, needed }) }
        };
        match self {
            Self::Given(value) => weight(*value),
            Self::HoldOut { candidates, fraction } => {
                if !(*fraction > 0.0 && *fraction < 1.0) {
                    let what = "the held-out fraction";
                    return Err(FitError::BadValue {
                        what,
                        value: *fraction,
                        needed: "above 0 and below 1",
                    });
                }
                if candidates.is_empty() {
                    let what = "the number of candidates for lambda";
                    return Err(FitError::BadValue { what, value: 0.0, needed: "at least 1" });
                }
                candidates.iter().try_for_each(|value| weight(*value))
            }
        }
    }
}
