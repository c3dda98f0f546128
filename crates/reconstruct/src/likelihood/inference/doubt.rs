//! Why a fit should not be trusted.

use num_complex::Complex;

use super::fit::Fit;
use crate::likelihood::search::levenberg_marquardt::SearchStatus;
use crate::{NoiseModel, Offsets, Record};

/// A reason to doubt a [`Fit`]. Each can be printed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
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
    /// One direction of excitation serves two records nearly as well as two: nothing tells the states from a feedback to the excitation.
    SameDirection {
        /// The first record.
        first: String,
        /// The second record.
        second: String,
        /// What chi-squared rises by, in units of its value for a degree of freedom.
        statistic: f64,
    },
    /// A large part of what the sensors read is explained by no linear system under one excitation.
    LargeModelError {
        /// The relative model error.
        model_error: f64,
        /// The record that fits worst, where one stands out.
        record: Option<String>,
    },
    /// Frequency zero does not agree with the others: some sensor does not read zero in trim.
    Offset {
        /// The probability of a disagreement as large, if all did.
        p_value: f64,
    },
    /// Another system explains the records nearly as well.
    AnotherSystem {
        /// How many times as likely the one that was found is.
        likelihood_ratio: f64,
        /// The other one's eigenvalues in rad/s, a complex pair once.
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

impl Doubt {
    /// A short name for programs, which stays what it is; the program's documentation lists all of them.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::OptimumNotReached { .. } => "optimum-not-reached",
            Self::LevelsNotSettled { .. } => "levels-not-settled",
            Self::PoorFit { .. } => "poor-fit",
            Self::UnequalFit { .. } => "unequal-fit",
            Self::ResidualsNotWhite { .. } => "residuals-not-white",
            Self::SameDirection { .. } => "same-direction",
            Self::LargeModelError { .. } => "large-model-error",
            Self::Offset { .. } => "offset",
            Self::AnotherSystem { .. } => "another-system",
            Self::TooShort { .. } => "too-short",
            Self::Undetermined { .. } => "undetermined",
        }
    }
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
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
            Self::SameDirection { first, second, statistic } => write!(
                f,
                "records {first} and {second} can hardly be told apart by what excited them (chi-squared rises by {statistic:.0} where both share one direction): states and \
                 excitation cannot be separated; excite them by different controls"
            ),
            Self::LargeModelError { model_error, record } => write!(
                f,
                "one linear system under one excitation in each record leaves {:.0} % of what the sensors read unexplained{}: more than one excitation, \
                 disturbances, large motions, or conditions that changed",
                100.0 * model_error,
                record
                    .as_ref()
                    .map_or_else(String::new, |name| format!(", most of it in record {name}"))
            ),
            Self::Offset { p_value } => write!(
                f,
                "a sensor does not read zero in trim ({} if all did), which pushes the slow modes: take offsets into account, or the \
                 trim values out of the records",
                chance(*p_value)
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
pub(crate) const IMPROBABLE: f64 = 1e-4;

/// A record whose residuals are so many standard deviations too large is doubted: levels that are common to all make the fits of the records
/// compete, and the residuals are only nearly chi-squared.
const FAR_FROM_ONE: f64 = 6.0;

/// A search that ends so close to its optimum, in standard errors, has arrived.
const ARRIVED: f64 = 0.1;

/// Two directions where there is one fit noise: chi-squared rises by about as much as there are parameters.
const DIRECTIONS_APART: f64 = 3.0;

/// A relative model error above this is no small nonlinearity: simulated flights of six aircraft leave 0.1 to 2 %, in turbulence 50 to 70 %.
const LARGE_MODEL_ERROR: f64 = 0.05;

/// Residuals wanted for each parameter.
const RESIDUALS_PER_PARAMETER: f64 = 10.0;

impl Fit {
    /// Why the fit should not be trusted; empty if there is no such reason. The records are those of the fit, and the noise is what was known of
    /// it: a spectrum from a quiet record is as uncertain as that record is short.
    ///
    /// What its noise levels share with those of other methods is not looked at here.
    #[must_use]
    pub fn doubts(&self, records: &[Record], noise: &NoiseModel) -> Vec<Doubt> {
        let mut doubts = self.doubts_of_search();
        doubts.extend(of_size(records, self, noise));
        let enough = DIRECTIONS_APART * self.identifiable as f64;
        for contrast in self.contrasts.iter().filter(|contrast| contrast.statistic < enough) {
            let [first, second] = contrast.records.map(|record| records[record].name().to_owned());
            doubts.push(Doubt::SameDirection { first, second, statistic: contrast.statistic });
        }
        if let Some(error) = self.model_error
            && error.value > LARGE_MODEL_ERROR
        {
            let record = worst(records, self);
            doubts.push(Doubt::LargeModelError { model_error: error.value, record });
        }
        for (record, whiteness) in records.iter().zip(&self.whiteness) {
            let p_value = match noise {
                NoiseModel::Quiet(quiet) => {
                    whiteness.p_value_with_variance(with_quiet(record, quiet))
                }
                _ => whiteness.p_value,
            };
            if p_value < IMPROBABLE && self.model_error.is_none() {
                let record = whiteness.record.clone();
                doubts.push(Doubt::ResidualsNotWhite { record, p_value });
            }
        }
        if let Some(test) = self.offset_test
            && self.options.measurement.offsets == Offsets::Zero
            && test.p_value < IMPROBABLE
        {
            doubts.push(Doubt::Offset { p_value: test.p_value });
        }
        for rival in &self.rivals {
            doubts.push(Doubt::AnotherSystem {
                likelihood_ratio: (0.5 * rival.above).exp(),
                eigenvalues: rival.eigenvalues.clone(),
            });
        }
        doubts
    }

    /// Those of the search alone, for records whose residuals are rounding errors.
    pub(crate) fn doubts_of_search(&self) -> Vec<Doubt> {
        let mut doubts = Vec::new();
        let search = &self.search;
        // What is left to gain at rounding level is rounding errors.
        let ended =
            matches!(search.status, SearchStatus::Converged | SearchStatus::AtRoundingLevel);
        let (status, remaining_step) = (search.status, search.remaining_step);
        if !ended && (remaining_step > ARRIVED || remaining_step.is_nan()) {
            doubts.push(Doubt::OptimumNotReached { status, remaining_step });
        } else if !search.levels_settled {
            doubts.push(Doubt::LevelsNotSettled { updates: search.level_updates });
        }
        if self.determined < self.identifiable {
            let (determined, identifiable) = (self.determined, self.identifiable);
            doubts.push(Doubt::Undetermined { determined, identifiable });
        }
        doubts
    }
}

/// The record whose residuals stand out.
fn worst(records: &[Record], fit: &Fit) -> Option<String> {
    const STANDS_OUT: f64 = 1.3;
    let all = records.iter().zip(&fit.record_chi_squared);
    let (record, size) = all.max_by(|x, y| x.1.total_cmp(y.1))?;
    (*size > STANDS_OUT * fit.chi_squared.per_degree_of_freedom()).then(|| record.name().to_owned())
}

/// What a spectrum from a quiet record adds to the variance of autocorrelations: it is as uncertain as that record is short.
fn with_quiet(record: &Record, quiet: &Record) -> f64 {
    let ratio = record.samples() as f64 / quiet.samples() as f64;
    1.0 + ratio
}

/// The probability of a chi-squared as far from its degrees of freedom, on this side; with a quiet record whose spectrum is itself as uncertain
/// as that record is short, by the normal distribution.
fn probability(fit: &Fit, noise: &NoiseModel) -> f64 {
    let chi_squared = fit.chi_squared;
    let Some(p_value) = chi_squared.p_value else { return 1.0 };
    let NoiseModel::Quiet(quiet) = noise else { return p_value.min(1.0 - p_value) };
    let of_quiet = ((quiet.channels().len() - 1) * quiet.samples()) as f64;
    let variance = 2.0 / chi_squared.degrees_of_freedom + 2.0 / of_quiet;
    chi_squared.probability_with_variance(variance)
}

fn of_size(records: &[Record], fit: &Fit, noise: &NoiseModel) -> Vec<Doubt> {
    let mut doubts = Vec::new();
    let chi_squared = fit.chi_squared;
    let degrees_of_freedom = chi_squared.degrees_of_freedom;
    let parameters = fit.identifiable;
    let needed = RESIDUALS_PER_PARAMETER * parameters as f64;
    if degrees_of_freedom < needed {
        doubts.push(Doubt::TooShort { degrees_of_freedom, parameters });
    }
    let per_degree_of_freedom = chi_squared.per_degree_of_freedom();
    let probability = probability(fit, noise);
    if probability < IMPROBABLE {
        doubts.push(Doubt::PoorFit { per_degree_of_freedom, probability });
    }
    let total: usize = records.iter().map(Record::samples).sum();
    for (record, &value) in records.iter().zip(&fit.record_chi_squared) {
        let share = degrees_of_freedom * record.samples() as f64 / total as f64;
        let deviations = (value - per_degree_of_freedom) / (2.0 / share).sqrt();
        if deviations > FAR_FROM_ONE && fit.model_error.is_none() {
            doubts.push(Doubt::UnequalFit {
                record: record.name().to_owned(),
                per_degree_of_freedom: value,
                deviations,
            });
        }
    }
    doubts
}
