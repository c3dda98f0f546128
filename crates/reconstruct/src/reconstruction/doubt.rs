//! Why a reconstruction should not be trusted: what the stages doubt themselves, and what shows only when their answers are compared.

use num_complex::Complex;

use crate::{
    Doubt, Intersection, LikelihoodFit, ModeEstimate, NoiseModel, NoiseOrigin, Record,
    SearchStatus, SubspaceDoubt,
};

/// A reason to doubt a [`Reconstruction`](crate::Reconstruction). Each can be printed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ReconstructionDoubt {
    /// A doubt of the printed method.
    Printed(Doubt),
    /// A doubt of the intersection of signal subspaces.
    Subspace(SubspaceDoubt),
    /// The search for the largest likelihood did not arrive.
    OptimumNotReached {
        /// How it ended.
        status: SearchStatus,
        /// The length of the step that was left, in standard deviations of the estimate.
        remaining_step: f64,
    },
    /// The noise levels of the likelihood did not settle.
    LevelsNotSettled {
        /// The updates made.
        updates: usize,
    },
    /// With the noise that was given, the residuals are larger or smaller than chance makes them.
    PoorFit {
        /// Chi-squared per degree of freedom; 1 is expected.
        per_degree_of_freedom: f64,
        /// The probability of a value as far from 1 on this side.
        probability: f64,
    },
    /// A record fits worse than the others, by more than chance.
    UnequalFit {
        /// The record.
        record: String,
        /// Its chi-squared per degree of freedom; 1 is expected.
        per_degree_of_freedom: f64,
        /// The distance from 1 in standard deviations.
        deviations: f64,
    },
    /// The residuals of a record are not white.
    ResidualsNotWhite {
        /// The record.
        record: String,
        /// The probability of autocorrelations as large, if they were white.
        p_value: f64,
    },
    /// Frequency zero does not agree with the others: some sensor does not read zero in trim.
    Offset {
        /// The probability of a disagreement as large, if all did.
        p_value: f64,
    },
    /// The likelihood needs far more noise of a sensor than the signal subspaces show.
    LevelsDisagree {
        /// The sensor.
        sensor: String,
        /// Its noise level from the signal subspaces, in its unit.
        subspace: f64,
        /// Its noise level from the likelihood.
        likelihood: f64,
    },
    /// Another system explains the records nearly as well.
    AnotherSystem {
        /// How many times as likely the one that was found is.
        likelihood_ratio: f64,
        /// The other one's eigenvalues in 1/s, a complex pair once.
        eigenvalues: Vec<Complex<f64>>,
    },
    /// Records so short that deviations and intervals, which hold to first order, mean little.
    TooShort {
        /// Residuals less parameters.
        degrees_of_freedom: f64,
        /// Parameters of the system.
        parameters: usize,
    },
    /// The records do not determine all parameters that can be identified.
    Undetermined {
        /// Directions that they determine.
        determined: usize,
        /// Directions that can be identified where the records excite everything.
        identifiable: usize,
    },
}

impl std::fmt::Display for ReconstructionDoubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Printed(doubt) => doubt.fmt(f),
            Self::Subspace(doubt) => doubt.fmt(f),
            Self::OptimumNotReached { status, remaining_step } => write!(
                f,
                "the search for the largest likelihood ended early, {}{}",
                match status {
                    SearchStatus::StepLimit => "after as many steps as it may take",
                    _ => "without a step that leads lower",
                },
                if remaining_step.is_finite() {
                    format!(", {remaining_step:.1e} standard deviations from where it was going")
                } else {
                    String::new()
                }
            ),
            Self::LevelsNotSettled { updates } => {
                write!(f, "the noise levels did not settle in {updates} updates")
            }
            Self::PoorFit { per_degree_of_freedom, probability } => write!(
                f,
                "chi-squared per degree of freedom is {per_degree_of_freedom:.3} instead of 1, which has {}: the noise is not \
                 what was given, or a record holds more than one excitation",
                chance(*probability)
            ),
            Self::UnequalFit { record, per_degree_of_freedom, deviations } => write!(
                f,
                "record {record}: chi-squared per degree of freedom is {per_degree_of_freedom:.3}, {deviations:.0} standard deviations more than in \
                 the others: more than one excitation, or more noise"
            ),
            Self::ResidualsNotWhite { record, p_value } => write!(
                f,
                "record {record}: the residuals are not white ({}): more than one excitation, disturbances, or too low an order",
                chance(*p_value)
            ),
            Self::Offset { p_value } => write!(
                f,
                "a sensor does not read zero in trim ({} if all did), which pushes the slow modes: take offsets into account, or the \
                 trim values out of the records",
                chance(*p_value)
            ),
            Self::LevelsDisagree { sensor, subspace, likelihood } => write!(
                f,
                "sensor {sensor}: one excitation for each record leaves noise of {likelihood:.2e}, the signal subspaces show {subspace:.2e}: \
                 more than one excitation in a record, or too low an order"
            ),
            Self::AnotherSystem { likelihood_ratio, eigenvalues } => {
                let list: Vec<_> = eigenvalues.iter().map(|s| eigenvalue(*s)).collect();
                write!(
                    f,
                    "another system explains the records nearly as well (the one found is {likelihood_ratio:.1} times as likely): its eigenvalues are {} 1/s; longer \
                     records or less noise tell them apart",
                    list.join(", ")
                )
            }
            Self::TooShort { degrees_of_freedom, parameters } => write!(
                f,
                "the records are short: {degrees_of_freedom:.0} degrees of freedom for {parameters} parameters, so that intervals mean little"
            ),
            Self::Undetermined { determined, identifiable } => write!(
                f,
                "the records determine {determined} of {identifiable} parameters: a mode is not excited, or two excitations are alike"
            ),
        }
    }
}

