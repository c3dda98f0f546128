//! Doubts in the words of the result: what is said of many stretches of one record is said once.

use reconstruct::{Doubt, Record};

use super::outcome::Outcome;
use crate::inspect::Cause;

/// A doubt, or several of one kind about the stretches of one record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Said {
    pub(super) code: &'static str,
    pub(super) text: String,
    /// What is odd about the sensors of the records that it speaks of, or of all records.
    pub(super) causes: Vec<Cause>,
}

/// All doubts, in their order.
pub(super) fn said(outcome: &Outcome<'_>) -> Vec<Said> {
    let doubts = outcome.result.doubts.iter();
    let mut all =
        collected(doubts.map(|doubt: &Doubt| (doubt.code(), doubt.to_string())), outcome.records);
    for said in &mut all {
        said.causes = causes(&said.text, outcome.causes);
    }
    all
}

/// The causes that stand behind all these doubts, each once.
pub(super) fn all_causes(doubts: &[Said]) -> Vec<&Cause> {
    let mut found: Vec<&Cause> = Vec::new();
    for cause in doubts.iter().flat_map(|said| &said.causes) {
        if !found.contains(&cause) {
            found.push(cause);
        }
    }
    found
}

/// Of what is odd that in the records which a text names, or all where it names none of them.
fn causes(text: &str, odd: &[Cause]) -> Vec<Cause> {
    let named: Vec<Cause> =
        odd.iter().filter(|cause| is_named(text, &cause.record)).cloned().collect();
    if named.is_empty() { odd.to_vec() } else { named }
}

/// Whether a text speaks of a record; `a.csv#1` is not in `a.csv#12`.
fn is_named(text: &str, record: &str) -> bool {
    text.match_indices(record)
        .any(|(at, _)| !text[at + record.len()..].starts_with(|next: char| next.is_ascii_digit()))
}

/// The first of those about the stretches of one record stands for the others.
fn collected(
    doubts: impl Iterator<Item = (&'static str, String)>,
    records: &[Record],
) -> Vec<Said> {
    let mut found: Vec<(Said, Option<String>, usize)> = Vec::new();
    for (code, text) in doubts {
        let whole = whole_of(&text, records);
        let same = found.iter_mut().find(|(said, of, _)| {
            said.code == code && whole.is_some() && of.as_deref() == whole.as_deref()
        });
        match same {
            Some((_, _, others)) => *others += 1,
            None => found.push((Said { code, text, causes: Vec::new() }, whole, 0)),
        }
    }
    let said = |(mut said, whole, others): (Said, Option<String>, usize)| {
        if let (Some(whole), true) = (whole, others > 0) {
            let stretches = if others == 1 { "stretch" } else { "stretches" };
            said.text += &format!(" (likewise {others} more {stretches} of {whole})");
        }
        said
    };
    found.into_iter().map(said).collect()
}

/// The record of the one stretch that a text speaks of.
fn whole_of(text: &str, records: &[Record]) -> Option<String> {
    let mut stretches =
        records.iter().map(Record::name).filter(|name| name.contains('#') && is_named(text, name));
    let first = stretches.next()?;
    let whole = |name: &str| name.rsplit_once('#').map(|(whole, _)| whole.to_owned());
    let (found, others) = (whole(first), stretches.map(whole));
    // One that speaks of two records is about neither.
    others.into_iter().all(|other| other == found).then_some(found)?
}

#[cfg(test)]
mod tests {
    use lti::SamplePeriod;
    use reconstruct::Channel;

    use super::*;

    #[test]
    fn stretches_of_one_record_are_spoken_of_once() {
        let record = |name: &str| {
            let period = SamplePeriod::new(0.1).unwrap();
            Record::new(name, period, vec![Channel::new("p", vec![0.0, 1.0])]).unwrap()
        };
        let records: Vec<Record> =
            ["a.csv#1", "a.csv#2", "a.csv#12", "b.csv"].into_iter().map(record).collect();
        let doubts = [
            ("quiet", "record a.csv#1: free motion only".to_owned()),
            ("quiet", "record a.csv#12: free motion only".to_owned()),
            ("order", "no gap".to_owned()),
            ("quiet", "record b.csv: free motion only".to_owned()),
            ("quiet", "record a.csv#2: free motion only".to_owned()),
            ("order", "no gap at all".to_owned()),
        ];
        let texts: Vec<String> =
            collected(doubts.into_iter(), &records).into_iter().map(|said| said.text).collect();
        let expected = [
            "record a.csv#1: free motion only (likewise 2 more stretches of a.csv)",
            "no gap",
            "record b.csv: free motion only",
            "no gap at all",
        ];
        assert_eq!(texts, expected);
    }

    #[test]
    fn causes_are_those_of_the_records_that_a_doubt_names() {
        let cause = |record: &str| Cause {
            record: record.to_owned(),
            column: "p".to_owned(),
            code: "held",
            text: "p holds each value".to_owned(),
        };
        let odd = ["a.csv#1", "a.csv#12", "b.csv"].map(cause);
        let of = |text: &str| -> Vec<String> {
            causes(text, &odd).into_iter().map(|cause| cause.record).collect()
        };
        assert_eq!(of("record a.csv#12 shows free motion"), ["a.csv#12"]);
        assert_eq!(of("b.csv and a.csv#1 are alike"), ["a.csv#1", "b.csv"]);
        assert_eq!(of("no gap"), ["a.csv#1", "a.csv#12", "b.csv"]);
    }
}
