//! Whether what a fit with white noise leaves over follows the signal: a score test of no relative model error.

use super::fit::Fit;
use super::refit::{Refit, refit_with};
use crate::likelihood::options::{Noise, Options};
use crate::{ReconstructError, Record};

/// What the residuals of a fit with white noise say about a relative model error.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ModelErrorTest {
    /// The score of eps^2 at zero over its standard deviation, noise levels eliminated: standard normal if the noise is white, large and
    /// positive where the residuals are larger at frequencies where the sensors read more.
    pub statistic: f64,
    /// What one scoring step makes of eps^2: negative where the residuals are smaller there.
    pub variance: f64,
}

/// Tests whether white noise is all that a fit leaves over, without another fit: one evaluation with the sensors' smoothed periodograms.
///
/// # Errors
///
/// Those of [`identify`](crate::likelihood::identify) for records and options, and [`ReconstructError::Option`] for a fit whose noise is not white.
pub fn model_error_test(records: &[Record], fit: &Fit) -> Result<ModelErrorTest, ReconstructError> {
    let white = fit.noise_levels.as_ref().filter(|_| fit.model_error.is_none());
    let Some(levels) = white else {
        return Err(ReconstructError::Option {
            name: "noise",
            message: "the noise of this fit is not white".to_owned(),
        });
    };
    let levels = levels.iter().map(|level| level.value).collect();
    let noise = Noise::ModelError { first_guess: Some(levels) };
    let options = Options { noise, ..fit.options.clone() };
    let Refit { evaluation: at, units, .. } = refit_with(records, fit, &options, Some(0.0))?;
    let own = units.len();
    // The part of eps^2 that the levels cannot take over.
    let among = at.information.view((0, 0), (own, own)).into_owned();
    let mixed = at.information.view((0, own), (own, 1)).into_owned();
    let share = among.lu().solve(&mixed).unwrap_or_else(|| mixed.map(|_| 0.0));
    let information = at.information[(own, own)] - mixed.dot(&share);
    let score = at.score[own] - share.dot(&at.score.rows(0, own));
    // Cost and information count each frequency twice.
    Ok(ModelErrorTest {
        statistic: score / (2.0 * information).sqrt(),
        variance: score / information,
    })
}

#[cfg(test)]
mod tests;
