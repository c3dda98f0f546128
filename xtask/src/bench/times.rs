//! Tables of times, and how many times faster we are than a peer.

use report::{Block, Column, Table};

use super::peers::Answer;
use super::timing::Timing;
use crate::TaskError;
use crate::shared::asked::{Asked, Row};

/// How many times faster `ours` is than a peer, or why nobody knows.
pub(crate) fn speedup(what: impl Into<String>, least: f64, peer: &Answer, ours: &Timing) -> Row {
    match peer {
        Answer::Measured { timing, .. } => {
            Row::new(what, Asked::AtLeast(least), timing.median() / ours.median(), times)
        }
        Answer::Unavailable(reason) => {
            Row::unknown(what, format!("at least {}", times(least)), reason)
        }
    }
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
mod tests {
    use super::*;

    #[test]
    fn a_speedup_is_their_time_over_ours() {
        let timing = |seconds| Timing::new(vec![seconds]).unwrap();
        let row = |peer| format!("{:?}", speedup("x", 40.0, peer, &timing(0.05)));
        let peer = Answer::Measured { timing: timing(2.4), theta: vec![], warning: 0 };
        let expected = |reached: &str, verdict: &str| {
            format!(
                "Row {{ what: \"x\", asked: \"at least 40.0 x\", reached: \"{reached}\", verdict: \"{verdict}\" }}"
            )
        };
        assert_eq!(row(&peer), expected("48.0 x", "yes"));
        let none = Answer::Unavailable("no numpy".to_owned());
        assert_eq!(row(&none), expected("no numpy", "not measured"));
    }
}
