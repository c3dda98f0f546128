//! Tables of figures: what was asked for beside what was reached.

use report::{Block, Column, Table};

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_verdict_follows_from_the_figure() {
        for (asked, reached, verdict) in [
            (Asked::AtLeast(40.0), 40.0, "yes"),
            (Asked::AtLeast(40.0), 39.9, "**no**"),
            (Asked::AtMost(1e-9), 1e-10, "yes"),
            (Asked::AtMost(1e-9), 2e-9, "**no**"),
            (Asked::Within(0.95, 1.05), 1.0, "yes"),
            (Asked::Within(0.95, 1.05), 1.06, "**no**"),
            // What is no number reaches nothing.
            (Asked::AtLeast(0.0), f64::NAN, "**no**"),
            (Asked::AtMost(1.0), f64::NAN, "**no**"),
        ] {
            let row = Row::new("x", asked, reached, |x| x.to_string());
            assert_eq!(row.verdict, verdict, "{asked:?} {reached}");
        }
    }
}
