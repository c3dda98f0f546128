//! All that there is to say of one run, for the terminal, the JSON and the report.

use std::num::NonZero;

use aircraft::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, NamedMode, level};
use reconstruct::output_error::Simulation;
use reconstruct::subspace::NoiseOrigin;
use reconstruct::{ComparedOrder, Doubt, Options, Reconstruction, Record, likelihood, subspace};
use report::format_significant;

use super::coefficients::Coefficient;
use crate::args::values::MethodName;
use crate::inspect::Cause;
use crate::modes::IdentifiedMode;
use crate::records::{LoadWarning, Source};

/// The result with what it was made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome<'a> {
    /// The command line, ready to be pasted.
    pub(crate) command: &'a str,
    pub(crate) method: MethodName,
    pub(crate) records: &'a [Record],
    /// One for each record.
    pub(crate) sources: &'a [Source],
    /// What the result was asked with.
    pub(crate) options: &'a Options,
    pub(crate) result: &'a Reconstruction,
    /// The modes with their names, the fastest first.
    pub(crate) found: &'a [IdentifiedMode],
    /// For flying-quality levels, which are left out without it.
    pub(crate) flying_qualities: Option<FlyingQualitiesCase>,
    pub(crate) warnings: &'a [LoadWarning],
    /// Records that the fit did not see, as the model predicts them.
    pub(crate) predictions: &'a [Prediction],
    /// Derivatives in nondimensional form, where the size of the aircraft is known.
    pub(crate) coefficients: &'a [Coefficient],
    /// Every how many samples of the files one is kept.
    pub(crate) decimation: NonZero<usize>,
    /// What is odd about the sensors, as a cause of doubts.
    pub(crate) causes: &'a [Cause],
}

/// A record that the fit did not see.
#[derive(Clone, Debug)]
pub(crate) struct Prediction {
    pub(crate) record: Record,
    pub(crate) simulation: Simulation,
}

/// What MIL-F-8785C makes flying-quality levels depend on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlyingQualitiesCase {
    pub(crate) class: AircraftClass,
    pub(crate) phase: FlightPhaseCategory,
}

impl FlyingQualitiesCase {
    /// The level of a mode, where the standard has requirements for one of its name.
    pub(crate) fn level(self, mode: &NamedMode) -> Option<FlyingQualityLevel> {
        level(mode, self.class, self.phase)
    }
}

impl Outcome<'_> {
    /// The flying-quality level of a mode, where class and phase are known.
    pub(crate) fn level(&self, found: &IdentifiedMode) -> Option<FlyingQualityLevel> {
        self.flying_qualities.and_then(|case| case.level(&found.named))
    }

    /// How the order used compares with others, `e^57 times more likely than 3, e^9.1 times more
    /// likely than 5`; empty where no other was fitted.
    pub(crate) fn likelihood_ratios(&self) -> String {
        let ratio = |other: &ComparedOrder| {
            // The criterion is minus twice a logarithm.
            let exponent = format_significant(other.above.abs() / 2.0, 2);
            let than = if other.above < 0.0 { "less" } else { "more" };
            format!("e^{exponent} times {than} likely than {}", other.order)
        };
        self.result.compared_orders().iter().map(ratio).collect::<Vec<_>>().join(", ")
    }

    /// The form of the equations, where the lateral ones were fitted as well.
    pub(crate) fn form(&self) -> Option<String> {
        const SMALLEST: f64 = 1e-12;
        let compared = self.result.compared_form()?;
        let name = |is_lateral: bool, order: usize| {
            if is_lateral {
                "the lateral equations".to_owned()
            } else {
                format!("a system of {order} states with all entries free")
            }
        };
        let own = self.result.fit()?.model.a.nrows();
        // The search ends where nothing else can come of it.
        let p_value = if compared.p_value < SMALLEST {
            format!("p < {SMALLEST:.0e}")
        } else {
            format!("p = {}", format_significant(compared.p_value, 2))
        };
        Some(if compared.is_lateral {
            format!(
                "{}; the lateral equations are rejected ({p_value}, likelihood-ratio test)",
                name(false, own)
            )
        } else {
            format!(
                "the lateral equations, tested against {} ({p_value}, likelihood-ratio test)",
                name(false, compared.order)
            )
        })
    }

    /// The unit of a channel, where all files that state one agree.
    pub(crate) fn unit(&self, channel: usize) -> Option<&'static str> {
        let mut units =
            self.sources.iter().filter_map(|source| source.units.get(channel)?.as_ref());
        let first = units.next()?;
        units.all(|unit| unit == first).then_some(*first)
    }

    /// Where the noise levels come from, as a word; `None` for the paper's method, which knows of no noise.
    pub(crate) fn noise_origin(&self) -> Option<&'static str> {
        Some(match self.result.intersection()?.noise.origin {
            NoiseOrigin::Given => "given",
            NoiseOrigin::Estimated { .. } => "estimated",
            NoiseOrigin::Rounding => "rounding",
            NoiseOrigin::Quiet { .. } => "quiet-record",
            _ => "other",
        })
    }
}

/// Whether a doubt says no more than that the stretches between the gaps of one record were excited in the same way.
///
/// That is what they are taken for: the records that count are the whole ones, and of these there are enough.
pub(super) fn is_of_one_excitation(doubt: &Doubt, records: &[Record], sources: &[Source]) -> bool {
    let (Doubt::Subspace(subspace::Doubt::SameExcitation { first, second, .. })
    | Doubt::Likelihood(likelihood::Doubt::SameDirection { first, second, .. })) = doubt
    else {
        return false;
    };
    let whole = |name: &String| {
        let index = records.iter().position(|record| record.name() == name)?;
        sources.get(index).map(|source| source.whole)
    };
    whole(first).is_some() && whole(first) == whole(second)
}
