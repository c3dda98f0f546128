//! Two columns of a CSV file, gaps allowed.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use lti::SamplePeriod;

use super::csv::{self, Columns, Missing};
use super::{Selection, no_such_column, sample_period, time_column};
use crate::CommandError;

/// Two sensors of one record, equally long; a NaN marks a gap.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) period: SamplePeriod,
    pub(crate) input: Vec<f64>,
    pub(crate) output: Vec<f64>,
}

/// Reads the columns `input` and `output` of a file. Its time must advance evenly, gaps included.
pub(crate) fn load(
    file: &Path,
    input: &str,
    output: &str,
    time: Option<&str>,
) -> Result<Pair, CommandError> {
    let opened =
        File::open(file).map_err(|source| CommandError::Read { file: file.to_owned(), source })?;
    let columns = csv::read(file, BufReader::new(opened), Missing::IsGap)?;
    pair(file, columns, [input, output], time)
}

fn pair<R: Read>(
    file: &Path,
    mut columns: Columns<R>,
    wanted: [&str; 2],
    time: Option<&str>,
) -> Result<Pair, CommandError> {
    let selection = Selection { outputs: Vec::new(), time: time.map(str::to_owned) };
    let time = time_column(file, &columns, &selection)?;
    if let Some(row) = columns.values[time].iter().position(|stamp| stamp.is_nan()) {
        return Err(CommandError::NotANumber {
            file: file.to_owned(),
            line: columns.line(row),
            column: columns.names[time].clone(),
            text: "NaN".to_owned(),
        });
    }
    let period = sample_period(file, &columns, time)?;
    let mut take = |name: &str| {
        let index = columns.position(name).ok_or_else(|| no_such_column(file, &columns, name))?;
        if index == time {
            return Err(CommandError::TimeAsSensor { column: name.to_owned() });
        }
        Ok(std::mem::take(&mut columns.values[index]))
    };
    let (input, output) = (take(wanted[0])?, take(wanted[1])?);
    Ok(Pair { period, input, output })
}

#[cfg(test)]
mod tests;
