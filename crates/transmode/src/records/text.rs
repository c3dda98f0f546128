//! Delimited text -> a table.
//!
//! A header line names the columns; fields are separated by commas, semicolons or tabs, whichever the header has most of. Where commas do
//! not separate, a decimal comma is read as well. Blank lines and lines that start with `#` or `%` are passed over; a comment right above
//! rows of numbers is their header, as `numpy.savetxt` writes it. A row of units may stand below the header. The column of time may hold dates and times
//! of day (`clock.rs`).
//!
//! Memory: the numbers of the chosen columns, and the longest row. Everything else is forgotten line by line.

mod clock;
mod dialect;
mod header;
mod lines;
mod quotes;

use std::collections::HashSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::format::Format;
use super::format_error::FormatError;
use super::table::{Choose, Chosen, Heading, Places, RowLines, Table};
use crate::{CommandError, TableError};
use clock::Clock;
pub(crate) use header::heading;
use lines::{LONGEST_ROW, LineError, Lines, Row};

/// More columns than this are refused: a recorder writes hundreds, a table that is the wrong way round has millions.
const MOST_COLUMNS: usize = 10_000;

/// How much of a comment is kept in case it is a header.
const LONGEST_COMMENT: usize = 1 << 16;

/// Reads a whole text. `file` is for messages only.
pub(crate) fn read(
    file: &Path,
    format: Format,
    source: impl Read,
    choose: &mut Choose<'_>,
) -> Result<Table, CommandError> {
    let reader =
        Reader { file: file.to_owned(), format, lines: Lines::new(source), separator: b',' };
    reader.read(choose)
}

#[derive(Debug)]
struct Reader<R> {
    file: PathBuf,
    format: Format,
    lines: Lines<R>,
    separator: u8,
}

/// Which columns to read, and what of them has been read.
struct Columns<'a> {
    headings: &'a [Heading],
    /// For each column of the file, its place among the chosen ones.
    slots: Vec<Option<usize>>,
    values: Vec<Vec<f64>>,
    lines: RowLines,
    /// The decimal mark of the numbers so far.
    mark: Option<u8>,
    /// The column of time, which may hold what a clock shows.
    time: Option<usize>,
    clock: Clock,
    /// Whether it has held a number, so that no clock's time may follow.
    time_is_number: bool,
}

/// The top of a table.
struct Top {
    headings: Vec<Heading>,
    /// The first row of numbers, if it has been taken already.
    first: Option<(u64, Vec<String>)>,
}

impl<R: Read> Reader<R> {
    fn read(mut self, choose: &mut Choose<'_>) -> Result<Table, CommandError> {
        self.check_start()?;
        let top = self.top()?;
        let headings = top.headings;
        let Chosen { channels: chosen, with_time } = choose(self.format, &headings)?;
        let mut slots = vec![None; headings.len()];
        chosen.iter().enumerate().for_each(|(place, column)| slots[*column] = Some(place));
        let values = vec![Vec::new(); chosen.len()];
        let mut columns = Columns {
            headings: &headings,
            slots,
            values,
            lines: RowLines::default(),
            mark: None,
            time: if with_time { chosen.last().copied() } else { None },
            clock: Clock::default(),
            time_is_number: false,
        };
        if let Some((line, texts)) = &top.first {
            let count = texts.len();
            self.check_length(*line, count, headings.len())?;
            for (index, text) in texts.iter().enumerate() {
                columns
                    .push(index, text.as_bytes(), self.separator)
                    .map_err(|fault| fault.at(&self.file, *line))?;
            }
            columns.lines.push(*line);
        }
        let Self { file, format, mut lines, separator } = self;
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
        Ok(Table { format, headings, chosen, values, places: Places::Lines(lines) })
    }

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
            return Err(super::in_file(&self.file, &fault));
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
            self.check_length(line, units.len(), headings.len())?;
            for (heading, unit) in headings.iter_mut().zip(units) {
                heading.unit = unit.or(heading.unit.take());
            }
            break;
        }
        Ok(Top { headings, first: None })
    }

    fn check_length(&self, line: u64, found: usize, expected: usize) -> Result<(), CommandError> {
        check_length(&self.file, self.separator, line, found, expected)
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

/// What is wrong with one field.
struct Fault {
    column: String,
    text: String,
    kind: FaultKind,
}

enum FaultKind {
    NotText,
    NotANumber,
    NotATime,
    ClockWithUnit,
    /// The decimal comma comes late, or the point.
    Mixed {
        comma: bool,
    },
}

impl Columns<'_> {
    /// One more field of column `index`, if it was chosen.
    fn push(&mut self, index: usize, field: &[u8], separator: u8) -> Result<(), Fault> {
        // A row that is too long is refused when its fields have been counted.
        let Some(Some(slot)) = self.slots.get(index) else { return Ok(()) };
        let fault = |kind| {
            let text = shortened(&String::from_utf8_lossy(field));
            Fault { column: self.headings[index].name.clone(), text, kind }
        };
        let is_time = self.time == Some(index) && !field.is_empty();
        if is_time && !self.time_is_number {
            match self.clock.seconds(field) {
                Some(_) if self.headings[index].unit.is_some() => {
                    return Err(fault(FaultKind::ClockWithUnit));
                }
                Some(seconds) => {
                    self.values[*slot].push(seconds);
                    return Ok(());
                }
                None if self.clock.is_read() || field.contains(&b':') => {
                    return Err(fault(FaultKind::NotATime));
                }
                None => {}
            }
        }
        let number = dialect::number(field, separator).filter(|number| !number.value.is_infinite());
        let Some(number) = number else {
            let is_text = std::str::from_utf8(field).is_ok();
            return Err(fault(if is_text { FaultKind::NotANumber } else { FaultKind::NotText }));
        };
        if number.mark.is_some() && number.mark != self.mark {
            if self.mark.is_some() {
                return Err(fault(FaultKind::Mixed { comma: number.mark == Some(b',') }));
            }
            self.mark = number.mark;
        }
        self.time_is_number |= is_time && !number.value.is_nan();
        self.values[*slot].push(number.value);
        Ok(())
    }
}

impl Fault {
    fn at(self, file: &Path, line: u64) -> CommandError {
        let Self { column, text, kind } = self;
        let file = file.to_owned();
        match kind {
            FaultKind::NotText => TableError::NotText { file, line },
            FaultKind::NotANumber => TableError::NotANumber { file, line, column, text },
            FaultKind::NotATime => TableError::NotATime { file, line, column, text },
            FaultKind::ClockWithUnit => TableError::ClockWithUnit { file, line, column, text },
            FaultKind::Mixed { comma } => {
                TableError::MixedMarks { file, line, column, text, comma }
            }
        }
        .into()
    }
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

/// Enough of a field to recognise it, in case the file is one endless line.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain("...".chars()).collect()
}

#[cfg(test)]
mod tests;
