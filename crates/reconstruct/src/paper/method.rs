//! The paper's method: transmissibilities of several records, their differences, the zeros they share, continuous time.

use lti::{SamplePeriod, z_to_s};
use num_complex::Complex;

use super::difference::{Zero, difference_zeros};
use super::identification::{Identification, IdentificationOptions, identify_transmissibility};
use super::shared_zeros::{SharedZeros, shared_zeros};
use crate::error::check_tolerance;
use crate::model::record::{check_compatible, refuse_constant_channels};
use crate::{ReconstructError, Record};

/// How to carry out the paper's method.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// How each transmissibility is identified.
    pub identification: IdentificationOptions,
    /// Zeros of two differences within this distance in the z-plane count as one.
    ///
    /// The default, 1e-5, lies between what noise-free records give (the paper's aircraft: below 1e-9) and how close a zero of one
    /// difference alone comes to an eigenvalue by chance (the same aircraft: 1.6e-4).
    pub shared_tolerance: f64,
    /// A fit that leaves more than this part of the pseudo output unexplained raises [`Doubt::Noise`].
    ///
    /// The default, 1e-12, is above what rounding leaves (2e-14 for the paper's aircraft); noise of 1e-11 already moves its spiral by 1 %.
    pub noise_level: f64,
    /// Regressors with a larger condition number raise [`Doubt::IllConditioned`].
    ///
    /// The default is 1e9. The paper's fits have 2e6 at most; with 4e10 its spiral is off by 1 %.
    pub largest_condition: f64,
    /// Differences that disagree on an eigenvalue by more than this part of its modulus raise [`Doubt::Spread`]. The default is 1e-3.
    pub largest_relative_spread: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            identification: IdentificationOptions::default(),
            shared_tolerance: 1e-5,
            noise_level: 1e-12,
            largest_condition: 1e9,
            largest_relative_spread: 1e-3,
        }
    }
}

/// The difference of one transmissibility between two records.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Difference {
    /// Index of the first record.
    pub first: usize,
    /// Index of the second record.
    pub second: usize,
    /// Index of the pseudo output's channel.
    pub output: usize,
    /// Zeros of T_1 - T_2, that is the roots of det Delta, each with its condition number and residual.
    pub zeros: Vec<Zero>,
    /// Poles of T_1 - T_2: those of T_1 and those of T_2.
    pub poles: Vec<Complex<f64>>,
}

/// A reason not to trust a result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// No zero is shared by all differences: nothing was reconstructed.
    NoSharedZero,
    /// A fit leaves so much unexplained that the record carries noise, more than one excitation, or dynamics beyond the model.
    Noise {
        /// The record.
        record: String,
        /// The pseudo output.
        output: String,
        /// Norm of the residual over the norm of the pseudo output.
        relative_residual: f64,
        /// The level above which this is said.
        level: f64,
    },
    /// The noise leaves nothing of a transmissibility: no coefficient stands above the uncertainty of the fit.
    NothingAboveNoise {
        /// The record.
        record: String,
        /// The pseudo output.
        output: String,
    },
    /// The regressors do not determine all parameters of a model.
    RankDeficient {
        /// The record.
        record: String,
        /// The pseudo output.
        output: String,
        /// Rank found.
        rank: usize,
        /// Number of parameters.
        parameters: usize,
    },
    /// The regressors determine some parameters so poorly that rounding errors move the slow modes.
    IllConditioned {
        /// The record.
        record: String,
        /// The pseudo output.
        output: String,
        /// Condition number of the regressors.
        condition: f64,
        /// The number above which this is said.
        limit: f64,
    },
    /// The differences disagree on an eigenvalue.
    Spread {
        /// The eigenvalue in rad/s.
        eigenvalue: Complex<f64>,
        /// Largest distance of the differences' versions of it, over its modulus.
        relative: f64,
    },
}

impl Doubt {
    /// A short name for programs, which stays what it is; the program's documentation lists all of them.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NoSharedZero => "no-shared-zero",
            Self::Noise { .. } => "noise",
            Self::NothingAboveNoise { .. } => "nothing-above-noise",
            Self::RankDeficient { .. } => "rank-deficient",
            Self::IllConditioned { .. } => "ill-conditioned",
            Self::Spread { .. } => "spread",
        }
    }
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoSharedZero => f.write_str(
                "the differences share no zero, so nothing can be said about the eigenvalues: \
                 the records are noisy, or their excitations enter the system in the same way",
            ),
            Self::Noise { record, output, relative_residual, level } => write!(
                f,
                "record {record}, sensor {output}: the fit leaves {relative_residual:.1e} of the signal unexplained, more than \
                 {level:.0e}: with noise of that size the printed method misplaces or loses modes"
            ),
            Self::NothingAboveNoise { record, output } => write!(
                f,
                "record {record}, sensor {output}: no part of the transmissibility stands above the noise of the fit"
            ),
            Self::RankDeficient { record, output, rank, parameters } => write!(
                f,
                "record {record}, sensor {output}: the data determine {rank} of the model's {parameters} parameters; \
                 fewer poles in the IIR factor would do, or the excitation is poor"
            ),
            Self::IllConditioned { record, output, condition, limit } => write!(
                f,
                "record {record}, sensor {output}: the fit has condition number {condition:.0e}, above {limit:.0e}, so that rounding errors \
                 move the slow modes; another pseudo input or a shorter FIR factor may help"
            ),
            Self::Spread { eigenvalue, relative } => write!(
                f,
                "the sensors disagree on the eigenvalue {:.4} {} j{:.4} by {:.1} % of its size",
                eigenvalue.re,
                if eigenvalue.im < 0.0 { '-' } else { '+' },
                eigenvalue.im.abs(),
                100.0 * relative
            ),
        }
    }
}

