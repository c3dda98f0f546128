//! Why a reconstruction should not be trusted: what the stages doubt themselves, and what shows only when their answers are compared.

use num_complex::Complex;

use crate::likelihood::{ComplexEstimate, Estimate, Fit, Mode};
use crate::model::lateral_equations::contradiction;
use crate::model::record::deviation;
use crate::subspace::{Intersection, NoiseOrigin};
use crate::{NoiseModel, Record, likelihood, output_error, paper, subspace};

/// A reason, found in the data, to doubt a [`Reconstruction`](crate::Reconstruction). Each can be printed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// A doubt of the paper's method.
    Paper(paper::Doubt),
    /// A doubt of the intersection of signal subspaces.
    Subspace(subspace::Doubt),
    /// A doubt of the likelihood.
    Likelihood(likelihood::Doubt),
    /// A doubt of output error with recorded inputs.
    OutputError(output_error::Doubt),
    /// Each record obeys the lateral equations, but not all with the same derivatives: speed, height, weight or configuration differ between them.
    ConditionsDiffer {
        /// Each record.
        conditions: Vec<RecordCondition>,
        /// The probability that records flown under one condition look like that.
        p_value: f64,
    },
    /// The lateral equations that were asked for are rejected against a system of so many states.
    StructureContradicted {
        /// The number of its states.
        order: usize,
        /// The probability that records which obey the equations look like that.
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
}

/// The condition of one record, from its own derivatives.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RecordCondition {
    /// The record.
    pub record: String,
    /// Its speed over that of the first record, from its dynamics.
    pub speed_ratio: Estimate,
    /// Its eigenvalues in rad/s, a complex pair once.
    pub eigenvalues: Vec<ComplexEstimate>,
}

impl std::fmt::Display for RecordCondition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let eigenvalue = |s: &ComplexEstimate| {
            let (re, im) = (s.value.re, s.value.im);
            let pair = if im > 0.0 { format!(" +- {im:.3}j") } else { String::new() };
            let error = s.covariance.trace().max(0.0).sqrt();
            format!("{re:.3}{pair} (standard error {error:.1e})")
        };
        let all: Vec<_> = self.eigenvalues.iter().map(eigenvalue).collect();
        write!(f, "{} has eigenvalues {} 1/s", self.record, all.join(", "))?;
        let Estimate { value, standard_error } = self.speed_ratio;
        if standard_error > 0.0 {
            write!(
                f,
                ", as if flown {value:.2} +- {standard_error:.2} times as fast as the first"
            )?;
        }
        Ok(())
    }
}

impl Doubt {
    /// A short name for programs, which stays what it is; the program's documentation lists all of them.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Paper(doubt) => doubt.code(),
            Self::Subspace(doubt) => doubt.code(),
            Self::Likelihood(doubt) => doubt.code(),
            Self::OutputError(doubt) => doubt.code(),
            Self::ConditionsDiffer { .. } => "conditions-differ",
            Self::StructureContradicted { .. } => "structure-contradicted",
            Self::LevelsDisagree { .. } => "levels-disagree",
        }
    }
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Paper(doubt) => doubt.fmt(f),
            Self::Subspace(doubt) => doubt.fmt(f),
            Self::Likelihood(doubt) => doubt.fmt(f),
            Self::OutputError(doubt) => doubt.fmt(f),
            Self::ConditionsDiffer { conditions, p_value } => {
                let all: Vec<_> = conditions.iter().map(RecordCondition::to_string).collect();
                write!(
                    f,
                    "the records were not flown under one condition (p = {p_value:.0e}): {}; identify each condition from records of its own, at one speed, height, weight and configuration",
                    all.join("; ")
                )
            }
            Self::StructureContradicted { order, p_value } => f.write_str(&contradiction(&format!(
                "a likelihood-ratio test against a system of {order} states rejects them (p = {p_value:.0e})"
            ))),

            Self::LevelsDisagree { sensor, subspace, likelihood } => write!(
                f,
                "sensor {sensor}: one excitation for each record leaves noise of {likelihood:.2e}, the signal subspaces show {subspace:.2e}: \
                 more than one excitation in a record, or too low an order"
            ),
        }
    }
}

/// With a model error no level is below 1e-3 of a sensor's root mean square; a level that is this part of it was not chosen.
const FAR_ABOVE_THE_FLOOR: f64 = 5e-3;

/// Levels of both stages differ by less: the first stage's come out up to 20 % low in short records.
const LEVEL_RATIO: f64 = 1.5;
/// Quantised flights differ by 2.3, a second excitation by 5 and more.
const LEVEL_RATIO_WITH_MODEL_ERROR: f64 = 4.0;

