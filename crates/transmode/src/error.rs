//! What can be wrong with the command line and with files, in full sentences.

mod option;
mod selection;
mod table;
mod time;

use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

pub(crate) use crate::simulate::SimulateError;
pub(crate) use option::OptionError;
pub(crate) use selection::SelectionError;
pub(crate) use table::TableError;
pub(crate) use time::{Others, TimeError};

/// Why a command could not be carried out: one sentence with the place and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CommandError {
    /// A file that cannot be read.
    #[error("cannot read {}: {source}; {}", file.display(), remedy_of_reading(source))]
    Read {
        /// The file.
        file: PathBuf,
        /// What the operating system says.
        source: Error,
    },
    /// A file that cannot be written.
    #[error("cannot write {}: {source}; {}", file.display(), remedy_of_writing(source))]
    Write {
        /// The file, or `-` for standard output.
        file: PathBuf,
        /// What the operating system says.
        source: Error,
    },
    /// A file that is there already.
    #[error("{} is there already; choose another folder with --output, or replace it with --force", file.display())]
    Exists {
        /// The file.
        file: PathBuf,
    },
    /// What was there before a fault and could not be put back.
    #[error(
        "cannot put {} back after another fault: {source}; it is kept as {}",
        file.display(), kept.display()
    )]
    NotRestored {
        /// The file or folder.
        file: PathBuf,
        /// Where it is now.
        kept: PathBuf,
        /// What the operating system says.
        source: Error,
    },
    /// A result that would replace the record it comes from.
    #[error("{} is the record itself; write the result to another file", file.display())]
    OverwritesRecord {
        /// The file.
        file: PathBuf,
    },
    /// A folder for a report that holds something else.
    #[error(
        "{} holds {}, which is no part of a report; name a new or an empty folder",
        folder.display(), entry.display()
    )]
    NotAReport {
        /// The folder.
        folder: PathBuf,
        /// What it holds.
        entry: PathBuf,
    },
    /// A report that cannot be drawn.
    #[error("the report cannot be drawn: {0}")]
    Report(String),
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
    /// A text that is no table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Time stamps that give no evenly sampled record.
    #[error(transparent)]
    Time(#[from] TimeError),
    /// A flight that cannot be simulated.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// Something asked for that is not there.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// An option that does not fit the records or the other options.
    #[error(transparent)]
    Option(#[from] OptionError),
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
        matches!(self, Self::Write { source, .. } if source.kind() == ErrorKind::BrokenPipe)
    }
}

/// An error of a lower layer, with the file that it is about.
pub(crate) fn in_file(file: &Path, error: &dyn std::error::Error) -> CommandError {
    CommandError::InFile { file: file.to_owned(), message: error.to_string() }
}

/// `0`, or `0 to 2`.
fn indices(channels: u64) -> String {
    if channels > 1 { format!("0 to {}", channels - 1) } else { "0".to_owned() }
}

/// What a person can do where the operating system does not let a file be read.
fn remedy_of_reading(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::NotFound => "check its name and folder",
        ErrorKind::PermissionDenied => "ask its owner for the right to read it",
        ErrorKind::IsADirectory => "name a file in it",
        ErrorKind::NotADirectory => {
            "what stands before the last slash is no folder; check the name"
        }
        ErrorKind::InvalidData | ErrorKind::UnexpectedEof => {
            "it may be damaged or cut off; copy it again"
        }
        _ => "try it again, or from a copy on another disk",
    }
}

/// What a person can do where it does not let a file or folder be written.
fn remedy_of_writing(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::NotFound => "make its folder first, or name another",
        ErrorKind::PermissionDenied => "name a place where you may write",
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
            "make room, or name a place that has some"
        }
        ErrorKind::IsADirectory => "choose another name",
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
            "a file stands where a folder is needed; choose another name"
        }
        _ => "name another place",
    }
}
