//! What can be wrong with the command line and with files, in full sentences.

use std::path::PathBuf;

/// Why a command could not be carried out: one sentence with the place and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CommandError {
    /// A file that cannot be read.
    #[error("cannot read {}: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        source: std::io::Error,
    },
    /// A file that cannot be written.
    #[error("cannot write {}: {source}", file.display())]
    Write {
        /// The file, or `-` for standard output.
        file: PathBuf,
        /// What the operating system says.
        source: std::io::Error,
    },
    /// A result that would replace the record it comes from.
    #[error("{} is the record itself; write the result to another file", file.display())]
    OverwritesRecord {
        /// The file.
        file: PathBuf,
    },
    /// A file that is no text in UTF-8.
    #[error("{}, line {line}: the file is not UTF-8 text; export it as plain CSV", file.display())]
    NotText {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
    },
    /// A quote that opens and never closes.
    #[error("{}, line {line}: a quote is opened there and never closed; close or remove it", file.display())]
    OpenQuote {
        /// The file.
        file: PathBuf,
        /// Line on which the row starts, from 1.
        line: u64,
    },
    /// Blanks where the header should be.
    #[error(
        "{}, line {line}: the header should be here, but the line holds no name; remove it if the header is below",
        file.display()
    )]
    BlankHeader {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
    },
    /// A table whose fields are separated by something else than commas.
    #[error(
        "{}: one column only, its name holds {separator:?}: the fields must be separated by commas; export with commas",
        file.display()
    )]
    NotCommas {
        /// The file.
        file: PathBuf,
        /// What seems to separate the fields.
        separator: char,
    },
    /// A file without a header or without a row below it.
    #[error("{} holds no samples: a header line and rows of numbers are needed", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// A row with too many or too few fields.
    #[error(
        "{}, line {line}: {}, but the header names {}",
        file.display(), counted(*found, "field"), counted(*expected, "column")
    )]
    Ragged {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Number of fields in the row.
        found: u64,
        /// Number of columns in the header.
        expected: u64,
    },
    /// Two columns with one name.
    #[error("{}: column {column:?} is there twice; rename one of them", file.display())]
    RepeatedColumn {
        /// The file.
        file: PathBuf,
        /// The name.
        column: String,
    },
    /// A header that is a row of numbers.
    #[error("{}: the first line is a row of numbers; a header line that names the columns is needed", file.display())]
    NoHeader {
        /// The file.
        file: PathBuf,
    },
    /// A field that is not a finite number.
    #[error(
        "{}, line {line}, column {column:?}: {text:?} is not a finite number; repair or remove the row",
        file.display()
    )]
    NotANumber {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
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
    /// No column looks like time.
    #[error("{}: none of its columns ({available}) is called time or t; name it with --time", file.display())]
    NoTimeColumn {
        /// The file.
        file: PathBuf,
        /// The names that are there.
        available: String,
    },
    /// Fewer than two samples: no sample period.
    #[error(
        "{} holds {}; at least 2 are needed to know the sample period",
        file.display(), counted(*found as u64, "sample")
    )]
    TooShort {
        /// The file.
        file: PathBuf,
        /// Number of rows.
        found: usize,
    },
    /// Time that does not advance in equal steps.
    #[error(
        "{}, line {line}: time advances by {step_s:?} s, elsewhere by {period_s:?} s; \
         cut the record there or resample it to equal steps",
        file.display()
    )]
    Uneven {
        /// The file.
        file: PathBuf,
        /// Line of the sample that comes too early or too late, from 1.
        line: u64,
        /// The step before it, in seconds.
        step_s: f64,
        /// The usual step, in seconds.
        period_s: f64,
    },
    /// Time that stands still or runs backwards.
    #[error(
        "{}, line {line}: {}; put the rows in order of time or cut the record there",
        file.display(), backward(*step_s)
    )]
    Backward {
        /// The file.
        file: PathBuf,
        /// Line of the sample that is no later than the one before, from 1.
        line: u64,
        /// The step before it, in seconds: zero or less.
        step_s: f64,
    },
    /// Steps of time that are no sample period.
    #[error(
        "{}, column {column:?}: time advances by {period_s:?} s; \
         time in seconds with steps from 1e-12 s to 1e12 s is needed",
        file.display()
    )]
    SamplePeriod {
        /// The file.
        file: PathBuf,
        /// The column of time.
        column: String,
        /// The usual step, in seconds.
        period_s: f64,
    },
    /// The same column asked for twice, or time asked for as an output.
    #[error("--outputs names {column:?} {why}")]
    BadOutputs {
        /// The column.
        column: String,
        /// What is wrong with it.
        why: &'static str,
    },
    /// One column asked for as both sensors.
    #[error(
        "--input and --output both name {column:?}; a transmissibility relates two different sensors"
    )]
    SameColumn {
        /// The column.
        column: String,
    },
    /// The column of time asked for as a sensor.
    #[error("column {column:?} is time; --input and --output name sensors")]
    TimeAsSensor {
        /// The column.
        column: String,
    },
    /// A channel that is no index, or none of the file's.
    #[error(
        "{}: {option} {text:?} is none of its channels; they are called by their index, {}",
        file.display(), indices(*channels)
    )]
    NoSuchChannel {
        /// The file.
        file: PathBuf,
        /// `--input` or `--output`.
        option: &'static str,
        /// What was asked for.
        text: String,
        /// Number of channels in the file.
        channels: u64,
    },
    /// An infinite sample.
    #[error(
        "{}, sample {sample} (from 0), column {column}: {value} is not a finite number; repair it, or make it NaN to mark a gap",
        file.display()
    )]
    InfiniteSample {
        /// The file.
        file: PathBuf,
        /// Index of the sample, from 0.
        sample: u64,
        /// Index of the channel, from 0.
        column: String,
        /// What stands there.
        value: f64,
    },
    /// A file whose columns make no record.
    #[error("{}: {message}", file.display())]
    InFile {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// The records don't allow a reconstruction.
    #[error("{0}")]
    Reconstruct(String),
}

impl CommandError {
    /// Whether the reader of the output went away.
    pub(crate) fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Write { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
    }
}

/// `1 field`, `2 fields`.
fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// `0`, or `0 to 2`.
fn indices(channels: u64) -> String {
    if channels > 1 { format!("0 to {}", channels - 1) } else { "0".to_owned() }
}

fn backward(step_s: f64) -> String {
    if step_s < 0.0 {
        format!("time runs backwards by {:?} s", -step_s)
    } else {
        "time stands still, as in the row before".to_owned()
    }
}
