//! The records' spectra beside those of the reconstructed system.

use super::options::Options;
use super::result::Reconstruction;
use crate::likelihood::{SpectralFit, spectral_fit};
use crate::{ReconstructError, Record};

/// The spectrum of every record beside what a reconstruction makes of it: the response to the excitation's estimate, the noise, and the residuals.
///
/// Records and options are those of the reconstruction. The list is empty for the paper's method, which has no model of all sensors.
///
/// # Errors
///
/// [`ReconstructError::Step`] where an eigenvalue lies on a frequency of a record exactly; those of [`reconstruct`](crate::reconstruct) where records or options are
/// others.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../doctest/two_decays.md")]
/// use reconstruct::{Options, reconstruct, spectral_fits};
///
/// let (records, options) = (two_decays(0.9, 500, 0.01)?, Options::default());
/// let found = reconstruct(&records, &options)?;
/// // What is left over is as large as the noise.
/// let first = &spectral_fits(&records, &options, &found)?[0];
/// assert_eq!(first.residuals.len(), 251);
/// assert!((first.residuals.iter().sum::<f64>() / 251.0 - 1.0).abs() < 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn spectral_fits(
    records: &[Record],
    options: &Options,
    found: &Reconstruction,
) -> Result<Vec<SpectralFit>, ReconstructError> {
    let options = &options.with_unrecorded_excitation();
    let (Some(model), Some(first)) = (found.model(), found.intersection()) else {
        return Ok(Vec::new());
    };
    let levels: Vec<f64> = found.noise_levels().iter().flatten().map(|level| level.value).collect();
    // Under a first-order hold every sensor has an entry of d_j.
    let feedthrough = &options.measurement.feedthrough_sensors;
    let direct = found.fit().map_or(feedthrough, |fit| &fit.feedthrough_sensors);
    let model_error = found.fit().and_then(|fit| fit.model_error).map(|error| error.value);
    let options = match found.fit() {
        Some(fit) => &fit.options,
        None => &options.likelihood(records, first)?,
    };
    spectral_fit(records, model, &levels, model_error, direct, options)
}
