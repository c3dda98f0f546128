//! Tables as comma-separated values.

use crate::Table;

impl Table {
    /// The headers and the rows as comma-separated values, without the title.
    ///
    /// Lines end in a line feed. A cell is quoted where it holds a comma, a quote, a line break, or a space at
    /// either end; quotes inside are doubled (RFC 4180). Cells are written as they are, markup included.
    pub fn to_csv(&self) -> String {
        let mut out = String::new();
        write_record(&mut out, self.columns().iter().map(|column| column.header.as_str()));
        for row in self.rows() {
            write_record(&mut out, row.iter().map(String::as_str));
        }
        out
    }
}

fn write_record<'a>(out: &mut String, cells: impl Iterator<Item = &'a str>) {
    for (i, cell) in cells.enumerate() {
        if i > 0 {
            out.push(',');
        }
        if cell.contains([',', '"', '\n', '\r']) || cell.trim() != cell {
            out.push('"');
            out.push_str(&cell.replace('"', "\"\""));
            out.push('"');
        } else {
            out.push_str(cell);
        }
    }
    out.push('\n');
}
