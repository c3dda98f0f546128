//! The printed method: transmissibilities of several records, their differences, the zeros they share, continuous time.

use lti::{SamplePeriod, z_to_s};
use num_complex::Complex;

use crate::error::check_tolerance;
use crate::record::check_compatible;
use crate::{
    Identification, IdentificationOptions, ReconstructError, Record, SharedZeros, Zero,
    difference_zeros, identify, shared_zeros,
};

/// How to carry out the printed method.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct AsPrintedOptions {
    /// How each transmissibility is identified.
    pub identification: IdentificationOptions,
    /// Zeros of two differences within this distance in the z-plane count as one.
    ///
    /// The default, 1e-5, lies between what noise-free records give (the paper's aircraft: below 1e-9) and how close a zero of one
    /// difference alone comes to an eigenvalue by chance (the same aircraft: 1.6e-4).
    pub shared_tolerance: f64,
    /// A fit that leaves more than this part of the pseudo output unexplained raises [`Doubt::Noise`].
    ///
    /// The default, 1e-8, is far above rounding errors, and where sensor noise begins to move the slow modes.
    pub noise_level: f64,
}

impl Default for AsPrintedOptions {
    fn default() -> Self {
        Self {
            identification: IdentificationOptions::default(),
            shared_tolerance: 1e-5,
            noise_level: 1e-8,
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
    /// A shared zero at 0 or beyond: it has no counterpart in continuous time and was left out of the eigenvalues.
    NoContinuousCounterpart {
        /// The zero.
        zero: Complex<f64>,
    },
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
            Self::NoContinuousCounterpart { zero } => {
                write!(
                    f,
                    "the shared zero {zero:.4} has no counterpart in continuous time and was left out"
                )
            }
        }
    }
}

/// An eigenvalue, and what the mode looks like in the sensors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReconstructedMode {
    /// log(z)/T in rad/s, for the shared zero z.
    pub eigenvalue: Complex<f64>,
    /// Index of the shared zero in [`AsPrinted::shared`].
    pub shared: usize,
    /// The mode's share in each channel, relative to the pseudo input: 1, then T(z) for each pseudo output. At an eigenvalue all excitations
    /// leave the same trace, so any record could tell; the one whose T(z) is determined best does.
    pub shape: Vec<Complex<f64>>,
}

/// What the printed method makes of several records.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AsPrinted {
    /// One transmissibility for each record and pseudo output, by record, then by output.
    pub identifications: Vec<Identification>,
    /// One difference for each pair of records and pseudo output, by pair, then by output.
    pub differences: Vec<Difference>,
    /// The zeros that all differences share: the eigenvalues of the sampled system.
    pub shared: SharedZeros,
    /// The eigenvalues of the system with their shapes, one for each shared zero that has a counterpart in continuous time, in their order.
    pub modes: Vec<ReconstructedMode>,
    /// The sample period of the records.
    pub period: SamplePeriod,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<Doubt>,
}

