//! What can make a fit with recorded inputs untrustworthy.

use std::f64::consts::TAU;
use std::fmt;

use super::candidate::Candidate;
use super::coherence::tied_and_unexplained;
use super::explained::explained_where_it_responds;
use super::fit::{Context, Fit};
use super::lag_test::lags_left;
use super::parametrisation::Form;
use super::spectra::Spectrum;
use crate::model::lateral_equations::contradiction;

/// A reason not to trust the result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// A system of so many states is more likely than the lateral equations that were asked for.
    StructureContradicted {
        /// The number of states of the system that is most likely.
        order: usize,
        /// Minus twice the logarithm of the likelihood of the equations over its own, with Schwarz's penalty.
        evidence: f64,
    },
    /// The recorded inputs explain too little of a sensor in every record in which they move.
    Unexplained {
        /// The record in which it is explained best.
        record: String,
        /// The sensor.
        sensor: String,
        /// The part of its power that is explained.
        explained: f64,
    },
    /// What the model leaves of a sensor follows the inputs: they are moved by what the sensors read, or the model misses a part of the system.
    TiedToInputs {
        /// The record.
        record: String,
        /// The sensor.
        sensor: String,
        /// The part of the sensor's power that is tied to the inputs and not explained.
        part: f64,
    },
    /// A sensor is late, and was taken to be in time.
    LagNeeded {
        /// The sensor.
        sensor: String,
        /// The lag in s.
        lag_s: f64,
        /// Its standard error in s.
        standard_error_s: f64,
    },
    /// Fit and spectrum of the disturbance did not stand still.
    NotSettled,
    /// The system that was found grows faster than the records do.
    Unstable {
        /// The real part of the eigenvalue, in 1/s.
        real_part: f64,
    },
    /// A mode whose standard error is larger than itself.
    Undetermined {
        /// |s| in rad/s.
        size: f64,
    },
    /// Few data for so many parameters.
    TooShort {
        /// Real numbers of the sensors in the band.
        numbers: f64,
        /// Parameters, and initial states.
        parameters: usize,
    },
}

/// Below this part of a sensor's power the recorded inputs cannot be all that moved the system.
const TOO_LITTLE: f64 = 0.45;
/// Nonlinear flights stay below this part of a sensor's power.
const MUCH_TIED: f64 = 0.1;
/// A mode that grows by more than e^5 in the longest record would show.
const LARGEST_GROWTH: f64 = 5.0;
/// Numbers for each parameter, at least.
const FEW: f64 = 3.0;
/// The last round of a fit may move it by so many squared standard errors.
const UNSETTLED: f64 = 1.0;
/// A likelihood ratio of e^30: forms are compared by fits that are not at their ends.
const DECISIVE: f64 = 60.0;

impl Doubt {
    /// Whether it says that something else than the recorded inputs moved the system.
    #[must_use]
    pub fn is_of_unrecorded_excitation(&self) -> bool {
        matches!(self, Self::Unexplained { .. } | Self::TiedToInputs { .. })
    }

    /// A stable word for programs.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::StructureContradicted { .. } => "structure-contradicted",
            Self::Unexplained { .. } => "inputs-explain-little",
            Self::TiedToInputs { .. } => "tied-to-inputs",
            Self::LagNeeded { .. } => "lag",
            Self::NotSettled => "not-settled",
            Self::Unstable { .. } => "unstable",
            Self::Undetermined { .. } => "undetermined",
            Self::TooShort { .. } => "too-short",
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StructureContradicted { order, evidence } => f.write_str(&contradiction(&format!(
                "a system of {order} states is e^{:.0} times as likely",
                evidence / 2.0
            ))),
Self::Unexplained { record, sensor, explained } => write!(
                f,
                "the recorded inputs explain at most {:.0} % of the power of {sensor}, in {record}; something else moved the aircraft as well, or the inputs are not those of this record",
                100.0 * explained.max(0.0)
            ),
            Self::TiedToInputs { record, sensor, part } => write!(
                f,
                "{:.0} % of the power of {sensor} in {record} follow the inputs and are not explained: a controller moves the inputs after what the sensors read, or the model misses a \
                 part of the system",
                100.0 * part
            ),
            Self::LagNeeded { sensor, lag_s, standard_error_s } => write!(
                f,
                "{sensor} is late by {lag_s:.3} +- {standard_error_s:.3} s; estimate the lag with --lag {sensor}=free"
            ),
            Self::NotSettled => f.write_str(
                "the fit and the spectrum of the disturbance did not settle; a longer record or one with larger inputs would help",
            ),
            Self::Unstable { real_part } => write!(
                f,
                "a mode grows by e in {:.3} s, which the records do not: the fit followed a disturbance; fix the order with --order",
                1.0 / real_part
            ),
            Self::Undetermined { size } => write!(
                f,
                "the mode at {size:.3} rad/s is not determined: its standard error is larger than itself; move the controls so that it shows, or fix the order with --order"
            ),
            Self::TooShort { numbers, parameters } => write!(
                f,
                "the records are short: {numbers:.0} numbers in the band for {parameters} parameters, so that standard errors mean little; a longer record would help"
            ),
        }
    }
}

