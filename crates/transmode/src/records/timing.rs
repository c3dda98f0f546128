//! The times of the samples of a table, and what is wrong with them in terms of the file.

use std::ops::Range;
use std::path::Path;

use super::sampling::{self, Even, Fault, Sampling};
use super::selection::TimeSource;
use super::table::Table;
use crate::CommandError;
use crate::error::{Others, TimeError};

/// Where in time the samples of a file are.
#[derive(Clone, Debug)]
pub(crate) enum Times {
    /// Time stamps in seconds, finite, with the name of their column.
    Stamps { column: String, stamps_s: Vec<f64> },
    /// Equal steps from zero on.
    Even { period_s: f64, samples: usize },
}

impl Times {
    /// Takes the column of time, the last of the table's, if the times are to come from one.
    pub(crate) fn take(
        file: &Path,
        table: &mut Table,
        factor: Option<f64>,
        source: &TimeSource,
    ) -> Result<Self, CommandError> {
        let samples = table.rows();
        let Some(factor) = factor else {
            let period_s = if let TimeSource::Period(period_s) = source { *period_s } else { 1.0 };
            return Ok(Self::Even { period_s, samples });
        };
        let last = table.values.len() - 1;
        let column = table.heading(last).name.clone();
        let mut stamps_s = table.values.pop().unwrap_or_default();
        table.chosen.pop();
        if let Some(row) = stamps_s.iter().position(|stamp| stamp.is_nan()) {
            let place = table.places.of(row);
            return Err(TimeError::Missing { file: file.to_owned(), place, column }.into());
        }
        scale(&mut stamps_s, factor);
        Ok(Self::Stamps { column, stamps_s })
    }

    /// The time of a sample.
    pub(crate) fn at(&self, row: usize) -> f64 {
        match self {
            Self::Stamps { stamps_s, .. } => stamps_s[row],
            Self::Even { period_s, .. } => row as f64 * period_s,
        }
    }

    pub(crate) fn samples(&self) -> usize {
        match self {
            Self::Stamps { stamps_s, .. } => stamps_s.len(),
            Self::Even { samples, .. } => *samples,
        }
    }

    /// The samples from `start_s` to `end_s`, both included, but for rounding of the stamps.
    pub(crate) fn within(&self, start_s: Option<f64>, end_s: Option<f64>) -> Range<usize> {
        let slack = |edge: f64| 1e-9 * (1.0 + edge.abs());
        let from = start_s.map_or(f64::NEG_INFINITY, |start| start - slack(start));
        let to = end_s.map_or(f64::INFINITY, |end| end + slack(end));
        let count = self.samples();
        let start = (0..count).find(|row| self.at(*row) >= from).unwrap_or(count);
        let end = (start..count).find(|row| self.at(*row) > to).unwrap_or(count);
        start..end
    }

    /// Whether a window starts or ends more than a step outside of the samples.
    pub(crate) fn reaches_beyond(&self, start_s: Option<f64>, end_s: Option<f64>) -> bool {
        let Some(last) = self.samples().checked_sub(1).filter(|last| *last > 0) else {
            return false;
        };
        let [first_s, last_s] = [0, last].map(|row| self.at(row));
        let step_s = (last_s - first_s) / last as f64;
        start_s.is_some_and(|start| start < first_s - step_s)
            || end_s.is_some_and(|end| end > last_s + step_s)
    }

    /// The period of these samples and their gaps, as indices from the start of the file.
    pub(crate) fn sampling(
        &self,
        file: &Path,
        table: &Table,
        rows: Range<usize>,
    ) -> Result<Even, CommandError> {
        let first = rows.start;
        let (column, stamps_s) = match self {
            Self::Even { period_s, .. } => {
                return Ok(Even { period_s: *period_s, jitter: 0.0, after_gaps: Vec::new() });
            }
            Self::Stamps { column, stamps_s } => (column, &stamps_s[rows]),
        };
        let file = file.to_owned();
        let place = |index: usize| table.places.of(first + index);
        let others = |fault: &Fault| {
            let named = fault.others.iter().map(|index| place(*index)).collect();
            Others { named, count: fault.other_count }
        };
        match sampling::sampling(stamps_s) {
            None => Err(TimeError::TooShort { file, found: stamps_s.len() }.into()),
            Some(Sampling::Uneven(fault)) => {
                let (place, others) = (place(fault.index), others(&fault));
                let Fault { step_s, period_s, .. } = fault;
                Err(TimeError::Uneven { file, place, step_s, period_s, others }.into())
            }
            Some(Sampling::Backward(fault)) => {
                let (place, others) = (place(fault.index), others(&fault));
                Err(TimeError::Backward { file, place, step_s: fault.step_s, others }.into())
            }
            Some(Sampling::OutOfRange { period_s }) => {
                Err(TimeError::SamplePeriod { file, column: column.clone(), period_s }.into())
            }
            Some(Sampling::Even(mut even)) => {
                even.after_gaps.iter_mut().for_each(|gap| *gap += first);
                Ok(even)
            }
        }
    }
}

/// Multiplies, unless that would change nothing.
pub(crate) fn scale(values: &mut [f64], factor: f64) {
    if (factor - 1.0).abs() > 0.0 {
        values.iter_mut().for_each(|value| *value *= factor);
    }
}
