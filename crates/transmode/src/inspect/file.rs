//! What one file holds.

use std::path::Path;

use super::signal::Signal;
use crate::CommandError;
use crate::numbers::rounded;
use crate::records::loading::in_si;
use crate::records::open::open;
use crate::records::progress::Progress;
use crate::records::sampling::Even;
use crate::records::segments::{SHORTEST, segments};
use crate::records::selection::{Selection, TimeSource, Wanted, is_time};

/// A method needs at least so many sensors.
const FEWEST_SENSORS: usize = 3;

/// What was found in a file.
#[derive(Debug)]
pub(super) struct Inspected {
    pub(super) file: String,
    pub(super) format: &'static str,
    pub(super) samples: usize,
    /// The column of time, if the times come from one.
    pub(super) time: Option<String>,
    pub(super) span_s: [f64; 2],
    /// `None` if the steps are not even.
    pub(super) sampling: Option<Sampled>,
    pub(super) channels: Vec<Channel>,
    pub(super) findings: Vec<Finding>,
}

/// Even steps.
#[derive(Debug)]
pub(super) struct Sampled {
    pub(super) period_s: f64,
    pub(super) jitter: f64,
    /// Where each stretch between gaps starts, and its samples.
    pub(super) stretches: Vec<(String, usize)>,
}

/// One channel.
#[derive(Debug)]
pub(super) struct Channel {
    pub(super) name: String,
    /// As the file states it.
    pub(super) unit: Option<String>,
    /// What it is converted to.
    pub(super) si: Option<&'static str>,
    pub(super) signal: Signal,
}

/// Something that a person should know.
#[derive(Debug)]
pub(super) struct Finding {
    pub(super) weight: Weight,
    pub(super) code: &'static str,
    pub(super) text: String,
}

/// What follows from a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    /// It keeps the file from being used as it is.
    Problem,
    /// Something to look at.
    Note,
}

/// Reads a file and looks at everything in it.
pub(super) fn inspect(
    file: &Path,
    selection: &Selection,
    progress: Progress,
) -> Result<Inspected, CommandError> {
    let opened = open(file, progress)?;
    let (mut selection, mut findings) = (selection.clone(), Vec::new());
    if selection.time == TimeSource::Usual
        && !opened.headings().iter().any(|heading| is_time(&heading.name))
    {
        selection.time = TimeSource::Period(1.0);
        let text = "no column is called time, t or timestamp: name it with --time, or give --sample-period".to_owned();
        findings.push(Finding { weight: Weight::Problem, code: "no-time", text });
    }
    let selected = selection.select(file, opened.format(), opened.headings())?;
    let (table, times) = in_si(file, opened, &selected, &selection.time)?;
    let time = selected.time.map(|time| table.headings[time.index].name.clone());
    let rows = 0..times.samples();
    let values: Vec<&[f64]> = table.values.iter().map(Vec::as_slice).collect();
    let sampling = match times.sampling(file, &table, rows.clone()) {
        Ok(Even { period_s, jitter, after_gaps }) => {
            let stretches = segments(rows.clone(), &after_gaps, &values);
            let stretches =
                stretches.into_iter().map(|s| (table.places.of(s.start), s.len())).collect();
            Some(Sampled { period_s, jitter, stretches })
        }
        Err(error) => {
            findings.push(Finding {
                weight: Weight::Problem,
                code: "time",
                text: without(file, &error),
            });
            None
        }
    };
    let channel = |(index, sensor): (usize, &Wanted)| {
        let heading = table.heading(index);
        let (name, unit) = (heading.name.clone(), heading.unit.clone());
        Channel { name, unit, si: sensor.si, signal: Signal::of(values[index]) }
    };
    let channels: Vec<Channel> = selected.sensors.iter().enumerate().map(channel).collect();
    findings.extend(sampling.iter().filter_map(gaps));
    findings.extend(of_channels(&channels, &values, &|row| table.places.of(row)));
    let last = rows.end.saturating_sub(1);
    Ok(Inspected {
        file: file.display().to_string(),
        format: table.format.name(),
        samples: rows.end,
        time,
        // As many digits as the stamps can have.
        span_s: [0, last].map(|row| rounded(times.at(row), 15)),
        sampling,
        channels,
        findings,
    })
}

/// An error's sentence without the name of the file, which stands above it.
fn without(file: &Path, error: &CommandError) -> String {
    let text = error.to_string();
    let name = file.display().to_string();
    let rest = text.strip_prefix(&name).map(|rest| rest.trim_start_matches([',', ':', ' ']));
    rest.map_or_else(|| text.clone(), str::to_owned)
}

fn gaps(sampled: &Sampled) -> Option<Finding> {
    let longest = sampled.stretches.iter().map(|(_, samples)| *samples).max().unwrap_or(0);
    let count = sampled.stretches.len();
    if count == 0 || (count > 1 && longest < SHORTEST) {
        let text =
            format!("gaps leave no stretch of {SHORTEST} samples, the longest has {longest}");
        return Some(Finding { weight: Weight::Problem, code: "only-gaps", text });
    }
    (count > 1).then(|| {
        let starts: Vec<_> =
            sampled.stretches.iter().skip(1).take(5).map(|(place, _)| place.as_str()).collect();
        let text = format!(
            "gaps split it into {count} records; after a gap it goes on at {}{}",
            starts.join(", "),
            if count > 6 { " .." } else { "" }
        );
        Finding { weight: Weight::Note, code: "gaps", text }
    })
}

fn of_channels(
    channels: &[Channel],
    values: &[&[f64]],
    place: &dyn Fn(usize) -> String,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut add = |weight, code, text| findings.push(Finding { weight, code, text });
    for (index, Channel { name, signal, .. }) in channels.iter().enumerate() {
        if signal.is_constant() {
            add(
                Weight::Problem,
                "dead",
                format!("{name} is constant; leave it out with --outputs"),
            );
            continue;
        }
        let equal = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits());
        if let Some(other) = (0..index).find(|other| equal(values[*other], values[index])) {
            let text = format!(
                "{name} repeats {}; leave one of them out with --outputs",
                channels[other].name
            );
            add(Weight::Problem, "duplicate", text);
        }
        if signal.outlier_count > 0 {
            let rows: Vec<_> = signal.outliers.iter().map(|row| place(*row)).collect();
            let rest = signal.outlier_count - rows.len();
            let more = if rest > 0 { format!(" and {rest} more") } else { String::new() };
            add(
                Weight::Note,
                "outliers",
                format!("{name} has outliers: {}{more}", rows.join(", ")),
            );
        }
        if let Some((row, length)) = signal.stuck {
            add(
                Weight::Note,
                "stuck",
                format!("{name} is stuck for {length} samples from {} on", place(row)),
            );
        }
        if let Some((value, count)) = signal.saturated {
            add(
                Weight::Note,
                "saturated",
                format!("{name} is cut off at {value}: {count} samples"),
            );
        }
    }
    let usable = channels.iter().filter(|channel| !channel.signal.is_constant()).count();
    if usable < FEWEST_SENSORS {
        let text = format!(
            "{usable} of its channels say something; identify needs {FEWEST_SENSORS}, fit needs 2"
        );
        add(Weight::Problem, "few-sensors", text);
    }
    findings
}
