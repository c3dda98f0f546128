//! What can be wrong with the choice of columns, windows and rates.

use std::path::PathBuf;

/// Why what was asked for is not in a file: one sentence with the names and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SelectionError {
    /// A column that the file does not have.
    #[error("{} has no column {column:?}; it has {available}", file.display())]
    NoSuchColumn {
        /// The file.
        file: PathBuf,
        /// The name asked for.
        column: String,
        /// The names that are there.
        available: String,
    },
    /// The same column asked for twice, or time asked for as an output.
    #[error("--outputs names {column:?} {why}")]
    BadOutputs {
        /// The column.
        column: String,
        /// What is wrong with it.
        why: &'static str,
    },
    /// A unit that is not known.
    #[error(
        "{}, column {column:?}: the unit {unit:?} is not known; known are {known}: correct the header, or leave the unit \
         out to take the numbers as they are",
        file.display()
    )]
    UnknownUnit {
        /// The file.
        file: PathBuf,
        /// The column.
        column: String,
        /// What the header says.
        unit: String,
        /// The units that can be converted.
        known: String,
    },
    /// One sensor in two files with units of different kinds.
    #[error(
        "{}: {column:?} is in {unit} there and in {other_unit} in {}; the sensors of all records must be the same: choose them with \
         --outputs, or correct a header",
        file.display(), other.display()
    )]
    UnitsDiffer {
        /// The file.
        file: PathBuf,
        /// The column.
        column: String,
        /// Its unit, in SI.
        unit: &'static str,
        /// The file before.
        other: PathBuf,
        /// The unit there, in SI.
        other_unit: &'static str,
    },
    /// Time in a unit that is none of time.
    #[error("{}, column {column:?}: {unit:?} is no unit of time; s, ms, us, min and h are, and what a clock shows has none: correct the header", file.display())]
    NotTime {
        /// The file.
        file: PathBuf,
        /// The column.
        column: String,
        /// What the header says.
        unit: String,
    },
    /// Channels of one record with different numbers of samples.
    #[error(
        "{}: {first:?} has {first_samples} samples, {second:?} has {second_samples}; the channels of a record must be equally \
         long: choose them with --outputs",
        file.display()
    )]
    UnequalLengths {
        /// The file.
        file: PathBuf,
        /// A channel.
        first: String,
        /// Its length.
        first_samples: usize,
        /// Another one.
        second: String,
        /// Its length.
        second_samples: usize,
    },
    /// A window in which there is no sample.
    #[error(
        "{}: no sample lies in the window from {start_s} s to {end_s} s; its time runs from {first_s} s to {last_s} s",
        file.display()
    )]
    WindowOutside {
        /// The file.
        file: PathBuf,
        /// Start of the window.
        start_s: f64,
        /// End of the window.
        end_s: f64,
        /// First time stamp.
        first_s: f64,
        /// Last time stamp.
        last_s: f64,
    },
    /// One file twice, so that two records would be one.
    #[error(
        "{} is given twice and would count as two records; name it once, or take two windows of it with --window",
        file.display()
    )]
    SameFile {
        /// The file.
        file: PathBuf,
    },
    /// A record of which decimation leaves too little.
    #[error(
        "{}: --decimate {factor} needs more than {needed} samples, because its filter is that long, but {found} are there; \
         decimate less",
        file.display()
    )]
    Decimation {
        /// The file.
        file: PathBuf,
        /// The factor.
        factor: usize,
        /// Length of the filter, in samples.
        needed: usize,
        /// Number of samples.
        found: usize,
    },
    /// Gaps everywhere.
    #[error(
        "{}: its gaps leave no stretch of {needed} samples, the longest has {longest}; choose sensors without missing samples \
         with --outputs, or interpolate those of a lower rate with --resample PERIOD",
        file.display()
    )]
    OnlyGaps {
        /// The file.
        file: PathBuf,
        /// Samples that a stretch must have.
        needed: usize,
        /// Samples that the longest one has.
        longest: usize,
    },
    /// Nothing to read.
    #[error("no record is given; name files, or stretches of files with --window")]
    NoFile,
    /// A measured input that cannot be one.
    #[error("--inputs names {column:?} {why}")]
    BadKnownInput {
        /// The column.
        column: String,
        /// What is wrong with it.
        why: &'static str,
    },
}
