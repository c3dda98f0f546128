//! Delimited text -> a table.
//!
//! A header line names the columns; fields are separated by commas, semicolons or tabs, whichever the header has most of. Where commas do
//! not separate, a decimal comma is read as well. Blank lines and lines that start with `#` or `%` are passed over; a comment right above
//! rows of numbers is their header, as `numpy.savetxt` writes it. A row of units may stand below the header. The column of time may hold dates and times
//! of day (`clock.rs`).
//!
//! Memory: the numbers of the chosen columns, and the longest row. Everything else is forgotten line by line.

mod clock;
mod columns;
mod dialect;
mod header;
mod lines;
mod quotes;

use std::collections::HashSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::format::Format;
use super::format_error::FormatError;
use super::table::{Chosen, Heading, Opened, Places, Table};
use crate::CommandError;
use crate::error::{TableError, in_file};
use columns::Columns;
pub(crate) use header::heading;
use lines::{LONGEST_ROW, LineError, Lines, Row};

/// More columns than this are refused: a recorder writes hundreds, a table that is the wrong way round has millions.
const MOST_COLUMNS: usize = 10_000;

/// How much of a comment is kept in case it is a header.
const LONGEST_COMMENT: usize = 1 << 16;

/// A text of which the header has been read, and the units below it.
pub(crate) struct OpenedText<R> {
    reader: Reader<R>,
    top: Top,
}

/// Opens a text and reads its header. `file` is for messages only.
pub(crate) fn open<R: Read>(
    file: &Path,
    format: Format,
    source: R,
) -> Result<OpenedText<R>, CommandError> {
    let mut reader =
        Reader { file: file.to_owned(), format, lines: Lines::new(source), separator: b',' };
    reader.check_start()?;
    let top = reader.top()?;
    Ok(OpenedText { reader, top })
}

impl<R: Read> Opened for OpenedText<R> {
    fn format(&self) -> Format {
        self.reader.format
    }

    fn headings(&self) -> &[Heading] {
        &self.top.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let Self { reader: Reader { file, format, mut lines, separator }, top } = *self;
        let Top { headings, first } = top;
        let mut columns = Columns::new(&headings, &chosen);
        if let Some((line, texts)) = &first {
            check_length(&file, separator, *line, texts.len(), headings.len())?;
            for (index, text) in texts.iter().enumerate() {
                columns
                    .push(index, text.as_bytes(), separator)
                    .map_err(|fault| fault.at(&file, *line))?;
            }
            columns.lines.push(*line);
        }
        while let Some(row) = lines.next().map_err(|error| translate(&file, format, error))? {
            if is_nothing(row.bytes, separator) || dialect::is_comment(row.bytes) {
                continue;
            }
            let each = |index, field: &[u8]| columns.push(index, field, separator);
            let count = match dialect::fields(row, separator, each) {
                Ok(count) => count,
                // A row of another length is the graver fault.
                Err(fault) => {
                    let any = |_, _: &[u8]| Ok::<_, std::convert::Infallible>(());
                    let count = dialect::fields(row, separator, any).unwrap_or(0);
                    check_length(&file, separator, row.line, count, headings.len())?;
                    return Err(fault.at(&file, row.line));
                }
            };
            check_length(&file, separator, row.line, count, headings.len())?;
            columns.lines.push(row.line);
        }
        let Columns { values, lines, .. } = columns;
        if values.first().is_none_or(Vec::is_empty) {
            return Err(TableError::Empty { file }.into());
        }
        let places = Places::Lines(lines);
        Ok(Table { format, headings, chosen: chosen.channels, values, places })
    }
}

#[derive(Debug)]
struct Reader<R> {
    file: PathBuf,
    format: Format,
    lines: Lines<R>,
    separator: u8,
}

/// The top of a table.
struct Top {
    headings: Vec<Heading>,
    /// The first row of numbers, if it has been taken already.
    first: Option<(u64, Vec<String>)>,
}

impl<R: Read> Reader<R> {
    /// Refuses what is no text in UTF-8 before it is searched for rows.
    fn check_start(&mut self) -> Result<(), CommandError> {
        let start = self.lines.peek().map_err(LineError::Read);
        let start = start.map_err(|error| translate(&self.file, self.format, error))?;
        let fault = if start.starts_with(b"\xff\xfe") || start.starts_with(b"\xfe\xff") {
            Some(FormatError::Utf16)
        } else {
            memchr::memchr(0, start).map(|at| FormatError::Binary { at })
        };
        if let Some(fault) = fault {
            return Err(in_file(&self.file, &fault));
        }
        self.lines.skip_mark();
        Ok(())
    }

