//! The result as a table for the terminal.

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};
use reconstruct::{AsPrinted, Record};
use report::{format_conjugate_pair, format_significant};

use crate::modes::Found;

/// The modes, how they were found, and every reason not to trust them.
pub(super) fn render(records: &[Record], result: &AsPrinted, found: &[Found]) -> String {
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
    let spread = if found.is_empty() {
        String::new()
    } else {
        format!(", largest spread {}", format_significant(result.shared.largest_spread(), 2))
    };
    let _ = writeln!(
        text,
        "\n{} shared zeros of {} differences{spread}; largest relative residual of a fit {}",
        result.shared.zeros.len(),
        result.differences.len(),
        format_significant(worst, 2)
    );
    for doubt in &result.doubts {
        let _ = writeln!(text, "warning: {doubt}");
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
        let mode = &found.mode;
        let number = |value: f64| format_significant(value, 5);
        let doubles = if mode.eigenvalue.re > 0.0 { "doubles in " } else { "" };
        table.add_row([
            found.named.name.to_string(),
            format_conjugate_pair(mode.eigenvalue.re, mode.eigenvalue.im, 6),
            number(mode.natural_frequency_rad_s),
            number(mode.damping_ratio),
            mode.time_constant_s.map_or_else(|| "-".to_owned(), number),
            format!("{doubles}{}", number(mode.time_to_half_or_double_s)),
            format_significant(found.spread, 2),
        ]);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
