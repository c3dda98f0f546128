//! What can be wrong with a table of text.

use std::path::PathBuf;

use crate::numbers::counted;

/// Why a text is no table of numbers: one sentence with the place and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// A file that is no text in UTF-8.
    #[error("{}, line {line}: the file is not UTF-8 text; export it as plain CSV", file.display())]
    NotText {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
    },
    /// Compressed text that does not unpack.
    #[error("{}: the compressed file is damaged or truncated ({source}); copy or compress it again", file.display())]
    Damaged {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        source: std::io::Error,
    },
    /// A row without an end.
    #[error("{}, line {line}: the line is longer than {limit} bytes; rows of numbers, one a line, are needed", file.display())]
    LongLine {
        /// The file.
        file: PathBuf,
        /// Line on which the row starts, from 1.
        line: u64,
        /// The longest that is read.
        limit: usize,
    },
    /// More columns than any recorder writes.
    #[error(
        "{}: the header names {found} columns, and at most {limit} are read; \
         export one row a sample, one column a sensor",
        file.display()
    )]
    TooManyColumns {
        /// The file.
        file: PathBuf,
        /// Number of columns.
        found: usize,
        /// The most that are read.
        limit: usize,
    },
    /// A quote that opens and never closes.
    #[error("{}, line {line}: a quote is opened there and never closed; close or remove it", file.display())]
    OpenQuote {
        /// The file.
        file: PathBuf,
        /// Line on which the row starts, from 1.
        line: u64,
    },
    /// Blanks where the header should be.
    #[error(
        "{}, line {line}: the header should be here, but the line holds no name; remove it if the header is below",
        file.display()
    )]
    BlankHeader {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
    },
    /// A file without a header or without a row below it.
    #[error("{} holds no samples: a header line and rows of numbers are needed", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// A row with too many or too few fields.
    #[error(
        "{}, line {line}: {}, but the header names {}{}",
        file.display(), counted(*found as u64, "field"), counted(*expected as u64, "column"), remedy(*separator, *found, *expected)
    )]
    Ragged {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Number of fields in the row.
        found: usize,
        /// Number of columns in the header.
        expected: usize,
        /// What separates the columns in the header.
        separator: char,
    },
    /// Two columns with one name.
    #[error("{}: column {column:?} is there twice; rename one of them", file.display())]
    RepeatedColumn {
        /// The file.
        file: PathBuf,
        /// The name.
        column: String,
    },
    /// A header that is a row of numbers.
    #[error(
        "{}: {}, and no line above names its {}; put a header line there, or name the columns with --columns",
        file.display(), if *line == 1 { "the first line is a row of numbers".to_owned() } else { format!("line {line} is a row of numbers") },
        counted(*fields as u64, "column")
    )]
    NoHeader {
        /// The file.
        file: PathBuf,
        /// Line of the first row of numbers, from 1.
        line: u64,
        /// Number of fields in it.
        fields: usize,
    },
    /// Other columns than were named.
    #[error(
        "{}, line {line}: {}, but --columns names {given}; name each of them, in their order",
        file.display(), counted(*found as u64, "field")
    )]
    ColumnCount {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Number of fields in the row.
        found: usize,
        /// Number of names given.
        given: usize,
    },
    /// A field that is not a finite number.
    #[error(
        "{}, line {line}, column {column:?}: {text:?} is not a finite number; repair or remove the row",
        file.display()
    )]
    NotANumber {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A time that no clock shows so, or not the clock of the rows above.
    #[error(
        "{}, line {line}, column {column:?}: {text:?} is no time; all rows must hold seconds, or all be written as 12:34:56.25, as 330:12:34:56.25 \
         (day of the year), or as 2026-11-26T12:34:56.25",
        file.display()
    )]
    NotATime {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A clock's time below a heading with a unit.
    #[error(
        "{}, line {line}, column {column:?}: {text:?} is what a clock shows, but the heading states a unit; leave the unit out",
        file.display()
    )]
    ClockWithUnit {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A decimal comma among decimal points, or the other way round.
    #[error(
        "{}, line {line}, column {column:?}: {text:?} has a decimal {}, where the rows above have a decimal {}; \
         export all numbers in one way",
        file.display(), if *comma { "comma" } else { "point" }, if *comma { "point" } else { "comma" }
    )]
    MixedMarks {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
        /// Whether it is the comma that comes late.
        comma: bool,
    },
}

/// What may have happened to a row of another length.
fn remedy(separator: char, found: usize, expected: usize) -> String {
    if separator == ',' && found > expected {
        "; if the comma is its decimal mark too, export with semicolons between the fields"
            .to_owned()
    } else if found == 1 && expected > 1 {
        format!("; the fields must be separated by {separator:?}, as in the header")
    } else {
        "; repair or remove the row".to_owned()
    }
}