    /// Reads the header, the units below it, and as far as that takes.
    fn top(&mut self) -> Result<Top, CommandError> {
        let mut comment: Option<Vec<u8>> = None;
        loop {
            // Which quotes are open depends on the separator, and that on the header, which may have been cut at a quote.
            let start = self.lines.peek().map_err(LineError::Read);
            let separator =
                guess(start.map_err(|error| translate(&self.file, self.format, error))?);
            self.separator = separator;
            self.lines.separated_by(separator);
            let row =
                self.lines.next().map_err(|error| translate(&self.file, self.format, error))?;
            let Some(row) = row else {
                return Err(TableError::Empty { file: self.file.clone() }.into());
            };
            if row.bytes.trim_ascii().is_empty() {
                continue;
            }
            if dialect::is_comment(row.bytes) {
                let text = row.bytes.trim_ascii_start();
                comment = Some(text[1..text.len().min(LONGEST_COMMENT)].to_vec());
                continue;
            }
            let line = row.line;
            let not_text = || TableError::NotText { file: self.file.clone(), line };
            let names = dialect::texts(row, separator).ok_or_else(not_text)?;
            if names.iter().all(|name| {
                dialect::number(name.as_bytes(), separator).is_some_and(|n| !n.value.is_nan())
            }) {
                let above = comment.and_then(|comment| above(&comment, separator, names.len()));
                let Some(above) = above else {
                    return Err(TableError::NoHeader { file: self.file.clone() }.into());
                };
                let headings = self.headings(line, &above)?;
                return Ok(Top { headings, first: Some((line, names)) });
            }
            let headings = self.headings(line, &names)?;
            return self.below(headings);
        }
    }

    fn headings(&self, line: u64, names: &[String]) -> Result<Vec<Heading>, CommandError> {
        let file = || self.file.clone();
        if names.len() > MOST_COLUMNS {
            return Err(TableError::TooManyColumns {
                file: file(),
                found: names.len(),
                limit: MOST_COLUMNS,
            }
            .into());
        }
        if names.iter().all(String::is_empty) {
            return Err(TableError::BlankHeader { file: file(), line }.into());
        }
        let headings: Vec<Heading> = names.iter().map(|name| heading(name)).collect();
        let mut seen = HashSet::new();
        // Columns without a name, as a comma at the end of each line makes them, are no sensors.
        let mut named = headings.iter().filter(|heading| !heading.name.is_empty());
        if let Some(twice) = named.find(|heading| !seen.insert(heading.name.as_str())) {
            return Err(
                TableError::RepeatedColumn { file: file(), column: twice.name.clone() }.into()
            );
        }
        Ok(headings)
    }

    /// The row below the header, which may hold units.
    fn below(&mut self, mut headings: Vec<Heading>) -> Result<Top, CommandError> {
        while let Some(row) =
            self.lines.next().map_err(|error| translate(&self.file, self.format, error))?
        {
            if is_nothing(row.bytes, self.separator) || dialect::is_comment(row.bytes) {
                continue;
            }
            let line = row.line;
            let not_text = || TableError::NotText { file: self.file.clone(), line };
            let texts = dialect::texts(row, self.separator).ok_or_else(not_text)?;
            let Some(units) = header::units(&texts) else {
                return Ok(Top { headings, first: Some((line, texts)) });
            };
            check_length(&self.file, self.separator, line, units.len(), headings.len())?;
            for (heading, unit) in headings.iter_mut().zip(units) {
                heading.unit = unit.or(heading.unit.take());
            }
            break;
        }
        Ok(Top { headings, first: None })
    }
}

/// The separator of the first line that is neither blank nor a comment, as far as it can be seen.
fn guess(start: &[u8]) -> u8 {
    let start = start.strip_prefix("\u{feff}".as_bytes()).unwrap_or(start);
    let mut rows = start.split(|byte| matches!(byte, b'\n' | b'\r'));
    let header = rows.find(|row| !row.trim_ascii().is_empty() && !dialect::is_comment(row));
    dialect::separator(header.unwrap_or_default())
}

/// The names in a comment above a row of `count` numbers.
fn above(comment: &[u8], separator: u8, count: usize) -> Option<Vec<String>> {
    let names = dialect::texts(Row { line: 0, bytes: comment, quoted: false }, separator)?;
    let is_header = names.len() == count && names.iter().all(|name| name.parse::<f64>().is_err());
    is_header.then_some(names)
}

/// Whether a row below the header holds nothing but separators, as a spreadsheet leaves them at the end.
fn is_nothing(bytes: &[u8], separator: u8) -> bool {
    bytes.iter().all(|byte| *byte == separator || byte.is_ascii_whitespace())
}

fn check_length(
    file: &Path,
    separator: u8,
    line: u64,
    found: usize,
    expected: usize,
) -> Result<(), CommandError> {
    if found == expected {
        return Ok(());
    }
    let (file, separator) = (file.to_owned(), char::from(separator));
    Err(TableError::Ragged { file, line, found, expected, separator }.into())
}

fn translate(file: &Path, format: Format, error: LineError) -> CommandError {
    let file = file.to_owned();
    match error {
        LineError::Read(source) if format == Format::GzippedText => {
            TableError::Damaged { file, source }.into()
        }
        LineError::Read(source) => CommandError::Read { file, source },
        LineError::Long { line } => TableError::LongLine { file, line, limit: LONGEST_ROW }.into(),
        LineError::OpenQuote { line } => TableError::OpenQuote { file, line }.into(),
    }
}

#[cfg(test)]
mod tests;
