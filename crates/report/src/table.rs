//! Tables as plain data: a title, columns, and rows of finished text.

use crate::ReportError;
use serde::Serialize;

/// On which side the cells of a column line up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Align {
    /// Words.
    #[default]
    Left,
    /// Numbers: digits line up.
    Right,
    /// Short marks, such as a yes or a sign.
    Center,
}

/// Header and alignment of one column.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize)]
#[non_exhaustive]
pub struct Column {
    /// Header, with the unit where there is one: `"period (s)"`.
    pub header: String,
    /// Alignment of the cells and of the header.
    pub align: Align,
}

impl Column {
    /// A column of words.
    pub fn left(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Left }
    }

    /// A column of numbers.
    pub fn right(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Right }
    }

    /// A column of short marks.
    pub fn center(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Center }
    }
}

/// A table whose rows all have as many cells as it has columns.
///
/// Cells are finished text: numbers are formatted by the caller, for example with
/// [`format_significant`](crate::format_significant). Title, headers and cells are taken literally, except
/// that `` `code` `` and `**strong**` are set as such in Markdown and HTML.
///
/// # Example
///
/// ```
/// use report::{Column, Table};
///
/// let mut table = Table::new("Modes", [Column::left("mode"), Column::right("time constant (s)")]);
/// table.push(["roll", "1.83"])?;
/// assert_eq!(table.to_csv(), "mode,time constant (s)\nroll,1.83\n");
/// assert!(table.push(["spiral"]).is_err());
/// # Ok::<(), report::ReportError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Table {
    title: String,
    columns: Vec<Column>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(title: impl Into<String>, columns: impl IntoIterator<Item = Column>) -> Self {
        Self { title: title.into(), columns: columns.into_iter().collect(), rows: Vec::new() }
    }

    /// Adds a row at the bottom.
    ///
    /// # Errors
    ///
    /// [`ReportError::RowWidth`] where the row has not exactly one cell per column; the table is unchanged.
    pub fn push<S: Into<String>>(
        &mut self,
        row: impl IntoIterator<Item = S>,
    ) -> Result<(), ReportError> {
        let row: Vec<String> = row.into_iter().map(Into::into).collect();
        if row.len() != self.columns.len() {
            return Err(ReportError::RowWidth {
                table: self.title.clone(),
                found: row.len(),
                needed: self.columns.len(),
            });
        }
        self.rows.push(row);
        Ok(())
    }

    /// What the table shows; may be empty.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The columns, from left to right.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The rows, from top to bottom, each with one cell per column.
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }
}

#[cfg(test)]
mod tests;
