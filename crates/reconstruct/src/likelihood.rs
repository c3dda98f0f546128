//! Maximum likelihood for several records of one system, each under one unknown excitation.
//!
//! # The problem
//!
//! Record j = 1..J has m sensors. At each frequency of its discrete Fourier transform, z = exp(2 pi j k / N),
//!
//! Y_j = G_j U_j + z C (zI - A)^-1 t_j + V_j, G_j = C (zI - A)^-1 b_j + d_j,
//!
//! exactly: U_j is the transform of the excitation, free at every frequency; t_j holds the initial and the final state, x(0) - x(N); V_j is noise with
//! covariance S. With U_j at its best, what is left is the part of Y_j - z C (zI - A)^-1 t_j that no excitation explains, and the fit minimises
//!
//! sum over j and k of w e^H (S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g)) e, e = Y_j - z C (zI - A)^-1 t_j, g = G_j,
//!
//! with w = 2 inside and 1 at frequency zero and half the sampling frequency. Of the n^2 + m n + J n parameters in (A, C, b_j), n J + m n - J can be
//! identified: a change of basis and the scale of each b_j change nothing. d_j is free for sensors with feedthrough; where the excitation moves on
//! straight between samples, the other sensors' follows from A, C and b_j.
//!
//! | file | what it does |
//! |---|---|
//! | `spectrum.rs` | records to the frequency domain; offsets, trends, bands, known inputs |
//! | `direction.rs`, `resolvent.rs` | b_j from the spectra with A and C held |
//! | `feedback.rs`, `tables.rs`, `at_frequencies.rs`, `lanes.rs`, `sums.rs`, `evaluation.rs` | cost, gradient, Gram matrix; t_j eliminated |
//! | `hold.rs`, `holds.rs` | d_j of an excitation that moves between samples; which it is |
//! | `climb.rs`, `conclusion.rs` | from a start to the top, from the top to the result |
//! | `search.rs`, `thinning.rs`, `slow_modes.rs` | over all starts and tops to the highest one |
//! | `levenberg_marquardt.rs` | steps downhill |
//! | `noise_levels.rs` | noise levels by restricted likelihood |
//! | `uncertainty.rs`, `goodness.rs`, `offset_test.rs`, `gamma.rs` | covariances, intervals, chi-squared, whiteness, offsets |
//! | `profile.rs` | intervals of real modes from the likelihood itself |
//! | `bootstrap.rs`, `finished.rs` | deviations of modes from repeated noise; the problem of a fit that is finished |
//! | `spectral_fit.rs` | response, noise and residuals at each frequency |

mod at_frequencies;
mod bootstrap;
mod climb;
mod conclusion;
mod direction;
mod evaluation;
mod feedback;
mod finished;
#[cfg(test)]
pub(crate) mod fixtures;
mod gamma;
mod goodness;
mod held;
mod hold;
mod holds;
mod lanes;
mod levenberg_marquardt;
mod noise_levels;
mod offset_test;
mod options;
mod profile;
mod resolvent;
mod search;
mod slow_modes;
mod spectral_fit;
mod spectrum;
mod sums;
mod system;
mod tables;
mod thinning;
mod threads;
mod uncertainty;
mod validation;

use nalgebra::DMatrix;
use num_complex::Complex;
use realfft::RealFftPlanner;

pub use bootstrap::{Bootstrap, BootstrapMode, bootstrap};
pub use goodness::{ChiSquared, Whiteness};
pub use levenberg_marquardt::SearchStatus;
pub use offset_test::OffsetTest;
pub use options::{
    Directions, FrequencyBand, Hold, LikelihoodNoise, LikelihoodOptions, Offsets, Trend,
};
pub use profile::profile_intervals;
pub(crate) use spectral_fit::spectral_fit;
pub use spectral_fit::{SensorSpectrum, SpectralFit};
pub use uncertainty::{ComplexEstimate, Ellipse, Estimate, ModeEstimate};

use crate::{ReconstructError, Record, SharedModel};
use conclusion::conclude;
use evaluation::Problem;
use holds::search_over_holds;
use spectrum::transform;
pub(crate) use spectrum::{count, rms};
pub(crate) use validation::check_known_inputs;

/// What the likelihood says about several records.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LikelihoodFit {
    /// The system, in the sensors' units. In its basis the states of the records have unit second moments; each (b_j, d_j) has unit length, before
    /// sensors are scaled back.
    pub model: SharedModel,
    /// The covariance of A by columns, C by columns, then b_j and the free entries of d_j of each record. It is singular along changes of basis and of
    /// scale, which it leaves out.
    pub covariance: DMatrix<f64>,
    /// The modes with their uncertainty, by real part of the eigenvalue, a complex pair once.
    pub modes: Vec<ModeEstimate>,
    /// Indices of the sensors with an entry of d_j: those of the options under a zero-order hold, all under a first-order hold.
    pub feedthrough_sensors: Vec<usize>,
    /// How the excitation moves between samples: as in the options, or what is more likely.
    pub hold: Hold,
    /// Minus twice the logarithm of the other hold's likelihood over this one's, with 2 for each number of a record that one of them has more; at most 20
    /// where the excitation is held. `None` where the hold was given, or where the search for the other one did not arrive.
    pub hold_evidence: Option<f64>,
    /// Minus twice the logarithm of the likelihood, up to a constant of the records and of [`LikelihoodOptions::noise`], with 2 for each number that was fitted: Akaike's criterion, by
    /// which fits of several orders or under several holds compare.
    pub criterion: f64,
    /// Directions of the parameters that the records determine.
    pub determined: usize,
    /// Directions that can be identified where the records excite everything: n J + m n - J, and one more for each entry of d_j.
    pub identifiable: usize,
    /// Standard deviations of the noise in the sensors' units; `None` where the noise has a spectrum.
    pub noise_levels: Option<Vec<Estimate>>,
    /// The size of the residuals.
    pub chi_squared: ChiSquared,
    /// The same for each record alone: value per degree of freedom, parameters shared out by numbers of samples.
    pub record_chi_squared: Vec<f64>,
    /// Whether the residuals of each record are white.
    pub whiteness: Vec<Whiteness>,
    /// Whether the sensors read zero in trim; `None` where the options do not say that they do, or frequency zero is not used.
    pub offset_test: Option<OffsetTest>,
    /// How the search ended.
    pub search: SearchReport,
    /// Each start that was given, in the order given.
    pub starts: Vec<StartReport>,
    /// Index of the start that led here.
    pub best_start: usize,
    /// Rounds in which a slow mode, moved elsewhere, led higher than all starts.
    pub moves: usize,
    /// Other tops of the likelihood that are nearly as high.
    pub rivals: Vec<Rival>,
}

