//! What there is to say of files that could be read.

use std::fmt;

use super::segments::SHORTEST;

/// One thing that was done to a file and that its owner may not expect.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LoadWarning {
    /// Gaps split a file, or a window of it.
    Split {
        /// What the record would be called.
        record: String,
        /// How many stretches there are between gaps.
        stretches: usize,
        /// Where the second one starts.
        place: String,
    },
    /// Stretches between gaps that were left out.
    ShortStretches {
        record: String,
        count: usize,
        /// Samples in them.
        samples: usize,
    },
    /// Of the stretches between gaps the longest alone is used.
    LongestStretch {
        record: String,
        samples: usize,
        /// Samples in all stretches.
        total: usize,
    },
    /// A window that is longer than its file.
    WindowCut {
        record: String,
        /// Times of its first and of its last sample, in seconds.
        time_s: [f64; 2],
    },
    /// Two windows of one file that have samples in common.
    WindowsOverlap { records: [String; 2] },
    /// A sensor whose unit the first file states and the second does not.
    UnitMissing { files: [String; 2], column: String, unit: &'static str },
    /// A recorded input that a file has no column of.
    InputMissing { file: String, column: String },
    /// A recorded input that rests in a record.
    IdleInput { record: String, column: String },
    /// A record in which `monitor` finds no span.
    NoSpan {
        record: String,
        samples: usize,
        /// Samples that one span takes.
        needed: usize,
    },
}

impl LoadWarning {
    /// A short name for other programs.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::Split { .. } => "gaps",
            Self::ShortStretches { .. } => "short-stretches",
            Self::LongestStretch { .. } => "longest-stretch",
            Self::WindowCut { .. } => "window-cut",
            Self::WindowsOverlap { .. } => "windows-overlap",
            Self::UnitMissing { .. } => "unit-missing",
            Self::InputMissing { .. } => "input-missing",
            Self::IdleInput { .. } => "idle-input",
            Self::NoSpan { .. } => "no-span",
        }
    }
}

impl fmt::Display for LoadWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Split { record, stretches, place } => write!(
                f,
                "gaps split {record} into {stretches} stretches, which count as one record; the second starts at {place}"
            ),
            Self::LongestStretch { record, samples, total } => write!(
                f,
                "only the longest stretch between gaps is used: {record}, {samples} of {total} samples"
            ),
            Self::WindowCut { record, time_s: [first, last] } => write!(
                f,
                "{record} reaches beyond its file, and is what the file has of it: from {first} s to {last} s"
            ),
            Self::WindowsOverlap { records: [first, second] } => write!(
                f,
                "{first} and {second} overlap: what they have in common counts twice, as if it had been measured twice"
            ),
            Self::UnitMissing { files: [stated, silent], column, unit } => write!(
                f,
                "{silent} does not say the unit of {column}, and its numbers are taken to be in {unit}, as {stated} has it"
            ),
            Self::IdleInput { record, column } => {
                write!(f, "the recorded input {column} rests in {record} and is left out there")
            }
            Self::InputMissing { file, column } => write!(
                f,
                "{file} has no column {column:?}: that input is taken not to have moved in it"
            ),
            Self::NoSpan { record, samples, needed } => write!(
                f,
                "{record} was left out: its {samples} samples are too few for one span, which takes {needed}"
            ),
            Self::ShortStretches { record, count, samples } => {
                let (noun, verb) =
                    if *count == 1 { ("stretch", "was") } else { ("stretches", "were") };
                write!(
                    f,
                    "{count} {noun} of {record} between gaps, {samples} samples in all, {verb} left out: shorter than {SHORTEST} samples"
                )
            }
        }
    }
}