/// An eigenvalue, and what the mode looks like in the sensors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// log(z)/T in rad/s, for the shared zero z.
    pub eigenvalue: Complex<f64>,
    /// Index of the shared zero in [`Solution::shared`].
    pub shared: usize,
    /// The mode's share in each channel, relative to the pseudo input: 1, then T(z) for each pseudo output. At an eigenvalue all excitations
    /// leave the same trace, so any record could tell; the one whose T(z) is determined best does.
    pub shape: Vec<Complex<f64>>,
}

/// What the paper's method makes of several records.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Solution {
    /// One transmissibility for each record and pseudo output, by record, then by output.
    pub identifications: Vec<Identification>,
    /// One difference for each pair of records and pseudo output, by pair, then by output.
    pub differences: Vec<Difference>,
    /// The zeros that all differences share: the eigenvalues of the sampled system.
    pub shared: SharedZeros,
    /// The eigenvalues of the system with their shapes, one for each shared zero that is not [`unobservable_zeros`](Solution::unobservable_zeros), in their order.
    pub modes: Vec<Mode>,
    /// Shared zeros that every transmissibility has as a pole: there the pseudo input reads nothing in any record, so the determinant vanishes
    /// whether or not the system has an eigenvalue. They are no modes. The root of D at 0 is one where it does not cancel.
    pub unobservable_zeros: Vec<Complex<f64>>,
    /// The sample period of the records.
    pub period: SamplePeriod,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<Doubt>,
}

