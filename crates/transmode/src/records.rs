//! Files -> records.

mod csv;
mod lines;
mod sampling;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use lti::SamplePeriod;
use reconstruct::{Channel, Record};

use crate::CommandError;
use csv::Columns;
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
    let columns = csv::read(file, BufReader::new(opened))?;
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
    let channels = wanted
        .iter()
        .map(|&index| Channel::new(columns.names[index].clone(), columns.values[index].clone()))
        .collect();
    let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy();
    Record::new(name, period, channels)
        .map_err(|error| CommandError::Reconstruct(error.to_string()))
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
        available: columns.names.join(", "),
    })
}

fn sample_period<R>(
    file: &Path,
    columns: &Columns<R>,
    time: usize,
) -> Result<SamplePeriod, CommandError> {
    let file = file.to_owned();
    match sampling(&columns.values[time]) {
        None => Err(CommandError::TooShort { file, found: columns.rows() }),
        Some(Sampling::Uneven { index, step_s, period_s }) => {
            Err(CommandError::Uneven { file, line: columns.line(index), step_s, period_s })
        }
        Some(Sampling::Even { period_s }) => SamplePeriod::new(period_s)
            .map_err(|error| CommandError::Reconstruct(error.to_string())),
    }
}

fn no_such_column<R>(file: &Path, columns: &Columns<R>, name: &str) -> CommandError {
    CommandError::NoSuchColumn {
        file: file.to_owned(),
        column: name.to_owned(),
        available: columns.names.join(", "),
    }
}
