//! Named estimates with their standard errors.

use comfy_table::{CellAlignment, Table, presets};
use report::format_significant;

/// A table to be pasted.
pub(super) fn table<'a>(what: &str, rows: impl Iterator<Item = (&'a String, f64, f64)>) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header([what, "estimate", "standard error"]);
    for (name, value, standard_error) in rows {
        table.add_row([
            name.clone(),
            format_significant(value, 5),
            format_significant(standard_error, 2),
        ]);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
