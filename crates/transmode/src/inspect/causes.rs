//! What is odd about the sensors of a record, as a reason why a result is doubtful.

use reconstruct::Record;

use super::file::Channel;
use super::signal::Signal;
use super::verdict::{self, Verdict};
use crate::numbers::{rounded, without_rounding};

/// Something odd about one sensor in one record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Cause {
    /// The record's name.
    pub(crate) record: String,
    pub(crate) column: String,
    /// The code that `inspect` has for it.
    pub(crate) code: &'static str,
    /// A clause that begins with the column and ends with the record.
    pub(crate) text: String,
}

/// What is odd about the sensors of a record as it was read, of which the first sample was taken at that time. Units are those after conversion.
pub(crate) fn causes(record: &Record, units: &[Option<&'static str>], start_s: f64) -> Vec<Cause> {
    let marked = record.marked();
    let values: Vec<&[f64]> = marked.iter().map(|channel| channel.values.as_slice()).collect();
    let period_s = record.period().seconds();
    let channel = |(index, own): (usize, &reconstruct::Channel)| Channel {
        name: own.name.clone(),
        unit: None,
        si: units.get(index).copied().flatten(),
        signal: Signal::of(&own.values),
        verdict: None,
    };
    let mut channels: Vec<Channel> = marked.iter().enumerate().map(channel).collect();
    verdict::judge(&mut channels, &values, Some(period_s));
    let mut found = Vec::new();
    for own in &channels {
        let samples = record.samples() as f64;
        let mut add = |code: &'static str, text: String| {
            let text = format!("{} {text} in {}", own.name, record.name());
            let (record, column) = (record.name().to_owned(), own.name.clone());
            found.push(Cause { record, column, code, text });
        };
        match &own.verdict {
            Some(Verdict::Constant) => add("dead", "is constant".to_owned()),
            Some(Verdict::Counter) => {
                add("counter", "counts up evenly, as no sensor does,".to_owned());
            }
            Some(Verdict::Held { rows }) => add(
                "held",
                format!(
                    "holds each value for {rows} rows, as a sensor of a lower rate does (--resample),"
                ),
            ),
            Some(Verdict::Wraps { turn }) => {
                add("wraps", format!("jumps by a turn of {} (--unwrap)", rounded(*turn, 4)));
            }
            Some(Verdict::Copy { of, factor }) => {
                add("duplicate", format!("is {} times {of}", rounded(*factor, 4)));
            }
            Some(Verdict::Derivative { of, .. }) => add(
                "derivative",
                format!(
                    "is the rate of change of {of}, and has no noise of its own if it was computed from it,"
                ),
            ),
            Some(Verdict::Time | Verdict::NotRead { .. }) | None => {}
        }
        let cut_off = &own.signal.cut_off;
        if !cut_off.is_empty() {
            let count: usize = cut_off.iter().map(|(_, count)| count).sum();
            let part = rounded(100.0 * count as f64 / samples, 2);
            let ends: Vec<String> =
                cut_off.iter().map(|(end, _)| rounded(*end, 4).to_string()).collect();
            add(
                "saturated",
                format!("is cut off at {} in {part} % of its samples", ends.join(" and ")),
            );
        }
        let stands = !matches!(own.verdict, Some(Verdict::Held { .. } | Verdict::Counter));
        if let (Some((row, length)), true) = (own.signal.stuck, stands) {
            let from_s = without_rounding(start_s + row as f64 * period_s);
            add(
                "stuck",
                format!("stands still for {length} samples from {} s on", rounded(from_s, 6)),
            );
        }
        if own.signal.outlier_count > 0 && !matches!(own.verdict, Some(Verdict::Wraps { .. })) {
            let (count, noun) = match own.signal.outlier_count {
                1 => (1, "outlier"),
                count => (count, "outliers"),
            };
            add("outliers", format!("has {count} {noun}"));
        }
    }
    found
}

#[cfg(test)]
mod tests;
