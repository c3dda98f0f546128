//! The times of the samples of a table, and what is wrong with them in terms of the file.

use std::ops::Range;
use std::path::Path;

use super::clock::{Basis, Clock};
use super::clock_fit::{Assumed, ClockFit};
use super::sampling::{self, Even, Fault, Sampling};
use super::selection::TimeSource;
use super::table::Table;
use super::{clock_fit, clock_unit};
use crate::CommandError;
use crate::error::{Others, TimeError};

/// Where in time the samples of a file are.
#[derive(Clone, Debug)]
pub(crate) enum Times {
    /// Time stamps in seconds, finite, with their column.
    Stamps { column: TimeColumn, stamps_s: Vec<f64> },
    /// Equal steps.
    Even { start_s: f64, period_s: f64, samples: usize, clock: Clock },
}

/// What is known of a column of time.
#[derive(Clone, Debug)]
pub(crate) struct TimeColumn {
    name: String,
    /// Whether all its numbers are whole.
    is_whole: bool,
    /// The factor to seconds of the unit in its heading.
    stated: Option<f64>,
    /// The unit taken where none is stated, because its numbers count from 1970.
    taken: Option<&'static str>,
    /// Whether it was written as a clock shows it.
    is_clock: bool,
}

/// The steps between samples, and what they were taken for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Steps {
    pub(crate) even: Even,
    pub(crate) clock: Clock,
    /// Whether the stamps alone do not say the period, so that a person should know of it.
    pub(crate) is_assumed: bool,
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
            return Ok(Self::Even { start_s: 0.0, period_s, samples, clock: Clock::GIVEN });
        };
        let last = table.values.len() - 1;
        let heading = table.heading(last);
        let (name, has_unit) = (heading.name.clone(), heading.unit.is_some());
        let mut stamps_s = table.values.pop().unwrap_or_default();
        table.chosen.pop();
        table.leave_out_repeats(&mut stamps_s);
        if let Some(row) = stamps_s.iter().position(|stamp| stamp.is_nan()) {
            let place = table.places.of(row);
            let column = name;
            return Err(TimeError::Missing { file: file.to_owned(), place, column }.into());
        }
        let is_whole = stamps_s.iter().all(|stamp| stamp.fract().abs() <= 0.0);
        let first = stamps_s.first().copied().unwrap_or(0.0);
        let step = sampling::usual_step(&stamps_s).unwrap_or(0.0);
        let epoch = clock_unit::epoch(first, is_whole)
            .or_else(|| clock_unit::spreadsheet_days(first, step, is_whole))
            .filter(|_| !has_unit);
        scale(&mut stamps_s, epoch.map_or(factor, |(_, factor)| factor));
        let column = TimeColumn {
            name,
            is_whole,
            stated: has_unit.then_some(factor),
            taken: epoch.map(|(unit, _)| unit),
            is_clock: table.with_clock,
        };
        Ok(Self::Stamps { column, stamps_s })
    }

    /// What a person should know of the unit of the stamps, whose period this is.
    pub(crate) fn unit_note(&self, period_s: f64) -> Option<String> {
        let Self::Stamps { column, .. } = self else { return None };
        let name = &column.name;
        if let Some(unit) = column.taken {
            let from = if unit == "days" { "1900, as spreadsheets do," } else { "1970" };
            return Some(format!("{name} counts from {from} and is taken to be in {unit}"));
        }
        let doubt = clock_unit::doubt(period_s, column.is_whole, column.stated);
        doubt.filter(|_| !column.is_clock).map(|doubt| {
            let unit = if column.stated.is_some() { "" } else { ", which states no unit," };
            format!("{name}{unit} gives a period of {period_s} s; it would be {doubt}")
        })
    }

    /// The time of a sample.
    pub(crate) fn at(&self, row: usize) -> f64 {
        match self {
            Self::Stamps { stamps_s, .. } => stamps_s[row],
            Self::Even { start_s, period_s, .. } => start_s + row as f64 * period_s,
        }
    }

    /// The rows that are not in the file in front of a row behind a gap. A clock that was started again has no whole number of them, and no gap of its is bridged.
    pub(crate) fn absent(&self, row: usize, period_s: f64) -> usize {
        let steps = (self.at(row) - self.at(row.saturating_sub(1))) / period_s;
        if sampling::is_new_start(steps) {
            return usize::MAX / 2;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "what is too large stays the largest number there is"
        )]
        let absent = (steps.round() - 1.0).max(1.0) as usize;
        absent
    }

    pub(crate) fn samples(&self) -> usize {
        match self {
            Self::Stamps { stamps_s, .. } => stamps_s.len(),
            Self::Even { samples, .. } => *samples,
        }
    }

    /// Whether they are those of interpolated samples.
    pub(crate) fn is_resampled(&self) -> bool {
        matches!(self, Self::Even { clock, .. } if clock.basis == Basis::Resampled)
    }

    /// The samples from `start_s` to `end_s`, both included, but for rounding of the stamps.
    pub(crate) fn within(&self, start_s: Option<f64>, end_s: Option<f64>) -> Range<usize> {
        // Stamps from 1970 on are large numbers, and their steps are not.
        let count = self.samples();
        let step_s = match count {
            0 | 1 => 0.0,
            _ => (self.at(count - 1) - self.at(0)) / (count - 1) as f64,
        };
        let slack = |edge: f64| (1e-9 * (1.0 + edge.abs())).min(step_s.abs() / 4.0);
        let from = start_s.map_or(f64::NEG_INFINITY, |start| start - slack(start));
        let to = end_s.map_or(f64::INFINITY, |end| end + slack(end));
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
    ) -> Result<Steps, CommandError> {
        let first = rows.start;
        let (column, stamps_s) = match self {
            Self::Even { period_s, clock, .. } => {
                let even = Even { period_s: *period_s, jitter: 0.0, after_gaps: Vec::new() };
                return Ok(Steps { even, clock: *clock, is_assumed: false });
            }
            Self::Stamps { column, stamps_s } => (&column.name, &stamps_s[rows]),
        };
        let file = file.to_owned();
        let place = |index: usize| table.places.of(first + index);
        let others = |fault: &Fault| {
            let named = fault.others.iter().map(|index| place(*index)).collect();
            Others { named, count: fault.other_count }
        };
        let judged = sampling::sampling(stamps_s);
        if let Some(Sampling::Uneven(_) | Sampling::Backward(_)) = &judged
            && let Some(mut steps) = fitted(stamps_s)
        {
            steps.even.after_gaps.iter_mut().for_each(|gap| *gap += first);
            return Ok(steps);
        }
        if let Some(Sampling::Even(even)) = &judged
            && let Some(fit) = clock_fit::without_gaps_if_many(stamps_s, even.after_gaps.len())
        {
            return Ok(assumed(fit));
        }
        match judged {
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
                let fit = clock_fit::of_even(stamps_s, even.period_s, &even.after_gaps);
                even.after_gaps.iter_mut().for_each(|gap| *gap += first);
                let basis = match fit.as_ref().map(|fit| fit.assumed) {
                    Some(rounded @ Assumed::Rounded { .. }) => rounded.into(),
                    _ => Basis::EvenStamps,
                };
                let clock = Clock {
                    basis,
                    fitted_period_s: fit.as_ref().map(|fit| fit.period_s),
                    largest_deviation_s: fit.map(|fit| fit.largest_deviation_s),
                };
                Ok(Steps { even, clock, is_assumed: false })
            }
        }
    }
}

/// The period behind stamps that are not even by themselves.
fn fitted(stamps_s: &[f64]) -> Option<Steps> {
    let fit = clock_fit::fit(stamps_s).filter(|fit| sampling::is_period(fit.period_s))?;
    Some(assumed(fit))
}

fn assumed(fit: ClockFit) -> Steps {
    let jitter = fit.largest_deviation_s / fit.period_s;
    let even = Even { period_s: fit.period_s, jitter, after_gaps: fit.after_gaps };
    let clock = Clock {
        basis: fit.assumed.into(),
        fitted_period_s: Some(fit.period_s),
        largest_deviation_s: Some(fit.largest_deviation_s),
    };
    Steps { even, clock, is_assumed: true }
}

/// Adds, unless that would change nothing.
pub(crate) fn shift(values: &mut [f64], offset: f64) {
    if offset.abs() > 0.0 {
        values.iter_mut().for_each(|value| *value += offset);
    }
}

/// Multiplies, unless that would change nothing.
pub(crate) fn scale(values: &mut [f64], factor: f64) {
    if (factor - 1.0).abs() > 0.0 {
        values.iter_mut().for_each(|value| *value *= factor);
    }
}
