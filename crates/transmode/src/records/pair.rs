//! Two channels of a file in memory, gaps allowed.

use std::ops::Range;
use std::path::Path;

use super::format::Format;
use super::loading::in_si;
use super::notes;
use super::open::open;
use super::options::ReadOptions;
use super::progress::Progress;
use super::resampling;
use super::segments::segments;
use super::selection::{Selection, TWICE, TimeSource};
use super::timing::Steps;
use super::warning::LoadWarning;
use crate::CommandError;
use crate::error::SelectionError;

/// Two sensors of one record, equally long; a NaN marks a gap.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) format: Format,
    /// Where the file or an option says it.
    pub(crate) period_s: Option<f64>,
    pub(crate) input: Vec<f64>,
    pub(crate) output: Vec<f64>,
    /// The stretches without a gap, in order, none empty.
    pub(crate) stretches: Vec<Range<usize>>,
    pub(crate) warnings: Vec<LoadWarning>,
}

/// How two sensors are read.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairOptions {
    pub(crate) time: TimeSource,
    pub(crate) reading: ReadOptions,
    /// The period to which samples are interpolated, in seconds.
    pub(crate) resample_s: Option<f64>,
}

/// Reads the channels `input` and `output` of a file. Its time must advance evenly, but for gaps; only text must have one.
pub(crate) fn load(
    file: &Path,
    [input, output]: [&str; 2],
    options: &PairOptions,
    progress: Progress,
) -> Result<Pair, CommandError> {
    let outputs = vec![input.to_owned(), output.to_owned()];
    let selection = Selection { outputs, time: options.time.clone(), lenient: false };
    let opened = open(file, &options.reading, progress)?;
    let selected = selection.select(file, opened.format(), opened.headings());
    let mut selected = selected.map_err(|error| match error {
        CommandError::Selection(SelectionError::BadOutputs { column, why: TWICE }) => {
            CommandError::SameColumn { column }
        }
        CommandError::Selection(SelectionError::BadOutputs { column, .. }) => {
            CommandError::TimeAsSensor { column }
        }
        other => other,
    })?;
    let (mut table, mut times) = in_si(file, opened, &mut selected, &selection)?;
    let mut warnings = notes::of_columns(file, &table, &selected, &selection);
    warnings.extend(notes::unwrap(file, &mut table, &selected));
    let record = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
    if let Some(period_s) = options.resample_s {
        (table, times) = resampling::of_table(file, &table, &times, 0..times.samples(), period_s)?;
        warnings.push(LoadWarning::Resampled { record: record.clone(), period_s });
    }
    let rows = 0..times.samples();
    let Steps { even, clock, is_assumed } = times.sampling(file, &table, rows.clone())?;
    if is_assumed {
        warnings.push(LoadWarning::Clock { record, period_s: even.period_s, clock });
    }
    if let Some(text) = times.unit_note(even.period_s) {
        warnings.push(LoadWarning::ClockUnit { file: file.to_owned(), text });
    }
    let channels: Vec<&[f64]> = table.values.iter().map(Vec::as_slice).collect();
    let stretches = segments(rows, &even.after_gaps, &channels);
    let format = table.format;
    let mut values = table.values.into_iter();
    let (input, output) = (values.next().unwrap_or_default(), values.next().unwrap_or_default());
    let is_known = selected.time.is_some()
        || options.resample_s.is_some()
        || matches!(options.time, TimeSource::Period(_));
    let period_s = is_known.then_some(even.period_s);
    Ok(Pair { format, period_s, input, output, stretches, warnings })
}

#[cfg(test)]
mod tests;
