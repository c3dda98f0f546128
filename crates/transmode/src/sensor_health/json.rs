//! What was found, as JSON: a stable form for other programs.

use monitor::{TestKind, Window};
use serde::Serialize;

use super::outcome::{MonitorOutcome, Watched};
use super::reference::Reference;
use crate::{CommandError, json};

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    reference: ReferenceOutput<'a>,
    pairs: Vec<[&'a str; 2]>,
    span_s: f64,
    false_alarms_per_span: f64,
    false_alarms_per_hour: f64,
    records: Vec<RecordOutput<'a>>,
    warnings: Vec<Warning>,
}

#[derive(Serialize)]
struct ReferenceOutput<'a> {
    file: &'a str,
    samples: usize,
    sample_period_s: f64,
    healthy_spans: usize,
}

#[derive(Serialize)]
struct RecordOutput<'a> {
    file: &'a str,
    spans: Vec<Span>,
    /// Of these missing samples leave too little.
    spans_not_judged: usize,
    /// `null` without an alarm.
    alarm: Option<Alarm<'a>>,
}

#[derive(Serialize)]
struct Span {
    start_s: f64,
    /// When all samples that its tests need are there.
    known_at_s: f64,
    level: f64,
    spread: f64,
    alarm: bool,
}

#[derive(Serialize)]
struct Alarm<'a> {
    /// When the first alarm can be raised.
    time_s: f64,
    span_start_s: f64,
    test: &'static str,
    statistic: f64,
    limit: f64,
    spans: usize,
    change: String,
    /// Any of them explains the alarm alone, the first one best; empty where none does.
    sensors: Vec<&'a str>,
    raised_pairs: Vec<[&'a str; 2]>,
}

#[derive(Serialize)]
struct Warning {
    code: &'static str,
    text: String,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(outcome: &MonitorOutcome) -> Result<Vec<u8>, CommandError> {
    let reference = &outcome.reference;
    let itself = reference.fitted_to_itself.then(|| Warning {
        code: "fitted-to-reference",
        text: "a model was fitted to the reference itself".to_owned(),
    });
    let output = Output {
        schema: 1,
        reference: ReferenceOutput {
            file: &reference.name,
            samples: reference.samples,
            sample_period_s: reference.period_s,
            healthy_spans: reference.detector.healthy_windows(),
        },
        pairs: reference.pairs().collect(),
        span_s: reference.span_s(),
        false_alarms_per_span: reference.detector.options().false_alarms,
        false_alarms_per_hour: reference.false_alarms_per_hour(),
        records: outcome.watched.iter().map(|watched| record(reference, watched)).collect(),
        warnings: outcome
            .warnings
            .iter()
            .map(|warning| Warning { code: warning.code(), text: warning.to_string() })
            .chain(itself)
            .collect(),
    };
    json::text(&output)
}

fn record<'a>(reference: &'a Reference, watched: &'a Watched) -> RecordOutput<'a> {
    let time = |sample| reference.time(watched.start_s, sample);
    let span = |window: &Window| Span {
        start_s: time(window.first),
        known_at_s: time(window.known_at),
        level: window.tests[0].statistic,
        spread: window.tests[1].statistic,
        alarm: window.alarm().is_some(),
    };
    let alarm = watched.diagnosis.as_ref().and_then(|diagnosis| {
        let window = watched.windows.get(diagnosis.first_alarm)?;
        let (kind, test) = window.alarm()?;
        let raised = reference.pairs().zip(&diagnosis.raised);
        Some(Alarm {
            time_s: time(window.known_at),
            span_start_s: time(window.first),
            test: match kind {
                TestKind::Level => "level",
                TestKind::Spread => "spread",
            },
            statistic: test.statistic,
            limit: test.limit,
            spans: diagnosis.alarms,
            change: diagnosis.change.to_string(),
            sensors: diagnosis.suspects.iter().map(|channel| reference.sensor(*channel)).collect(),
            raised_pairs: raised.filter(|(_, raised)| **raised).map(|(pair, _)| pair).collect(),
        })
    });
    RecordOutput {
        file: &watched.name,
        spans: watched.windows.iter().map(span).collect(),
        spans_not_judged: watched.not_judged,
        alarm,
    }
}
