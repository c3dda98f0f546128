//! Two channels of a file in memory, gaps allowed.

use std::ops::Range;
use std::path::Path;

use super::format::Format;
use super::loading::in_si;
use super::open::open;
use super::progress::Progress;
use super::segments::segments;
use super::selection::{Selection, TWICE, TimeSource};
use crate::CommandError;
use crate::error::SelectionError;

/// Two sensors of one record, equally long; a NaN marks a gap.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) format: Format,
    /// Where the file says it.
    pub(crate) period_s: Option<f64>,
    pub(crate) input: Vec<f64>,
    pub(crate) output: Vec<f64>,
    /// The stretches without a gap, in order, none empty.
    pub(crate) stretches: Vec<Range<usize>>,
}

/// Reads the channels `input` and `output` of a file. Its time must advance evenly, but for gaps; only text must have one.
pub(crate) fn load(
    file: &Path,
    [input, output]: [&str; 2],
    time: Option<&str>,
    progress: Progress,
) -> Result<Pair, CommandError> {
    let time = time.map_or(TimeSource::UsualOrUnknown, |name| TimeSource::Column(name.to_owned()));
    let selection = Selection { outputs: vec![input.to_owned(), output.to_owned()], time };
    let opened = open(file, progress)?;
    let selected = selection.select(file, opened.format(), opened.headings());
    let selected = selected.map_err(|error| match error {
        CommandError::Selection(SelectionError::BadOutputs { column, why: TWICE }) => {
            CommandError::SameColumn { column }
        }
        CommandError::Selection(SelectionError::BadOutputs { column, .. }) => {
            CommandError::TimeAsSensor { column }
        }
        other => other,
    })?;
    let (table, times) = in_si(file, opened, &selected, &selection.time)?;
    let rows = 0..times.samples();
    let even = times.sampling(file, &table, rows.clone())?;
    let channels: Vec<&[f64]> = table.values.iter().map(Vec::as_slice).collect();
    let stretches = segments(rows, &even.after_gaps, &channels);
    let mut values = table.values.into_iter();
    let (input, output) = (values.next().unwrap_or_default(), values.next().unwrap_or_default());
    let period_s = selected.time.map(|_| even.period_s);
    Ok(Pair { format: table.format, period_s, input, output, stretches })
}

#[cfg(test)]
mod tests;
