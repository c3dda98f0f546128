//! The result as a table for the terminal.

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};
use reconstruct::{AsPrinted, Record};
use report::{format_conjugate_pair, format_significant};

use crate::modes::Found;
use crate::records::LoadWarning;

/// The modes, how they were found, and every reason not to trust them.
pub(super) fn render(
    records: &[Record],
    result: &AsPrinted,
    found: &[Found],
    warnings: &[LoadWarning],
) -> String {
    let mut text = String::new();
    let names: Vec<_> = records[0].channels().iter().map(|channel| channel.name.as_str()).collect();
    let (input, outputs) =
        names.split_first().map_or(("", &names[..]), |(input, outputs)| (*input, outputs));
    let _ = writeln!(
        text,
        "method: as printed, transmissibilities from {input} to {}",
        outputs.join(", ")
    );
    for record in records {
        let _ = writeln!(
            text,
            "record: {}, {} samples, every {} s",
            record.name(),
            record.samples(),
            record.period().seconds()
        );
    }
    if !found.is_empty() {
        let _ = writeln!(text, "\n{}", table(found));
    }
    let worst =
        result.identifications.iter().map(|found| found.fit.relative_residual).fold(0.0, f64::max);
    let _ = writeln!(text, "\n{}", summary(result, worst));
    for warning in warnings {
        let _ = writeln!(text, "warning: {warning}");
    }
    for doubt in &result.doubts {
        let _ = writeln!(text, "warning: {doubt}");
    }
    text
}

/// What the modes rest on, in a line or two.
fn summary(result: &AsPrinted, worst_residual: f64) -> String {
    let fits = || result.identifications.iter().map(|found| &found.fit);
    let rank = fits().map(|fit| fit.rank).min().unwrap_or(0);
    let parameters = fits().map(|fit| fit.model.structure().parameter_count()).max().unwrap_or(0);
    let condition = fits().map(|fit| fit.condition).fold(0.0, f64::max);
    let mut text = format!(
        "fits: rank {rank} of {parameters}, condition number up to {}, relative residual up to {}\n\
         zeros: {} shared by {} differences",
        format_significant(condition, 2),
        format_significant(worst_residual, 2),
        result.shared.zeros.len(),
        result.differences.len(),
    );
    if !result.shared.zeros.is_empty() {
        text +=
            &format!(", largest spread {}", format_significant(result.shared.largest_spread(), 2));
    }
    if let Some(refused) = result.shared.closest_refused {
        text += &format!(", smallest spread refused {}", format_significant(refused, 2));
    }
    for zero in result.blind.iter().filter(|zero| zero.im >= 0.0) {
        let place = format_conjugate_pair(zero.re, zero.im, 6);
        text += &format!(
            "\nz = {place} is no mode: there the pseudo input reads nothing in any record"
        );
    }
    text
}

fn table(found: &[Found]) -> Table {
    const HEADER: [&str; 7] = [
        "mode",
        "eigenvalue [1/s]",
        "frequency [rad/s]",
        "damping ratio",
        "time constant [s]",
        "time to half or double [s]",
        "spread in z",
    ];
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(HEADER);
    for found in found {
        let mode = &found.mode.mode;
        let number = |value: f64| format_significant(value, 5);
        let doubles = if mode.eigenvalue.re > 0.0 { "doubles in " } else { "" };
        table.add_row([
            found.named.name.to_string(),
            format_conjugate_pair(mode.eigenvalue.re, mode.eigenvalue.im, 6),
            number(mode.natural_frequency_rad_s),
            number(mode.damping_ratio),
            mode.time_constant_s.map_or_else(|| "-".to_owned(), number),
            format!("{doubles}{}", number(mode.time_to_half_or_double_s)),
            found.spread.map_or_else(|| "-".to_owned(), |spread| format_significant(spread, 2)),
        ]);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
