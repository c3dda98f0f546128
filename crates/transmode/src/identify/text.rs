//! The result as a table for the terminal.

mod estimates;
mod evidence;
mod paper;
mod recorded;

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};
use reconstruct::likelihood::Estimate;
use report::{format_conjugate_pair, format_significant};

use super::doubts;
use super::near_double;
use super::outcome::Outcome;
use crate::args::values::MethodName;
use crate::modes::IdentifiedMode;

/// The modes, how they were found, and every reason not to trust them.
pub(super) fn render(outcome: &Outcome<'_>) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "method: {}", method(outcome));
    for (index, record) in outcome.records.iter().enumerate() {
        let rank = outcome.result.excitations().get(index).map(|found| found.rank);
        let excitations = match rank {
            None | Some(1) => String::new(),
            Some(0) => ", no excitation".to_owned(),
            Some(count) => format!(", at least {count} excitations"),
        };
        let _ = writeln!(
            text,
            "record: {}, {} samples, every {} s{excitations}",
            record.name(),
            record.samples(),
            record.period().seconds()
        );
    }
    if !outcome.found.is_empty() {
        let _ = writeln!(text, "\n{}", table(outcome));
    }
    let summary = match (outcome.result.paper(), outcome.result.output_error()) {
        (Some(solution), _) => paper::summary(solution),
        (_, Some(fit)) => recorded::summary(outcome, fit),
        _ => evidence::summary(outcome),
    };
    let _ = writeln!(text, "\n{summary}");
    for sentence in near_double::sentences(outcome) {
        let _ = writeln!(text, "nearly double: {sentence}");
    }
    for warning in outcome.warnings {
        let _ = writeln!(text, "{}: {warning}", warning.label());
    }
    let doubts = doubts::said(outcome);
    for doubt in &doubts {
        let _ = writeln!(text, "warning: {}", doubt.text);
    }
    for cause in doubts::all_causes(&doubts) {
        let _ = writeln!(text, "possible cause: {}", cause.text);
    }
    text
}

fn method(outcome: &Outcome<'_>) -> String {
    let channels = outcome.records.first().map_or(&[][..], |record| record.channels());
    let names: Vec<_> = channels.iter().map(|channel| channel.name.as_str()).collect();
    match (outcome.method, &names[..]) {
        (MethodName::AsPrinted, [input, outputs @ ..]) => {
            format!("as printed, transmissibilities from {input} to {}", outputs.join(", "))
        }
        (MethodName::Subspace, _) => {
            format!("intersection of signal subspaces of {}", names.join(", "))
        }
        _ if outcome.result.output_error().is_some() => {
            format!("output error with recorded inputs, from {}", names.join(", "))
        }
        _ => format!("maximum likelihood from {}", names.join(", ")),
    }
}

/// One line for each mode; columns that the method or the command line does not fill are left out.
fn table(outcome: &Outcome<'_>) -> Table {
    let estimated = outcome.found.iter().any(|found| found.mode.estimate.is_some());
    let by_paper = outcome.result.paper().is_some();
    let levels = outcome.flying_qualities.is_some();
    let columns = [
        ("mode", true),
        ("eigenvalue [1/s]", true),
        ("deviation [1/s]", estimated),
        ("frequency [rad/s]", true),
        ("damping ratio", true),
        ("time constant [s]", true),
        ("time to half or double [s]", true),
        ("spread in z", by_paper),
        ("level", levels),
    ];
    let shown = |cells: Vec<String>| -> Vec<String> {
        cells
            .into_iter()
            .zip(columns)
            .filter(|(_, (_, is_shown))| *is_shown)
            .map(|(cell, _)| cell)
            .collect()
    };
    let mut table = Table::new();
    let header = columns.iter().map(|(name, _)| (*name).to_owned()).collect();
    table.load_style(presets::NOTHING).set_header(shown(header));
    for found in outcome.found {
        table.add_row(shown(row(outcome, found)));
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn row(outcome: &Outcome<'_>, found: &IdentifiedMode) -> Vec<String> {
    let (mode, estimate) = (&found.mode.mode, found.mode.estimate.as_ref());
    let dash = || "-".to_owned();
    let number = |value: f64| format_significant(value, 5);
    let with = |value: f64, estimate: Option<Estimate>| match estimate {
        Some(estimate) => {
            format!("{} +- {}", number(value), format_significant(estimate.standard_error, 2))
        }
        None => number(value),
    };
    let doubles = if mode.eigenvalue.re > 0.0 { "doubles in " } else { "" };
    // A real mode has a damping ratio of 1 or -1, whatever the noise.
    let damping = estimate.map(|estimate| estimate.damping_ratio);
    let damping = damping.filter(|_| mode.eigenvalue.im > 0.0);
    vec![
        found.named.name.to_string(),
        format_conjugate_pair(mode.eigenvalue.re, mode.eigenvalue.im, 6),
        estimate.map_or_else(dash, |estimate| {
            let re = format_significant(estimate.continuous.real_standard_error(), 2);
            if mode.eigenvalue.im > 0.0 {
                let im = format_significant(estimate.continuous.imaginary_standard_error(), 2);
                format!("{re}, j{im}")
            } else {
                re
            }
        }),
        with(
            mode.natural_frequency_rad_s,
            estimate.map(|estimate| estimate.natural_frequency_rad_s),
        ),
        with(mode.damping_ratio, damping),
        mode.time_constant_s.map_or_else(dash, number),
        format!("{doubles}{}", number(mode.time_to_half_or_double_s)),
        found.spread.map_or_else(dash, |spread| format_significant(spread, 2)),
        outcome.level(found).map_or_else(dash, |level| level.to_string()),
    ]
}
