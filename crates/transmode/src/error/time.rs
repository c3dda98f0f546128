//! What can be wrong with time stamps.

use std::path::PathBuf;

use crate::numbers::counted;

/// Why time stamps give no evenly sampled record: one sentence with the place and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TimeError {
    /// No column looks like time.
    #[error(
        "{}: none of its columns ({available}) is called time, t or timestamp; name it with --time, or give --sample-period",
        file.display()
    )]
    NoColumn {
        /// The file.
        file: PathBuf,
        /// The names that are there.
        available: String,
    },
    /// A time stamp that is missing.
    #[error("{}, {place}, column {column:?}: the time is missing; repair or remove the row", file.display())]
    Missing {
        /// The file.
        file: PathBuf,
        /// The row.
        place: String,
        /// The column of time.
        column: String,
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
        "{}, {place}: time advances by {step_s:?} s, elsewhere by {period_s:?} s{}; \
         cut the record there, or interpolate it to equal steps with --resample PERIOD",
        file.display(), more(others)
    )]
    Uneven {
        /// The file.
        file: PathBuf,
        /// The row that comes too early or too late.
        place: String,
        /// The step before it, in seconds.
        step_s: f64,
        /// The usual step, in seconds.
        period_s: f64,
        /// The next rows at fault, and how many there are in all.
        others: Others,
    },
    /// Time that stands still or runs backwards.
    #[error(
        "{}, {place}: {}{}; put the rows in order of time or cut the record there",
        file.display(), backward(*step_s), more(others)
    )]
    Backward {
        /// The file.
        file: PathBuf,
        /// The row that is no later than the one before.
        place: String,
        /// The step before it, in seconds: zero or less.
        step_s: f64,
        /// The next rows at fault, and how many there are in all.
        others: Others,
    },
    /// A period to interpolate to that leaves no record.
    #[error(
        "{}: --resample {period_s:?} leaves no record: its channels have fewer than 2 or far too many such periods in common; \
         give a period near that of the samples, in seconds",
        file.display()
    )]
    Resampling {
        /// The file.
        file: PathBuf,
        /// The period asked for, in seconds.
        period_s: f64,
    },
    /// Steps of time that are no sample period.
    #[error(
        "{}, column {column:?}: time advances by {period_s:?} s; \
         time in seconds with steps from 1e-12 s to 1e12 s is needed, or its unit in the header, as in time [ms]",
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
}

/// Rows at fault behind the first one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Others {
    /// The places of the next few.
    pub named: Vec<String>,
    /// How many there are, the named ones included.
    pub count: usize,
}

fn more(others: &Others) -> String {
    if others.count == 0 {
        return String::new();
    }
    let unnamed = others.count - others.named.len().min(others.count);
    let rest = if unnamed > 0 { format!(" and {unnamed} more") } else { String::new() };
    format!(" (likewise {}{rest})", others.named.join(", "))
}

fn backward(step_s: f64) -> String {
    if step_s < 0.0 {
        format!("time runs backwards by {:?} s", -step_s)
    } else {
        "time stands still, as in the row before".to_owned()
    }
}
