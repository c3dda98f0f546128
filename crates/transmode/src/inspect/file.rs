//! What one file holds.

use std::path::Path;

use super::signal::Signal;
use super::verdict::{self, Verdict};
use crate::CommandError;
use crate::numbers::rounded;
use crate::records::clock::Clock;
use crate::records::loading::in_si;
use crate::records::open::open;
use crate::records::options::ReadOptions;
use crate::records::progress::Progress;
use crate::records::sampling::Even;
use crate::records::segments::{SHORTEST, segments};
use crate::records::selection::{Selected, Selection, TimeSource, Wanted, is_time};
use crate::records::table::Table;
use crate::records::timing::{Steps, Times};
use crate::records::unit::Unit;

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
    /// Columns that are no channels.
    pub(super) others: Vec<Other>,
    pub(super) findings: Vec<Finding>,
}

/// A column that is no channel, and what it is.
#[derive(Debug)]
pub(super) struct Other {
    pub(super) name: String,
    pub(super) verdict: Verdict,
}

/// Even steps.
#[derive(Debug)]
pub(super) struct Sampled {
    pub(super) period_s: f64,
    pub(super) jitter: f64,
    /// What the stamps were taken for, where they are not even by themselves.
    pub(super) assumed: Option<Clock>,
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
    /// What it is, where it is more than a signal.
    pub(super) verdict: Option<Verdict>,
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
    reading: &ReadOptions,
    progress: Progress,
) -> Result<Inspected, CommandError> {
    let opened = open(file, reading, progress)?;
    let (mut selection, mut findings) = (selection.clone(), Vec::new());
    if selection.time == TimeSource::Usual
        && !opened.headings().iter().any(|heading| is_time(&heading.name))
    {
        selection.time = TimeSource::Period(1.0);
        let text = "no column is called time, t or timestamp: name it with --time, or give --sample-period".to_owned();
        findings.push(Finding { weight: Weight::Problem, code: "no-time", text });
    }
    let mut selected = selection.select(file, opened.format(), opened.headings())?;
    let (table, times) = in_si(file, opened, &mut selected, &selection)?;
    let time = selected.time.map(|time| table.headings[time.index].name.clone());
    let rows = 0..times.samples();
    let values: Vec<&[f64]> = table.values.iter().map(Vec::as_slice).collect();
    let sampling = match times.sampling(file, &table, rows.clone()) {
        Ok(Steps { even: Even { period_s, jitter, after_gaps }, clock, is_assumed }) => {
            let stretches = segments(rows.clone(), &after_gaps, &values);
            let stretches =
                stretches.into_iter().map(|s| (table.places.of(s.start), s.len())).collect();
            let assumed = is_assumed.then_some(clock);
            Some(Sampled { period_s, jitter, assumed, stretches })
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
        Channel { name, unit, si: sensor.si, signal: Signal::of(values[index]), verdict: None }
    };
    let mut channels: Vec<Channel> = selected.sensors.iter().enumerate().map(channel).collect();
    verdict::judge(&mut channels, &values, sampling.as_ref().map(|sampled| sampled.period_s));
    if let Some(sampled) = &sampling {
        findings.extend(clock(sampled, &times));
    }
    if table.repeated > 0 {
        let text = format!(
            "{} rows repeat the one before, time stamp and all; they are left out",
            table.repeated
        );
        findings.push(Finding { weight: Weight::Note, code: "rows-repeated", text });
    }
    findings.extend(sampling.iter().filter_map(gaps));
    findings.extend(of_channels(&channels, &|row| table.places.of(row)));
    let (others, notes) = not_read(&table, &selected, &selection);
    findings.extend(notes);
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
        others,
        findings,
    })
}