pub(super) fn doubts(fit: &Fit, found: &Candidate, context: &Context<'_>) -> Vec<Doubt> {
    let mut doubts = Vec::new();
    let name = |record: usize, sensor: usize| {
        let record = &context.records[record];
        (record.name().to_owned(), record.channels()[sensor].name.clone())
    };
    if matches!(found.parametrisation.form, Form::Lateral(_))
        && let Some(other) = fit.compared.iter().min_by(|x, y| x.above.total_cmp(&y.above))
        && other.above < -DECISIVE
    {
        doubts.push(Doubt::StructureContradicted { order: other.order, evidence: -other.above });
    }
    let parts = explained_where_it_responds(&fit.records, context.spectra);
    let sensors = context.records[0].channels().len();
    for sensor in 0..sensors {
        let all = parts.iter().map(|(record, of_sensors)| (*record, of_sensors[sensor]));
        if let Some((record, explained)) = all.max_by(|x, y| x.1.total_cmp(&y.1))
            && explained < TOO_LITTLE
        {
            let (record, sensor) = name(record, sensor);
            doubts.push(Doubt::Unexplained { record, sensor, explained });
        }
    }
    // Where no input moves, only free motion from the start of the record may be left.
    for (record, own) in fit.records.iter().enumerate() {
        let rests = parts.iter().all(|(moving, _)| *moving != record);
        let all = own.explained.iter().copied().enumerate();
        let best = all.max_by(|x, y| x.1.total_cmp(&y.1));
        if let Some((sensor, explained)) = best.filter(|(_, part)| rests && *part < TOO_LITTLE) {
            let (record, sensor) = name(record, sensor);
            doubts.push(Doubt::Unexplained { record, sensor, explained });
        }
    }
    for (record, (own, spectrum)) in fit.records.iter().zip(context.spectra).enumerate() {
        let tied = tied_and_unexplained(&own.residuals, &own.measured, &spectrum.u);
        let worst = tied.into_iter().enumerate().max_by(|x, y| x.1.total_cmp(&y.1));
        if let Some((sensor, part)) = worst.filter(|(_, part)| *part > MUCH_TIED) {
            let (record, sensor) = name(record, sensor);
            doubts.push(Doubt::TiedToInputs { record, sensor, part });
        }
    }
    let late = lags_left(found, context.spectra).into_iter().enumerate();
    let late = late.filter_map(|(sensor, lag)| Some((sensor, lag?)));
    let worst = late.max_by(|x, y| x.1.value.abs().total_cmp(&y.1.value.abs()));
    if let Some((sensor, lag)) = worst {
        let (lag_s, standard_error_s) = (lag.value, lag.standard_error);
        let (_, sensor) = name(0, sensor);
        doubts.push(Doubt::LagNeeded { sensor, lag_s, standard_error_s });
    }
    if found.last_move > UNSETTLED {
        doubts.push(Doubt::NotSettled);
    }
    let seconds =
        context.records.iter().map(|record| record.period().seconds() * record.samples() as f64);
    let longest = seconds.fold(0.0, f64::max);
    for mode in &fit.modes {
        let s = mode.continuous;
        if s.value.re * longest > LARGEST_GROWTH && s.value.re > 2.0 * s.real_standard_error() {
            doubts.push(Doubt::Unstable { real_part: s.value.re });
        }
        if s.covariance.trace().sqrt() > s.value.norm() && s.value.norm() * longest > TAU {
            doubts.push(Doubt::Undetermined { size: s.value.norm() });
        }
    }
    let numbers: f64 = context.spectra.iter().map(Spectrum::real_numbers).sum();
    let parameters = found.parametrisation.identifiable() + found.evaluation.determined;
    if numbers < FEW * parameters as f64 {
        doubts.push(Doubt::TooShort { numbers, parameters });
    }
    doubts
}