/// `probability 3e-5`, or a bound of those that are too small for a number.
fn chance(probability: f64) -> String {
    const SMALLEST: f64 = 1e-300;
    if probability < SMALLEST {
        format!("probability below {SMALLEST:.0e}")
    } else {
        format!("probability {probability:.0e}")
    }
}

/// `-0.1 + 1.7j`, or the real part alone; the imaginary part of a pair is the positive one.
fn eigenvalue(s: Complex<f64>) -> String {
    if s.im > 0.0 { format!("{:.4} + {:.4}j", s.re, s.im) } else { format!("{:.4}", s.re) }
}

/// What happens to one record in ten thousand by chance is not doubted.
const IMPROBABLE: f64 = 1e-4;

/// A record whose residuals are so many standard deviations too large is doubted: levels that are common to all make the fits of the records
/// compete, and the residuals are only nearly chi-squared.
const FAR_FROM_ONE: f64 = 6.0;

/// Levels of both stages differ by less: the first stage's come out up to 20 % low in short records.
const LEVEL_RATIO: f64 = 1.5;

/// Residuals wanted for each parameter.
const RESIDUALS_PER_PARAMETER: f64 = 10.0;

/// What both stages and their comparison give reason to doubt.
pub(super) fn doubts(
    records: &[Record],
    first: &Intersection,
    mut doubts: Vec<ReconstructionDoubt>,
    fit: &LikelihoodFit,
    noise: &NoiseModel,
) -> Vec<ReconstructionDoubt> {
    // The second stage has levels and directions of its own, and among disturbances a better idea of what is excited.
    let quiet = matches!(noise, NoiseModel::Quiet(_));
    doubts.retain(|doubt| match doubt {
        ReconstructionDoubt::Subspace(doubt) => match doubt {
            SubspaceDoubt::NoiseNotConverged { .. } | SubspaceDoubt::UncertainDirection { .. } => {
                false
            }
            SubspaceDoubt::HardlyExcited { pole, .. } => !(quiet && is_determined(*pole, fit)),
            _ => true,
        },
        _ => true,
    });
    doubts.extend(of_search(fit));
    if first.noise.origin == NoiseOrigin::Rounding {
        // The level was chosen, and what is left are rounding errors.
        return doubts;
    }
    doubts.extend(of_size(records, fit, noise));
    for (record, whiteness) in records.iter().zip(&fit.whiteness) {
        let p_value = match noise {
            NoiseModel::Quiet(quiet) => whiteness.p_value_with_variance(with_quiet(record, quiet)),
            _ => whiteness.p_value,
        };
        if p_value < IMPROBABLE {
            let record = whiteness.record.clone();
            doubts.push(ReconstructionDoubt::ResidualsNotWhite { record, p_value });
        }
    }
    if let Some(test) = fit.offset_test
        && test.p_value < IMPROBABLE
    {
        doubts.push(ReconstructionDoubt::Offset { p_value: test.p_value });
    }
    for rival in &fit.rivals {
        doubts.push(ReconstructionDoubt::AnotherSystem {
            likelihood_ratio: (0.5 * rival.above).exp(),
            eigenvalues: rival.eigenvalues.clone(),
        });
    }
    if let (NoiseOrigin::Estimated { .. }, Some(levels)) = (first.noise.origin, &fit.noise_levels) {
        let channels = records[0].channels().iter();
        for ((channel, &subspace), level) in channels.zip(&first.noise.deviations).zip(levels) {
            if level.value - 3.0 * level.deviation > LEVEL_RATIO * subspace {
                let (sensor, likelihood) = (channel.name.clone(), level.value);
                doubts.push(ReconstructionDoubt::LevelsDisagree { sensor, subspace, likelihood });
            }
        }
    }
    doubts
}