/// What both stages and their comparison give reason to doubt.
pub(super) fn doubts(
    records: &[Record],
    first: &Intersection,
    mut doubts: Vec<Doubt>,
    fit: &Fit,
    noise: &NoiseModel,
) -> Vec<Doubt> {
    if first.noise.origin == NoiseOrigin::Rounding {
        doubts.retain(|doubt| !is_superseded(doubt, fit, noise));
        // The level was chosen, and what is left are rounding errors.
        doubts.extend(fit.doubts_of_search().into_iter().map(Doubt::Likelihood));
        return doubts;
    }
    let mut of_fit: Vec<_> =
        fit.doubts(records, noise).into_iter().map(Doubt::Likelihood).collect();
    of_fit.extend(disagreeing_levels(records, first, fit));
    // What the first stage says of order and excitations holds for white noise; beside a model error it explains what is doubtful anyway.
    let explained = fit.model_error.is_some() && !of_fit.iter().any(is_of_much_unexplained);
    doubts.retain(|doubt| {
        let explained = explained && is_of_white_noise(doubt);
        !explained && !is_superseded(doubt, fit, noise)
    });
    doubts.extend(of_fit);
    doubts
}

/// Whether the second stage knows better: it has levels and directions of its own, and among disturbances a better idea of what is excited.
fn is_superseded(doubt: &Doubt, fit: &Fit, noise: &NoiseModel) -> bool {
    let Doubt::Subspace(doubt) = doubt else { return false };
    let disturbed = matches!(noise, NoiseModel::Quiet(_)) || fit.model_error.is_some();
    match doubt {
        subspace::Doubt::NoiseNotConverged { .. } | subspace::Doubt::UncertainDirection { .. } => {
            true
        }
        subspace::Doubt::HardlyExcited { pole, .. } => disturbed && is_determined(*pole, fit),
        _ => false,
    }
}

/// Whether a doubt of the first stage rests on noise that is white.
fn is_of_white_noise(doubt: &Doubt) -> bool {
    matches!(
        doubt,
        Doubt::Subspace(
            subspace::Doubt::WeakOrder { .. }
                | subspace::Doubt::ContestedOrder { .. }
                | subspace::Doubt::SeveralExcitations { .. }
                | subspace::Doubt::NoExcitation { .. }
                | subspace::Doubt::NoiseNotWhite { .. }
                | subspace::Doubt::SameExcitation { .. }
        )
    )
}

/// Whether a doubt says that one linear system under one excitation in each record leaves much over.
fn is_of_much_unexplained(doubt: &Doubt) -> bool {
    use likelihood::Doubt as OfFit;
    matches!(
        doubt,
        Doubt::LevelsDisagree { .. }
            | Doubt::Likelihood(OfFit::LargeModelError { .. } | OfFit::SameDirection { .. })
    )
}

/// Sensors of which the likelihood needs far more noise than the signal subspaces show.
fn disagreeing_levels(records: &[Record], first: &Intersection, fit: &Fit) -> Vec<Doubt> {
    let (NoiseOrigin::Estimated { .. }, Some(levels)) = (first.noise.origin, &fit.noise_levels)
    else {
        return Vec::new();
    };
    let model_error = fit.model_error.is_some();
    let ratio = if model_error { LEVEL_RATIO_WITH_MODEL_ERROR } else { LEVEL_RATIO };
    let channels = records[0].channels().iter();
    let each = channels.zip(&first.noise.deviations).zip(levels).enumerate();
    let disagree = each.filter(|(index, ((_, subspace), level))| {
        let above_floor = || level.value > FAR_ABOVE_THE_FLOOR * deviation(records, *index);
        (!model_error || above_floor())
            && level.value - 3.0 * level.standard_error > ratio * **subspace
    });
    disagree
        .map(|(_, ((channel, &subspace), level))| Doubt::LevelsDisagree {
            sensor: channel.name.clone(),
            subspace,
            likelihood: level.value,
        })
        .collect()
}

/// A mode whose deviation is below this part of its size is excited enough.
const DETERMINED: f64 = 0.3;

/// Whether the likelihood knows the mode that the first stage has at z.
fn is_determined(z: Complex<f64>, fit: &Fit) -> bool {
    let upper = Complex::new(z.re, z.im.abs());
    let distance = |mode: &&Mode| (mode.discrete.value - upper).norm();
    let closest = fit.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    closest.is_some_and(|mode| {
        let deviation = mode.continuous.covariance.trace().sqrt();
        deviation < DETERMINED * mode.continuous.value.norm()
    })
}

#[cfg(test)]
mod tests;
