//! What was found, for the terminal.

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};
use report::format_significant;

use super::file::{Inspected, Weight};
use crate::numbers::rounded;

/// All files one after another, then the suggestion.
pub(super) fn render(files: &[Inspected], suggestion: &str) -> String {
    let mut text = String::new();
    for file in files {
        let _ = writeln!(
            text,
            "{}: {}, {} samples, {}",
            file.file,
            file.format,
            file.samples,
            times(file)
        );
        let _ = writeln!(text, "\n{}\n", table(file));
        for finding in &file.findings {
            let label = match finding.weight {
                Weight::Problem => "problem",
                Weight::Note => "note",
            };
            let _ = writeln!(text, "{label}: {}", finding.text);
        }
        if !file.findings.is_empty() {
            text.push('\n');
        }
    }
    let _ = writeln!(text, "{suggestion}");
    text
}

fn times(file: &Inspected) -> String {
    let Some(sampled) = &file.sampling else { return "unevenly sampled".to_owned() };
    let [start, end] = file.span_s;
    let Some(column) = &file.time else {
        return format!("every {} s if that is its sample period", sampled.period_s);
    };
    if sampled.assumed.is_some() {
        return format!(
            "every {} s from {start} s to {end} s, fitted to {column}",
            rounded(sampled.period_s, 8)
        );
    }
    let jitter = format_significant(100.0 * sampled.jitter, 2);
    format!("every {} s from {start} s to {end} s by {column}, jitter {jitter} %", sampled.period_s)
}

fn table(file: &Inspected) -> Table {
    let mut table = Table::new();
    let header = ["channel", "unit", "min", "max", "mean", "rms", "missing", "outliers", "is"];
    // Most columns are signals and nothing more.
    let with_verdicts = file.channels.iter().any(|channel| channel.verdict.is_some());
    let shown_columns = if with_verdicts { header.len() } else { header.len() - 1 };
    table.load_style(presets::NOTHING).set_header(&header[..shown_columns]);
    for channel in &file.channels {
        let signal = &channel.signal;
        let unit = match (&channel.unit, channel.si) {
            (Some(unit), Some(si)) if unit == si || si.is_empty() => unit.clone(),
            (Some(unit), Some(si)) => format!("{si} (from {unit})"),
            _ => "not stated".to_owned(),
        };
        let numbers = [signal.min, signal.max, signal.mean, signal.rms];
        let shown = |value: f64| {
            if value.is_finite() { format_significant(value, 4) } else { "-".to_owned() }
        };
        let [min, max, mean, rms] = numbers.map(shown);
        let (missing, outliers) = (signal.missing.to_string(), signal.outlier_count.to_string());
        let verdict = channel.verdict.as_ref().map(ToString::to_string).unwrap_or_default();
        let row = [channel.name.clone(), unit, min, max, mean, rms, missing, outliers, verdict];
        table.add_row(&row[..shown_columns]);
    }
    for column in table.column_iter_mut().skip(2).take(6) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