/// A mode whose deviation is below this part of its size is excited enough.
const DETERMINED: f64 = 0.3;

/// Whether the likelihood knows the mode that the first stage has at z.
fn is_determined(z: Complex<f64>, fit: &LikelihoodFit) -> bool {
    let upper = Complex::new(z.re, z.im.abs());
    let distance = |mode: &&ModeEstimate| (mode.discrete.value - upper).norm();
    let closest = fit.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    closest.is_some_and(|mode| {
        let deviation = mode.continuous.covariance.trace().sqrt();
        deviation < DETERMINED * mode.continuous.value.norm()
    })
}

/// What a spectrum from a quiet record adds to the variance of autocorrelations: it is as uncertain as that record is short.
fn with_quiet(record: &Record, quiet: &Record) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a record has fewer than 2^53 samples")]
    let ratio = record.samples() as f64 / quiet.samples() as f64;
    1.0 + ratio
}

fn of_search(fit: &LikelihoodFit) -> Vec<ReconstructionDoubt> {
    let mut doubts = Vec::new();
    let search = &fit.search;
    // What is left to gain at rounding level is rounding errors.
    if !matches!(search.status, SearchStatus::Converged | SearchStatus::AtRoundingLevel) {
        let (status, remaining_step) = (search.status, search.remaining_step);
        doubts.push(ReconstructionDoubt::OptimumNotReached { status, remaining_step });
    } else if !search.levels_settled {
        doubts.push(ReconstructionDoubt::LevelsNotSettled { updates: search.level_updates });
    }
    if fit.determined < fit.identifiable {
        let (determined, identifiable) = (fit.determined, fit.identifiable);
        doubts.push(ReconstructionDoubt::Undetermined { determined, identifiable });
    }
    doubts
}

/// The probability of a chi-squared as far from its degrees of freedom, on this side; with a quiet record whose spectrum is itself as uncertain
/// as that record is short, by the normal distribution.
fn probability(fit: &LikelihoodFit, noise: &NoiseModel) -> f64 {
    let chi_squared = fit.chi_squared;
    let Some(p_value) = chi_squared.p_value else { return 1.0 };
    let NoiseModel::Quiet(quiet) = noise else { return p_value.min(1.0 - p_value) };
    #[expect(clippy::cast_precision_loss, reason = "a record has fewer than 2^53 samples")]
    let of_quiet = ((quiet.channels().len() - 1) * quiet.samples()) as f64;
    let variance = 2.0 / chi_squared.degrees_of_freedom + 2.0 / of_quiet;
    chi_squared.probability_with_variance(variance)
}

fn of_size(
    records: &[Record],
    fit: &LikelihoodFit,
    noise: &NoiseModel,
) -> Vec<ReconstructionDoubt> {
    let mut doubts = Vec::new();
    let chi_squared = fit.chi_squared;
    let degrees_of_freedom = chi_squared.degrees_of_freedom;
    let parameters = fit.identifiable;
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let needed = RESIDUALS_PER_PARAMETER * parameters as f64;
    if degrees_of_freedom < needed {
        doubts.push(ReconstructionDoubt::TooShort { degrees_of_freedom, parameters });
    }
    let per_degree_of_freedom = chi_squared.per_degree_of_freedom();
    let probability = probability(fit, noise);
    if probability < IMPROBABLE {
        doubts.push(ReconstructionDoubt::PoorFit { per_degree_of_freedom, probability });
    }
    let total: usize = records.iter().map(Record::samples).sum();
    for (record, &value) in records.iter().zip(&fit.record_chi_squared) {
        #[expect(clippy::cast_precision_loss, reason = "a record has fewer than 2^53 samples")]
        let share = degrees_of_freedom * record.samples() as f64 / total as f64;
        let deviations = (value - per_degree_of_freedom) / (2.0 / share).sqrt();
        if deviations > FAR_FROM_ONE {
            doubts.push(ReconstructionDoubt::UnequalFit {
                record: record.name().to_owned(),
                per_degree_of_freedom: value,
                deviations,
            });
        }
    }
    doubts
}
