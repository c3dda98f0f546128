//! What was found, for other programs.

use serde::Serialize;

use super::file::{Channel, Finding, Inspected, Weight};
use super::verdict::Verdict;
use crate::{CommandError, json};

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    files: Vec<FileOutput<'a>>,
    /// A command line that is ready to use, or what keeps one from being suggested.
    suggestion: &'a str,
}

#[derive(Serialize)]
struct FileOutput<'a> {
    file: &'a str,
    format: &'a str,
    samples: usize,
    time: Option<&'a str>,
    start_s: f64,
    end_s: f64,
    sample_period_s: Option<f64>,
    /// The largest deviation of a step from the period, as a part of it.
    jitter: Option<f64>,
    stretches: Vec<StretchOutput<'a>>,
    channels: Vec<ChannelOutput<'a>>,
    other_columns: Vec<OtherOutput<'a>>,
    findings: Vec<FindingOutput<'a>>,
}

#[derive(Serialize)]
struct StretchOutput<'a> {
    starts_at: &'a str,
    samples: usize,
}

#[derive(Serialize)]
struct ChannelOutput<'a> {
    name: &'a str,
    /// As the file states it.
    unit: Option<&'a str>,
    /// What the numbers below are in.
    si_unit: Option<&'a str>,
    missing: usize,
    /// Absent where no sample is a number.
    min: Option<f64>,
    max: Option<f64>,
    mean: f64,
    rms: f64,
    outliers: usize,
    /// Index of the first few, from 0.
    outlier_samples: &'a [usize],
    constant: bool,
    /// Absent where it is a signal and nothing more.
    verdict: Option<VerdictOutput<'a>>,
}

/// What a column is.
#[derive(Serialize)]
struct VerdictOutput<'a> {
    is: &'static str,
    /// Rows for which a value is held; the turn at which it wraps; the factor to another column.
    number: Option<f64>,
    of: Option<&'a str>,
}

/// A column that is no channel.
#[derive(Serialize)]
struct OtherOutput<'a> {
    name: &'a str,
    verdict: VerdictOutput<'a>,
}

#[derive(Serialize)]
struct FindingOutput<'a> {
    problem: bool,
    code: &'a str,
    text: &'a str,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(files: &[Inspected], suggestion: &str) -> Result<Vec<u8>, CommandError> {
    let files = files.iter().map(file).collect();
    let output = Output { schema: 1, files, suggestion };
    json::text(&output)
}

fn file(file: &Inspected) -> FileOutput<'_> {
    let sampled = file.sampling.as_ref();
    FileOutput {
        file: &file.file,
        format: file.format,
        samples: file.samples,
        time: file.time.as_deref(),
        start_s: file.span_s[0],
        end_s: file.span_s[1],
        sample_period_s: sampled.map(|sampled| sampled.period_s),
        jitter: sampled.map(|sampled| sampled.jitter),
        stretches: sampled
            .iter()
            .flat_map(|sampled| &sampled.stretches)
            .map(|(place, samples)| StretchOutput { starts_at: place, samples: *samples })
            .collect(),
        channels: file.channels.iter().map(channel).collect(),
        other_columns: file
            .others
            .iter()
            .map(|other| OtherOutput { name: &other.name, verdict: verdict(&other.verdict) })
            .collect(),
        findings: file.findings.iter().map(finding).collect(),
    }
}

fn verdict(verdict: &Verdict) -> VerdictOutput<'_> {
    VerdictOutput { is: verdict.word(), number: verdict.number(), of: verdict.other() }
}

fn channel(channel: &Channel) -> ChannelOutput<'_> {
    let signal = &channel.signal;
    let finite = |value: f64| Some(value).filter(|value| value.is_finite());
    ChannelOutput {
        name: &channel.name,
        unit: channel.unit.as_deref(),
        si_unit: channel.si,
        missing: signal.missing,
        min: finite(signal.min),
        max: finite(signal.max),
        mean: signal.mean,
        rms: signal.rms,
        outliers: signal.outlier_count,
        outlier_samples: &signal.outliers,
        constant: signal.is_constant(),
        verdict: channel.verdict.as_ref().map(verdict),
    }
}

fn finding(finding: &Finding) -> FindingOutput<'_> {
    FindingOutput {
        problem: finding.weight == Weight::Problem,
        code: finding.code,
        text: &finding.text,
    }
}