/// Reconstructs the eigenvalues of a system from two or more records by the printed method.
///
/// Channel 0 of each record is the pseudo input, every other channel a pseudo output. Each pair of records gives one difference of
/// transmissibilities for each pseudo output; the eigenvalues are the zeros that all differences share (Theorem 3.1; part VI).
///
/// The method is meant for records without noise. What it finds in others is reported with [`Doubt`]s.
///
/// # Errors
///
/// [`ReconstructError::TooFewRecords`], [`ReconstructError::TooFewSensors`], records that do not fit together, and what [`identify`] refuses.
/// [`ReconstructError::SameExcitation`] where two records give equal transmissibilities.
///
/// # Example
///
/// x1' and x2' decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2. The first record is excited through
/// b = (1, 1), the second through b = (1, 2).
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::{AsPrintedOptions, Channel, Record, as_printed};
///
/// let record = |name: &str, b: [f64; 2], seed: u32| {
///     let (mut x, mut noise) = ([0.0, 0.0], seed);
///     let mut outputs = vec![Vec::new(); 3];
///     for _ in 0..400 {
///         let [x1, x2] = x;
///         for (output, value) in outputs.iter_mut().zip([x1 + x2, x1 - x2, x1 + 3.0 * x2]) {
///             output.push(value);
///         }
///         noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
///         let u = f64::from(noise) / 4e9 - 0.5;
///         x = [0.9 * x1 + b[0] * u, 0.5 * x2 + b[1] * u];
///     }
///     let channels = outputs.into_iter().zip(["y1", "y2", "y3"]).map(|(values, name)| Channel::new(name, values));
///     Record::new(name, SamplePeriod::new(1.0)?, channels.collect()).map_err(Box::<dyn std::error::Error>::from)
/// };
/// let records = [record("first", [1.0, 1.0], 1)?, record("second", [1.0, 2.0], 2)?];
/// let result = as_printed(&records, &AsPrintedOptions::default())?;
/// assert_eq!(result.modes.len(), 2);
/// assert!((result.modes[0].eigenvalue.re - 0.9_f64.ln()).abs() < 1e-9);
/// assert!((result.modes[1].eigenvalue.re - 0.5_f64.ln()).abs() < 1e-9);
/// // The second mode, x2 alone, shows as 1 : -1 : 3 in the sensors.
/// assert!((result.modes[1].shape[2] - 3.0).norm() < 1e-6);
/// assert!(result.doubts.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn as_printed(
    records: &[Record],
    options: &AsPrintedOptions,
) -> Result<AsPrinted, ReconstructError> {
    check_tolerance("the tolerance of shared zeros", options.shared_tolerance)?;
    check_tolerance("the level of noise", options.noise_level)?;
    let [first, _, ..] = records else {
        return Err(ReconstructError::TooFewRecords { found: records.len(), needed: 2 });
    };
    check_compatible(records)?;
    let sensors = first.channels().len();
    if sensors < 3 {
        return Err(ReconstructError::TooFewSensors { found: sensors, needed: 3 });
    }

    let identifications = records
        .iter()
        .flat_map(|record| (1..sensors).map(move |output| (record, output)))
        .map(|(record, output)| identify(record, 0, output, &options.identification))
        .collect::<Result<Vec<_>, _>>()?;
    let identified =
        |record: usize, output: usize| &identifications[record * (sensors - 1) + output - 1];
    let differences = (0..records.len())
        .flat_map(|first| (first + 1..records.len()).map(move |second| (first, second)))
        .flat_map(|pair| (1..sensors).map(move |output| (pair, output)))
        .map(|((first, second), output)| {
            let pair = [identified(first, output), identified(second, output)];
            let zeros = difference_zeros(pair[0], pair[1])?;
            let poles = pair.iter().flat_map(|found| found.poles.iter().copied()).collect();
            Ok(Difference { first, second, output, zeros, poles })
        })
        .collect::<Result<Vec<_>, ReconstructError>>()?;

    let lists: Vec<_> = differences.iter().map(|difference| difference.zeros.clone()).collect();
    let shared = shared_zeros(&lists, options.shared_tolerance)?;
    let mut doubts = doubts(&identifications, options.noise_level);
    let mut modes = Vec::new();
    for (index, zero) in shared.values().into_iter().enumerate() {
        match z_to_s(zero, first.period()) {
            Ok(eigenvalue) => {
                let shape = mode_shape(zero, &identifications, sensors);
                modes.push(ReconstructedMode { eigenvalue, shared: index, shape });
            }
            Err(_) => doubts.push(Doubt::NoContinuousCounterpart { zero }),
        }
    }
    if shared.zeros.is_empty() {
        doubts.insert(0, Doubt::NoSharedZero);
    }
    Ok(AsPrinted { identifications, differences, shared, modes, period: first.period(), doubts })
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

fn doubts(identifications: &[Identification], level: f64) -> Vec<Doubt> {
    identifications
        .iter()
        .filter(|found| found.fit.relative_residual > level)
        .map(|found| Doubt::Noise {
            record: found.record.clone(),
            output: found.output.clone(),
            relative_residual: found.fit.relative_residual,
            level,
        })
        .collect()
}

#[cfg(test)]
mod tests;