/// What there is to say of the column of time.
fn clock(sampled: &Sampled, times: &Times) -> Vec<Finding> {
    let period_s = rounded(sampled.period_s, 8);
    let mut texts = Vec::new();
    if let Some(clock) = sampled.assumed {
        let largest = rounded(clock.largest_deviation_s.unwrap_or_default(), 2);
        let text = format!(
            "the sample period of {period_s} s is fitted to the time stamps, the largest deviation is {largest} s; assumed: {clock}"
        );
        texts.push(("clock", text));
    }
    texts.extend(times.unit_note(period_s).map(|note| ("clock-unit", format!("column {note}"))));
    let note = |(code, text)| Finding { weight: Weight::Note, code, text };
    texts.into_iter().map(note).collect()
}

/// Columns that are no channels, with a note where that needs one.
fn not_read(
    table: &Table,
    selected: &Selected,
    selection: &Selection,
) -> (Vec<Other>, Vec<Finding>) {
    let (mut others, mut findings) = (Vec::new(), Vec::new());
    let mut note = |code, text| findings.push(Finding { weight: Weight::Note, code, text });
    for (index, heading) in table.headings.iter().enumerate() {
        let name = heading.name.clone();
        if selected.time.is_some_and(|time| time.index == index) {
            others.push(Other { name, verdict: Verdict::Time });
            continue;
        }
        let is_wanted = selection.outputs.is_empty() || selection.outputs.contains(&name);
        let word = table.ignored.iter().find(|column| column.index == index);
        let is_short = heading.samples.is_some_and(|samples| samples != table.rows());
        let why = match (&heading.fault, word) {
            (Some(fault), _) => fault.clone(),
            (None, Some(column)) => format!("it {}", column.why),
            (None, None) if is_short && is_wanted => {
                format!(
                    "it has {} samples, others have {}",
                    heading.samples.unwrap_or_default(),
                    table.rows()
                )
            }
            _ => continue,
        };
        if is_wanted && !name.is_empty() {
            note("not-read", format!("{name} is ignored: {why}"));
            others.push(Other { name, verdict: Verdict::NotRead { why } });
        }
    }
    for sensor in &selected.sensors {
        let heading = &table.headings[sensor.index];
        if let Some(unit) = heading.unit.as_deref().filter(|unit| Unit::parse(unit).is_none()) {
            let text = format!(
                "the unit {unit:?} of {} is not known; its numbers are taken as they are",
                heading.name
            );
            note("unit-unknown", text);
        }
    }
    (others, findings)
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
        let text = format!(
            "gaps leave no stretch of {SHORTEST} samples, the longest has {longest}; --resample interpolates channels of a lower rate"
        );
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

fn of_channels(channels: &[Channel], place: &dyn Fn(usize) -> String) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut add = |weight, code, text| findings.push(Finding { weight, code, text });
    for Channel { name, signal, verdict, .. } in channels {
        if signal.is_constant() {
            add(
                Weight::Problem,
                "dead",
                format!("{name} is constant; leave it out with --outputs"),
            );
            continue;
        }
        match verdict {
            Some(Verdict::Copy { of, factor }) => {
                let text = if (factor - 1.0).abs() < 1e-9 {
                    format!("{name} repeats {of}; leave one of them out with --outputs")
                } else {
                    format!(
                        "{name} is {} times {of}; leave one of them out with --outputs",
                        rounded(*factor, 6)
                    )
                };
                add(Weight::Problem, "duplicate", text);
            }
            Some(Verdict::Counter) => {
                let text = format!(
                    "{name} counts up evenly and is no sensor; leave it out with --outputs"
                );
                add(Weight::Note, "counter", text);
            }
            Some(Verdict::Held { rows }) => {
                let text = format!(
                    "{name} holds each value for {rows} rows: it is sampled at a lower rate; --resample interpolates it"
                );
                add(Weight::Note, "held", text);
            }
            Some(Verdict::Wraps { turn }) => {
                let text = format!(
                    "{name} jumps by a turn of {}; identify has it go on, unless --unwrap=false",
                    rounded(*turn, 4)
                );
                add(Weight::Note, "wraps", text);
                // Its jumps would be outliers.
                continue;
            }
            _ => {}
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
        if let Some((row, length)) = signal.stuck
            && !matches!(verdict, Some(Verdict::Held { .. } | Verdict::Counter))
        {
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
