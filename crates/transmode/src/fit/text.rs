//! The fit in a few lines for the terminal.

use std::fmt::Write;

use cfi_ident::{ConstantTerm, Parameter};
use comfy_table::{CellAlignment, Table, presets};
use poly::Root;
use report::{format_conjugate_pair, format_significant};

use super::outcome::{Estimate, FitOutcome};
use super::warning::Warning;

/// How many Markov parameters are shown.
const LARGEST: usize = 5;

/// What was fitted, how well, and every reason for care.
pub(super) fn render(outcome: &FitOutcome, warnings: &[Warning]) -> String {
    let fit = &outcome.fit;
    let structure = fit.model.structure();
    let parameters = structure.parameter_count();
    let short = |value: f64| format_significant(value, 2);
    let mut text = String::new();
    let period = outcome.sample_period_s.map_or_else(String::new, |s| format!(", every {s} s"));
    let gaps = match outcome.missing {
        0 => String::new(),
        missing => format!(", {missing} of them missing"),
    };
    let _ = writeln!(
        text,
        "transmissibility from {} to {}: {}, {} samples{period}{gaps}",
        outcome.input, outcome.output, outcome.file, outcome.samples
    );
    let constant_term = match structure.constant_term {
        ConstantTerm::Included => ", with a constant term",
        ConstantTerm::Omitted => "",
    };
    let _ = writeln!(text, "orders: {}{constant_term}", structure.orders);
    let _ = writeln!(
        text,
        "fit: {} equations from {} stretch{}, rank {} of {parameters}, condition number {}, rounding {}",
        fit.equations,
        outcome.segments,
        if outcome.segments == 1 { "" } else { "es" },
        fit.rank,
        short(fit.condition),
        short(fit.expected_error),
    );
    if outcome.missing > 0 {
        let reach = structure.orders.samples_needed(1);
        let _ = writeln!(
            text,
            "gaps: an equation reaches over {reach} samples, and those that touch a missing one are left out"
        );
    }
    let _ = writeln!(
        text,
        "residual: root mean square {}, relative {}",
        format_significant(fit.residual_rms, 4),
        short(fit.relative_residual)
    );
    if let Ok(poles) = &outcome.poles {
        let _ = writeln!(text, "poles in z: {}", listed(poles));
    }
    let _ = writeln!(text, "\n{}\n", table(&outcome.estimates()));
    for note in &outcome.notes {
        let _ = writeln!(text, "{}: {note}", note.label());
    }
    for warning in warnings {
        let _ = writeln!(text, "warning: {warning}");
    }
    while text.ends_with("\n\n") {
        text.pop();
    }
    text
}

/// Conjugate pairs once.
fn listed(poles: &[Root]) -> String {
    let shown = |pole: &Root| {
        let value = format_conjugate_pair(pole.value.re, pole.value.im, 6);
        if pole.multiplicity > 1 { format!("{value} ({} times)", pole.multiplicity) } else { value }
    };
    let upper: Vec<_> = poles.iter().filter(|pole| pole.value.im >= 0.0).map(shown).collect();
    if upper.is_empty() { "none".to_owned() } else { upper.join(", ") }
}

/// The largest Markov parameters, the largest first.
fn table(estimates: &[Estimate]) -> Table {
    let is_markov = |estimate: &&Estimate| matches!(estimate.parameter, Parameter::Markov(_));
    let mut markov: Vec<_> = estimates.iter().filter(is_markov).collect();
    let count = markov.len();
    markov.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
    markov.truncate(LARGEST);
    let title = if count > markov.len() {
        format!("largest {} of {count}", markov.len())
    } else {
        "Markov parameter".to_owned()
    };
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header([&title, "value", "standard deviation"]);
    for estimate in markov {
        let deviation =
            estimate.deviation.map_or_else(|| "-".to_owned(), |d| format_significant(d, 2));
        table.add_row([
            estimate.parameter.to_string(),
            format_significant(estimate.value, 7),
            deviation,
        ]);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
