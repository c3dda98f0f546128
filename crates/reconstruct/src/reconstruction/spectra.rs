//! The records' spectra beside those of the reconstructed system.

use super::{Options, Reconstruction};
use crate::likelihood::spectral_fit;
use crate::{ReconstructError, Record, SpectralFit};

/// The spectrum of every record beside what a reconstruction makes of it: the response to the excitation's estimate, the noise, and the residuals.
///
/// Records and options are those of the reconstruction. The list is empty for the printed method, which has no model of all sensors.
///
/// # Errors
///
/// [`ReconstructError::Step`] where an eigenvalue lies on a frequency of a record exactly; those of [`reconstruct`](crate::reconstruct) where records or options are
/// others.
///
/// # Example
///
/// Three sensors read 1, 2 and 3 times a state that decays by 0.8 a step, with noise of 0.01; what is left over is as large as the noise.
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::{Channel, Options, Record, reconstruct, spectral_fits};
///
/// let mut state = 1_u32;
/// let mut uniform = || {
///     state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
///     f64::from(state) / 2_147_483_648.0 - 1.0
/// };
/// let mut record = |name: &str, b: [f64; 2]| {
///     let (mut x, mut outputs) = ([0.0, 0.0], vec![Vec::new(); 3]);
///     for _ in 0..500 {
///         let [x1, x2] = x;
///         for (output, value) in outputs.iter_mut().zip([x1 + x2, x1 - x2, x1 + 3.0 * x2]) {
///             output.push(value + 0.01 * 3.0_f64.sqrt() * uniform());
///         }
///         let u = uniform();
///         x = [0.9 * x1 + b[0] * u, 0.5 * x2 + b[1] * u];
///     }
///     let channels = outputs.into_iter().zip(["y1", "y2", "y3"]).map(|(values, name)| Channel::new(name, values));
///     Record::new(name, SamplePeriod::new(1.0)?, channels.collect()).map_err(Box::<dyn std::error::Error>::from)
/// };
/// let (records, options) = ([record("first", [1.0, 1.0])?, record("second", [1.0, 2.0])?], Options::default());
/// let found = reconstruct(&records, &options)?;
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
    let (Some(model), Some(first)) = (&found.model, &found.intersection) else {
        return Ok(Vec::new());
    };
    let levels: Vec<f64> = found.noise_levels.iter().flatten().map(|level| level.value).collect();
    // Under a first-order hold all sensors do.
    let fit = found.likelihood.as_ref();
    let direct = fit.map_or(&options.feedthrough_sensors, |fit| &fit.feedthrough_sensors);
    spectral_fit(records, model, &levels, direct, &options.likelihood(records, first)?)
}
