//! Tables of what was asked for beside what was reached.

use report::{Block, Column, Table};

use super::peers::Answer;
use super::timing::Timing;
use crate::TaskError;

/// A figure to reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Asked {
    AtLeast(f64),
    AtMost(f64),
    /// Between these two.
    Within(f64, f64),
}

impl Asked {
    fn holds(self, reached: f64) -> bool {
        match self {
            Self::AtLeast(least) => reached >= least,
            Self::AtMost(most) => reached <= most,
            Self::Within(low, high) => (low..=high).contains(&reached),
        }
    }
}

/// One line of such a table.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    what: String,
    asked: String,
    reached: String,
    verdict: &'static str,
}

impl Row {
    /// A figure, and how it is written.
    pub(crate) fn new(
        what: impl Into<String>,
        asked: Asked,
        reached: f64,
        show: impl Fn(f64) -> String,
    ) -> Self {
        let asked_text = match asked {
            Asked::AtLeast(least) => format!("at least {}", show(least)),
            Asked::AtMost(most) => format!("at most {}", show(most)),
            Asked::Within(low, high) => format!("{} to {}", show(low), show(high)),
        };
        let verdict = if asked.holds(reached) { "yes" } else { "**no**" };
        Self { what: what.into(), asked: asked_text, reached: show(reached), verdict }
    }

    /// How many times faster `ours` is than a peer, or why nobody knows.
    pub(crate) fn speedup(
        what: impl Into<String>,
        least: f64,
        peer: &Answer,
        ours: &Timing,
    ) -> Self {
        match peer {
            Answer::Measured { timing, .. } => {
                Self::new(what, Asked::AtLeast(least), timing.median() / ours.median(), times)
            }
            Answer::Unavailable(reason) => Self {
                what: what.into(),
                asked: format!("at least {}", times(least)),
                reached: reason.clone(),
                verdict: "not measured",
            },
        }
    }

    /// What this machine or this command line cannot tell.
    pub(crate) fn unknown(
        what: impl Into<String>,
        asked: impl Into<String>,
        why: impl Into<String>,
    ) -> Self {
        Self {
            what: what.into(),
            asked: asked.into(),
            reached: why.into(),
            verdict: "not measured",
        }
    }
}

/// The table of asked and reached figures.
pub(crate) fn asked_and_reached(title: &str, rows: &[Row]) -> Result<Block, TaskError> {
    let header = [
        Column::left("figure"),
        Column::right("asked"),
        Column::right("reached"),
        Column::center("holds"),
    ];
    let mut table = Table::new(title, header);
    for Row { what, asked, reached, verdict } in rows {
        table
            .push([what.as_str(), asked, reached, verdict])
            .map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

/// A line of a table of times: what ran, and its times or the reason why there are none.
pub(crate) struct TimeRow {
    pub(crate) what: String,
    pub(crate) result: Result<Timing, String>,
    pub(crate) remark: String,
}

impl TimeRow {
    pub(crate) fn ours(
        what: impl Into<String>,
        timing: &Timing,
        remark: impl Into<String>,
    ) -> Self {
        Self { what: what.into(), result: Ok(timing.clone()), remark: remark.into() }
    }

    pub(crate) fn peer(
        what: impl Into<String>,
        answer: &Answer,
        remark: impl Into<String>,
    ) -> Self {
        let result = match answer {
            Answer::Measured { timing, .. } => Ok(timing.clone()),
            Answer::Unavailable(reason) => Err(reason.clone()),
        };
        Self { what: what.into(), result, remark: remark.into() }
    }
}

/// A table of times.
pub(crate) fn times_table(title: &str, rows: &[TimeRow]) -> Result<Block, TaskError> {
    let header = [
        Column::left("what"),
        Column::right("median"),
        Column::right("spread"),
        Column::left("remark"),
    ];
    let mut table = Table::new(title, header);
    for TimeRow { what, result, remark } in rows {
        let (median, spread) = match result {
            Ok(timing) => (timing.shown(), timing.shown_spread()),
            Err(reason) => ("not measured".to_owned(), reason.clone()),
        };
        table.push([what, &median, &spread, remark]).map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

/// A ratio as people say it.
pub(crate) fn times(ratio: f64) -> String {
    format!("{} x", report::format_significant(ratio, 3))
}

/// A small number such as a relative error.
pub(crate) fn small(value: f64) -> String {
    report::format_significant(value, 2)
}

#[cfg(test)]
mod tests;