/// Another system that the records allow.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rival {
    /// Minus twice the logarithm of its likelihood over the best one's: 6 is a ratio of 1 to 20.
    pub above: f64,
    /// Its eigenvalues in rad/s, a complex pair once.
    pub eigenvalues: Vec<Complex<f64>>,
}

/// How a search went.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SearchReport {
    /// How it ended.
    pub status: SearchStatus,
    /// Steps that lowered the cost.
    pub steps: usize,
    /// Evaluations of the likelihood with its derivatives.
    pub evaluations: usize,
    /// Updates of the noise levels.
    pub level_updates: usize,
    /// Whether the noise levels settled; true where they were not estimated.
    pub levels_settled: bool,
    /// The length of the step that was not taken any more, in standard deviations of the estimate.
    pub remaining_step: f64,
}

/// Where one start led.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StartReport {
    /// The cost at the start, with its own directions.
    pub cost_at_start: f64,
    /// For each record, whether the direction that was estimated from the spectra fits better than the start's.
    pub direction_replaced: Vec<bool>,
    /// What was compared between the starts, with many frequencies on some of them: the cost, plus the logarithms of determinants where noise levels were estimated.
    pub objective: f64,
    /// How its search went; `None` where the start has no finite cost.
    pub search: Option<SearchReport>,
}

/// Fits one system to several records.
///
/// # Errors
///
/// Records that do not fit together; [`ReconstructError::TooFewRecords`] and [`ReconstructError::TooFewSensors`] below two of each;
/// [`ReconstructError::ConstantChannel`]; [`ReconstructError::Start`] and [`ReconstructError::Option`] for starts and options that do not fit the records;
/// [`ReconstructError::Noise`] for noise that is not one; [`ReconstructError::TooFewSamples`] where there are not more residuals than parameters.
///
/// # Example
///
/// x1 and x2 decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first record is excited through
/// b = (1, 1), the second through b = (1, 2).
///
/// ```
/// use lti::SamplePeriod;
/// use nalgebra::{DMatrix, DVector};
/// use reconstruct::{Channel, LikelihoodOptions, Record, SharedModel, maximise};
///
/// let mut state = 1_u32;
/// let mut uniform = || {
///     state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
///     f64::from(state) / 2_147_483_648.0 - 1.0
/// };
/// let mut record = |name: &str, b: [f64; 2]| {
///     let mut x = [0.0, 0.0];
///     let mut outputs = vec![Vec::new(); 3];
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
/// let records = [record("first", [1.0, 1.0])?, record("second", [1.0, 2.0])?];
/// // A start that is roughly right, and knows nothing of the directions.
/// let start = SharedModel {
///     a: DMatrix::from_row_slice(2, 2, &[0.88, 0.0, 0.0, 0.53]),
///     c: DMatrix::from_row_slice(3, 2, &[1.0, 1.1, 1.0, -0.9, 1.0, 3.0]),
///     b: vec![DVector::from_element(2, 1.0); 2],
///     feedthrough: None,
///     period: SamplePeriod::new(1.0)?,
/// };
/// let fit = maximise(&records, &[start], &LikelihoodOptions::default())?;
/// let slow = fit.modes[1].discrete;
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_deviation());
/// assert!(slow.real_deviation() < 1e-3);
/// let level = fit.noise_levels.unwrap()[0];
/// assert!((level.value - 0.01).abs() < 3.0 * level.deviation);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn maximise(
    records: &[Record],
    starts: &[SharedModel],
    options: &LikelihoodOptions,
) -> Result<LikelihoodFit, ReconstructError> {
    let layout = validation::check(records, starts, options)?;
    let units = noise_levels::units(records, options);
    let mut planner = RealFftPlanner::new();
    let spectra = records
        .iter()
        .enumerate()
        .map(|(index, record)| transform(record, index, &units, options, &mut planner))
        .collect::<Result<Vec<_>, _>>()?;
    let mut problem = Problem { layout, spectra, threads: options.threads };
    let residuals: f64 =
        problem.spectra.iter().map(|spectrum| spectrum.residuals(problem.layout.sensors)).sum();
    let needed = count(problem.layout.identifiable())
        + problem
            .no_coefficients()
            .iter()
            .flatten()
            .map(|_| count(problem.layout.order))
            .sum::<f64>();
    if residuals <= needed {
        // A sum of nothing is minus zero.
        return Err(ReconstructError::TooFewSamples {
            residuals: residuals + 0.0,
            parameters: needed,
        });
    }
    let found =
        search_over_holds(&mut problem, starts, &units, residuals, options).ok_or_else(|| {
            ReconstructError::Start {
                start: 0,
                message: "no start has a finite likelihood".to_owned(),
            }
        })?;
    conclude(records, &problem, found, &units, residuals, options)
}

#[cfg(test)]
mod tests;
