//! All that there is to say of one run, for the terminal, the JSON and the report.

use aircraft::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, level};
use reconstruct::{
    FrequencyBand, NoiseOrigin, Reconstruction, ReconstructionDoubt, Record, SubspaceDoubt,
};

use crate::args::values::MethodName;
use crate::modes::Found;
use crate::records::{LoadWarning, Source};

/// The result with what it was made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome<'a> {
    pub(crate) method: MethodName,
    pub(crate) records: &'a [Record],
    pub(crate) sources: &'a [Source],
    pub(crate) result: &'a Reconstruction,
    /// The modes with their names, the fastest first.
    pub(crate) found: &'a [Found],
    pub(crate) band: Option<FrequencyBand>,
    pub(crate) flight: Option<Flight>,
    pub(crate) warnings: &'a [LoadWarning],
}

/// What flying-quality levels are asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flight {
    pub(crate) class: AircraftClass,
    pub(crate) phase: FlightPhaseCategory,
}

impl Outcome<'_> {
    /// The flying-quality level of a mode, where class and phase are known.
    pub(crate) fn level(&self, found: &Found) -> Option<FlyingQualityLevel> {
        self.flight.and_then(|flight| level(&found.named, flight.class, flight.phase))
    }

    /// The unit of a channel, where all files that state one agree.
    pub(crate) fn unit(&self, channel: usize) -> Option<&'static str> {
        let mut units =
            self.sources.iter().filter_map(|source| source.units.get(channel)?.as_ref());
        let first = units.next()?;
        units.all(|unit| unit == first).then_some(*first)
    }

    /// Where the noise levels come from, as a word; `None` for the printed method, which knows of no noise.
    pub(crate) fn noise_origin(&self) -> Option<&'static str> {
        Some(match self.result.intersection.as_ref()?.noise.origin {
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
pub(super) fn is_of_one_excitation(
    doubt: &ReconstructionDoubt,
    records: &[Record],
    sources: &[Source],
) -> bool {
    let ReconstructionDoubt::Subspace(SubspaceDoubt::SameExcitation { first, second, .. }) = doubt
    else {
        return false;
    };
    let whole = |name: &String| {
        let index = records.iter().position(|record| record.name() == name)?;
        sources.get(index).map(|source| source.whole)
    };
    whole(first).is_some() && whole(first) == whole(second)
}