/// Reconstructs the eigenvalues of a system from two or more records by the paper's method.
///
/// Channel 0 of each record is the pseudo input, every other channel a pseudo output. Each pair of records gives one difference of
/// transmissibilities for each pseudo output; the eigenvalues are the zeros that all differences share (Theorem 3.1; part VI).
///
/// The method is meant for records without noise. What it finds in others is reported with [`Doubt`]s.
///
/// # Errors
///
/// [`ReconstructError::TooFewRecords`], [`ReconstructError::TooFewSensors`], records that do not fit together, and what [`identify_transmissibility`] refuses.
/// [`ReconstructError::SameExcitation`] where two records give equal transmissibilities.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../doctest/two_decays.md")]
/// use cfi_ident::Orders;
/// use reconstruct::paper::{Options, identify};
///
/// let records = two_decays(0.9, 400, 0.0)?;
/// // The transmissibilities have one pole, so that D(q) = q^2 + c_1 q is enough.
/// let mut options = Options::default();
/// options.identification.structure.orders = Orders::new(2, 25, 25)?;
/// let result = identify(&records, &options)?;
/// assert_eq!(result.modes.len(), 2);
/// assert!((result.modes[0].eigenvalue.re - 0.9_f64.ln()).abs() < 1e-9);
/// assert!((result.modes[1].eigenvalue.re - 0.5_f64.ln()).abs() < 1e-9);
/// // The second mode, x2 alone, shows as 1 : -1 : 3 in the sensors.
/// assert!((result.modes[1].shape[2] - 3.0).norm() < 1e-6);
/// assert!(result.doubts.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify(records: &[Record], options: &Options) -> Result<Solution, ReconstructError> {
    check_tolerance("the tolerance of shared zeros", options.shared_tolerance)?;
    check_tolerance("the level of noise", options.noise_level)?;
    check_tolerance("the largest condition number", options.largest_condition)?;
    check_tolerance("the largest relative spread", options.largest_relative_spread)?;
    let [first, _, ..] = records else {
        return Err(ReconstructError::TooFewRecords { found: records.len(), needed: 2 });
    };
    check_compatible(records)?;
    let sensors = first.channels().len();
    if sensors < 3 {
        return Err(ReconstructError::TooFewSensors { found: sensors, needed: 3 });
    }

    refuse_constant_channels(records)?;
    let identifications = records
        .iter()
        .flat_map(|record| (1..sensors).map(move |output| (record, output)))
        .map(|(record, output)| {
            identify_transmissibility(record, 0, output, &options.identification)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let identified =
        |record: usize, output: usize| &identifications[record * (sensors - 1) + output - 1];
    let differences = (0..records.len())
        .flat_map(|first| (first + 1..records.len()).map(move |second| (first, second)))
        .flat_map(|pair| (1..sensors).map(move |output| (pair, output)))
        .map(|((first, second), output)| {
            let pair = [identified(first, output), identified(second, output)];
            // A transmissibility of which the noise leaves nothing has no zeros to compare; the doubts say so.
            let zeros = if pair.iter().any(|found| found.transmissibility.numerator().is_zero()) {
                Vec::new()
            } else {
                difference_zeros(pair[0], pair[1])?
            };
            let poles = pair.iter().flat_map(|found| found.poles.iter().copied()).collect();
            Ok(Difference { first, second, output, zeros, poles })
        })
        .collect::<Result<Vec<_>, ReconstructError>>()?;

    let lists: Vec<_> = differences.iter().map(|difference| difference.zeros.clone()).collect();
    let shared = shared_zeros(&lists, options.shared_tolerance)?;
    let period = first.period();
    let (mut modes, mut unobservable_zeros) = (Vec::new(), Vec::new());
    for (index, zero) in shared.values().into_iter().enumerate() {
        // Only 0 has no logarithm, and it is a root of every D.
        match z_to_s(zero, period) {
            Ok(eigenvalue)
                if !is_unobservable(zero, &identifications, options.shared_tolerance) =>
            {
                let shape = mode_shape(zero, &identifications, sensors);
                modes.push(Mode { eigenvalue, shared: index, shape });
            }
            _ => unobservable_zeros.push(zero),
        }
    }
    let mut doubts = doubts_of_fits(&identifications, options);
    if modes.is_empty() {
        doubts.insert(0, Doubt::NoSharedZero);
    }
    doubts.extend(modes.iter().filter_map(|mode| spread_doubt(mode, &shared, period, options)));
    Ok(Solution { identifications, differences, shared, modes, unobservable_zeros, period, doubts })
}

/// 1 and T(z) for each pseudo output, from the record whose denominators are farthest from zero at z.
fn mode_shape(
    zero: Complex<f64>,
    identifications: &[Identification],
    sensors: usize,
) -> Vec<Complex<f64>> {
    let in_channel = |output: usize| {
        let candidates = identifications.iter().skip(output - 1).step_by(sensors - 1);
        let distance = |found: &&Identification| {
            found.poles.iter().map(|pole| (pole - zero).norm()).fold(f64::INFINITY, f64::min)
        };
        candidates
            .max_by(|a, b| distance(a).total_cmp(&distance(b)))
            .map_or(Complex::new(f64::NAN, 0.0), |found| {
                found.transmissibility.to_rational().eval_complex(zero)
            })
    };
    std::iter::once(Complex::new(1.0, 0.0)).chain((1..sensors).map(in_channel)).collect()
}

/// Whether every transmissibility has a pole there.
fn is_unobservable(zero: Complex<f64>, identifications: &[Identification], tolerance: f64) -> bool {
    identifications
        .iter()
        .all(|found| found.poles.iter().any(|pole| (pole - zero).norm() <= tolerance))
}

fn doubts_of_fits(identifications: &[Identification], options: &Options) -> Vec<Doubt> {
    identifications.iter().filter_map(|found| doubt_of_fit(found, options)).collect()
}

/// The gravest doubt that one fit raises.
fn doubt_of_fit(found: &Identification, options: &Options) -> Option<Doubt> {
    let fit = &found.fit;
    let (record, output) = (found.record.clone(), found.output.clone());
    let parameters = fit.model.structure().parameter_count();
    if fit.relative_residual > options.noise_level {
        let (relative_residual, level) = (fit.relative_residual, options.noise_level);
        Some(Doubt::Noise { record, output, relative_residual, level })
    } else if found.transmissibility.numerator().is_zero() {
        Some(Doubt::NothingAboveNoise { record, output })
    } else if fit.rank < parameters {
        Some(Doubt::RankDeficient { record, output, rank: fit.rank, parameters })
    } else if fit.condition > options.largest_condition {
        let (condition, limit) = (fit.condition, options.largest_condition);
        Some(Doubt::IllConditioned { record, output, condition, limit })
    } else {
        None
    }
}

/// How far the differences disagree on an eigenvalue: a distance d in the z-plane is d / (|z| T) in the s-plane, to first order.
fn spread_doubt(
    mode: &Mode,
    shared: &SharedZeros,
    period: SamplePeriod,
    options: &Options,
) -> Option<Doubt> {
    let zero = &shared.zeros[mode.shared];
    let distance = zero.spread / (zero.value.norm() * period.seconds());
    let relative = distance / mode.eigenvalue.norm();
    let doubtful =
        distance > 0.0 && relative > options.largest_relative_spread && mode.eigenvalue.im >= 0.0;
    doubtful.then_some(Doubt::Spread { eigenvalue: mode.eigenvalue, relative })
}

#[cfg(test)]
mod tests;
