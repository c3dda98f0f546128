//! Files -> records.

pub(crate) mod binary;
pub(crate) mod blocks;
mod csv;
pub(crate) mod format_error;
mod lines;
pub(crate) mod npy;
pub(crate) mod pair;
pub(crate) mod raw;
pub(crate) mod runs;
mod sampling;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use lti::SamplePeriod;
use reconstruct::{Channel, Record};

use crate::CommandError;
use csv::{Columns, Missing};
use sampling::{Sampling, sampling};

/// Which columns of a file to use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Selection {
    /// The sensors in the order wanted; all columns but time if empty.
    pub(crate) outputs: Vec<String>,
    /// The column of time; the one called `time` or `t` if absent.
    pub(crate) time: Option<String>,
}

impl Selection {
    /// Refuses an outputs list that no file could satisfy.
    pub(crate) fn check(&self) -> Result<(), CommandError> {
        for (index, column) in self.outputs.iter().enumerate() {
            let fault = |why| Err(CommandError::BadOutputs { column: column.clone(), why });
            if column.is_empty() {
                return fault("as a sensor; separate the names by single commas");
            }
            if self.outputs[..index].contains(column) {
                return fault("twice");
            }
            if self.time.as_ref() == Some(column) {
                return fault("as a sensor and --time as time");
            }
        }
        Ok(())
    }
}

/// Reads one file as one record, called like the file without its folder.
pub(crate) fn load(file: &Path, selection: &Selection) -> Result<Record, CommandError> {
    let opened =
        File::open(file).map_err(|source| CommandError::Read { file: file.to_owned(), source })?;
    let columns = csv::read(file, BufReader::new(opened), Missing::IsFault)?;
    record(file, columns, selection)
}

fn record<R>(
    file: &Path,
    columns: Columns<R>,
    selection: &Selection,
) -> Result<Record, CommandError> {
    let time = time_column(file, &columns, selection)?;
    let period = sample_period(file, &columns, time)?;
    let wanted = if selection.outputs.is_empty() {
        (0..columns.names.len()).filter(|index| *index != time).collect()
    } else {
        let find = |name: &String| {
            columns.position(name).ok_or_else(|| no_such_column(file, &columns, name))
        };
        selection.outputs.iter().map(find).collect::<Result<Vec<_>, _>>()?
    };
    if wanted.contains(&time) {
        let column = columns.names[time].clone();
        return Err(CommandError::BadOutputs {
            column,
            why: "as a sensor, but it is the column of time",
        });
    }
    if wanted.is_empty() {
        let message = "time is its only column; sensors are needed as well".to_owned();
        return Err(CommandError::InFile { file: file.to_owned(), message });
    }
    let channels = wanted
        .iter()
        .map(|&index| Channel::new(columns.names[index].clone(), columns.values[index].clone()))
        .collect();
    let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy();
    Record::new(name, period, channels).map_err(|error| in_file(file, &error))
}

fn time_column<R>(
    file: &Path,
    columns: &Columns<R>,
    selection: &Selection,
) -> Result<usize, CommandError> {
    if let Some(name) = &selection.time {
        return columns.position(name).ok_or_else(|| no_such_column(file, columns, name));
    }
    let is_time =
        |name: &String| name.eq_ignore_ascii_case("time") || name.eq_ignore_ascii_case("t");
    columns.names.iter().position(is_time).ok_or_else(|| CommandError::NoTimeColumn {
        file: file.to_owned(),
        available: listed(&columns.names),
    })
}

fn sample_period<R>(
    file: &Path,
    columns: &Columns<R>,
    time: usize,
) -> Result<SamplePeriod, CommandError> {
    let owned = || file.to_owned();
    match sampling(&columns.values[time]) {
        None => Err(CommandError::TooShort { file: owned(), found: columns.rows() }),
        Some(Sampling::Uneven { index, step_s, period_s }) => {
            Err(CommandError::Uneven { file: owned(), line: columns.line(index), step_s, period_s })
        }
        Some(Sampling::Backward { index, step_s }) => {
            Err(CommandError::Backward { file: owned(), line: columns.line(index), step_s })
        }
        Some(Sampling::OutOfRange { period_s }) => Err(CommandError::SamplePeriod {
            file: owned(),
            column: columns.names[time].clone(),
            period_s,
        }),
        Some(Sampling::Even { period_s }) => {
            SamplePeriod::new(period_s).map_err(|error| in_file(file, &error))
        }
    }
}

pub(crate) fn in_file(file: &Path, error: &dyn std::error::Error) -> CommandError {
    CommandError::InFile { file: file.to_owned(), message: error.to_string() }
}

/// Names for a message; one that is empty would not be seen.
fn listed(names: &[String]) -> String {
    let shown = |name: &String| if name.is_empty() { "\"\"".to_owned() } else { name.clone() };
    names.iter().map(shown).collect::<Vec<_>>().join(", ")
}

fn no_such_column<R>(file: &Path, columns: &Columns<R>, name: &str) -> CommandError {
    CommandError::NoSuchColumn {
        file: file.to_owned(),
        column: name.to_owned(),
        available: listed(&columns.names),
    }
}
