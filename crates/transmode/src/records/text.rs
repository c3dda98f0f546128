//! Delimited text -> a table.
//!
//! The plain case: a header line names the columns; fields are separated by commas, semicolons or tabs, whichever the header has most of. Where commas do
//! not separate, a decimal comma is read as well. Blank lines and lines that start with `#` or `%` are passed over; a comment right above
//! rows of numbers is their header, as `numpy.savetxt` writes it. A row of units may stand below the header. The column of time may hold dates and times
//! of day (`clock.rs`).
//!
//! Where the rows below that header do not go with it, the table is looked for (`layout.rs`). Columns of words are told from the first rows
//! (`words.rs`).
//!
//! Memory: the numbers of the chosen columns, and the longest row. Everything else is forgotten line by line.

mod clock;
mod columns;
mod dialect;
mod encoding;
mod header;
mod layout;
mod lines;
mod quotes;
mod words;

use std::collections::HashSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::format::Format;
use super::format_error::FormatError;
use super::options::ReadOptions;
use super::table::{Chosen, Heading, Opened, Places, Table};
use crate::CommandError;
use crate::error::{TableError, in_file};
use columns::{Columns, Read as ReadColumns};
use encoding::Decoded;
pub(crate) use header::heading;
use layout::Layout;
use lines::{LONGEST_ROW, LineError, Lines, Row};

/// More columns than this are refused: a recorder writes hundreds, a table that is the wrong way round has millions.
const MOST_COLUMNS: usize = 10_000;

/// What the text files of LabVIEW start with.
const LABVIEW: &[u8] = b"LabVIEW Measurement";

/// How much of a comment is kept in case it is a header.
const LONGEST_COMMENT: usize = 1 << 16;

/// A text of which the header has been read, and the units below it.
pub(crate) struct OpenedText<R> {
    reader: Reader<Decoded<R>>,
    top: Top,
}

/// Opens a text and reads its header. `file` is for messages only.
pub(crate) fn open<R: Read>(
    file: &Path,
    format: Format,
    source: R,
    options: &ReadOptions,
) -> Result<OpenedText<R>, CommandError> {
    let lines = Lines::new(Decoded::new(source));
    let mut reader = Reader { file: file.to_owned(), format, lines, separator: b',' };
    reader.check_start()?;
    let start = reader.lines.peek().map_err(LineError::Read);
    let start = start.map_err(|error| translate(file, format, error))?.to_vec();
    let is_whole = reader.lines.is_at_end();
    let asked = options.skip_lines > 0 || !options.columns.is_empty();
    let is_lvm = start.starts_with(LABVIEW);
    let found = if !asked && !is_lvm && is_plain(file, &start, is_whole) {
        None
    } else {
        layout::search(&start, is_whole, options.skip_lines)
    };
    let mut top = match found {
        Some(layout) if asked || !layout.names.is_empty() => {
            reader.below(layout, options, is_lvm)?
        }
        None if asked => return Err(TableError::Empty { file: file.to_owned() }.into()),
        // No header was found, which the plain way says where that is what is wrong.
        found => plain(&mut reader, found)?,
    };
    let rows = rows_below(&start, &top, reader.separator);
    words::mark(&mut top.headings, &rows);
    Ok(OpenedText { reader, top })
}

/// Reads a header in the plain way. Where a table was found that no line names the columns of, that is what is wrong, and not what the plain
/// way would say of the lines above it.
fn plain<R: Read>(reader: &mut Reader<R>, found: Option<Layout>) -> Result<Top, CommandError> {
    let top = reader.top();
    let is_unnamed = match &top {
        Err(error) => matches!(error, CommandError::Table(TableError::NoHeader { .. })),
        Ok(top) => top.headings.len() == 1,
    };
    match found {
        Some(Layout { first_row: line, fields, .. }) if is_unnamed && fields > 1 => {
            Err(TableError::NoHeader { file: reader.file.clone(), line, fields }.into())
        }
        _ => top,
    }
}

/// Whether the plain way reads the start of a text: the first rows below the header have as many fields, half of them numbers.
fn is_plain(file: &Path, start: &[u8], is_whole: bool) -> bool {
    let lines = Lines::new(start);
    let mut reader = Reader { file: file.to_owned(), format: Format::Text, lines, separator: b',' };
    reader.lines.skip_mark();
    let top = match reader.top() {
        Ok(top) => top,
        // What is not closed is closed somewhere else than meant, wherever the table is.
        Err(CommandError::Table(TableError::OpenQuote { .. })) => return true,
        Err(_) => return false,
    };
    let names = top.headings.len();
    let mut rows = rows_below(start, &top, reader.separator);
    if !is_whole && rows.len() < words::LOOKED_AT {
        // The last one is cut.
        rows.pop();
    }
    let is_number = |text: &&String| {
        text.is_empty() || dialect::is_value(text, reader.separator) || text.parse::<f64>().is_ok()
    };
    let is_row = |row: &Vec<String>| {
        let numbers = row.iter().filter(is_number).count();
        let is_single = names > 1 || !row.iter().any(|text| text.contains(char::is_whitespace));
        // One field too many, which is empty, is a separator at the end of each row.
        let is_long = row.len() == names + 1 && row.last().is_some_and(String::is_empty);
        (row.len() == names || is_long) && is_single && 2 * numbers >= row.len()
    };
    // Without rows the plain way says what is wrong, whatever it is.
    rows.iter().all(is_row)
}

/// The first rows below a header, as text, as far as they are in the start of the file.
fn rows_below(start: &[u8], top: &Top, separator: u8) -> Vec<Vec<String>> {
    let mut rows: Vec<Vec<String>> = top.first.iter().map(|(_, texts)| texts.clone()).collect();
    let mut lines = Lines::new(start);
    lines.skip_mark();
    if lines.skip(top.lines).is_err() {
        return rows;
    }
    lines.separated_by(separator);
    while let Ok(Some(row)) = lines.next() {
        if rows.len() >= words::LOOKED_AT {
            break;
        }
        if is_nothing(row.bytes, separator) || dialect::is_comment(row.bytes) {
            continue;
        }
        rows.extend(dialect::texts(row, separator));
    }
    rows
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
        let Top { headings, first, .. } = top;
        let mut columns = Columns::new(&headings, &chosen);
        if let Some((line, texts)) = &first {
            let texts = &texts[..fields_of(texts, headings.len())];
            check_length(&file, separator, *line, texts.len(), headings.len())?;
            for (index, text) in texts.iter().enumerate() {
                columns
                    .push(index, text.as_bytes(), separator, *line)
                    .map_err(|fault| fault.at(&file, *line))?;
            }
            columns.lines.push(*line);
        }
        while let Some(row) = lines.next().map_err(|error| translate(&file, format, error))? {
            if is_nothing(row.bytes, separator) || dialect::is_comment(row.bytes) {
                continue;
            }
            if is_header_again(row, separator, &headings) {
                continue;
            }
            let mut ends_empty = false;
            let each = |index, field: &[u8]| {
                ends_empty = field.is_empty();
                columns.push(index, field, separator, row.line)
            };
            let count = match dialect::fields(row, separator, each) {
                // A separator at the end of a row.
                Ok(count) if ends_empty && count == headings.len() + 1 => count - 1,
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
        if columns.values.first().is_none_or(Vec::is_empty) {
            return Err(TableError::Empty { file }.into());
        }
        let with_clock = columns.clock_is_read();
        let ReadColumns { values, chosen, ignored, lines } = columns.finish(chosen.channels);
        let places = Places::Lines(lines);
        Ok(Table { format, headings, chosen, values, places, with_clock, ignored, repeated: 0 })
    }
}

/// Whether a row repeats the header, as recorders write it that append to a file.
fn is_header_again(row: Row<'_>, separator: u8, headings: &[Heading]) -> bool {
    let first = row.bytes.trim_ascii_start().first();
    if !first.is_some_and(|byte| byte.is_ascii_alphabetic() || *byte == b'"') {
        return false;
    }
    let names = dialect::texts(row, separator).map(|texts| header::headings(&texts));
    names.is_some_and(|names| {
        let names = names.iter().map(|heading| &heading.name);
        headings.iter().map(|heading| &heading.name).eq(names)
    })
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
    /// Lines taken so far.
    lines: u64,
}

impl<R: Read> Reader<R> {
    /// Refuses what is no text in UTF-8 before it is searched for rows.
    fn check_start(&mut self) -> Result<(), CommandError> {
        let start = self.lines.peek().map_err(LineError::Read);
        let start = start.map_err(|error| translate(&self.file, self.format, error))?;
        if let Some(at) = memchr::memchr(0, start) {
            return Err(in_file(&self.file, &FormatError::Binary { at }));
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
                    let (file, fields) = (self.file.clone(), names.len());
                    return Err(TableError::NoHeader { file, line, fields }.into());
                };
                let headings = self.headings(line, &above)?;
                let lines = self.lines.taken();
                return Ok(Top { headings, first: Some((line, names)), lines });
            }
            let headings = self.headings(line, &names)?;
            return self.units_below(headings);
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
        let headings = header::headings(names);
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

    /// Goes on at a table that was found, with its names or those that were given.
    fn below(
        &mut self,
        layout: Layout,
        options: &ReadOptions,
        is_lvm: bool,
    ) -> Result<Top, CommandError> {
        let Layout { separator, mut names, header_line, units, first_row, fields, .. } = layout;
        let line = header_line.unwrap_or(first_row);
        if !options.columns.is_empty() {
            names.clone_from(&options.columns);
            if names.len() != fields {
                let (file, line, given) = (self.file.clone(), first_row, options.columns.len());
                return Err(TableError::ColumnCount { file, line, found: fields, given }.into());
            }
        }
        if names.is_empty() {
            let (file, line) = (self.file.clone(), first_row);
            return Err(TableError::NoHeader { file, line, fields }.into());
        }
        if is_lvm {
            name_labview_columns(&mut names);
        }
        let mut headings = self.headings(line, &names)?;
        let units = units.filter(|_| options.columns.is_empty());
        for (heading, unit) in headings.iter_mut().zip(units.into_iter().flatten()) {
            heading.unit = unit.or(heading.unit.take());
        }
        let skipped = self.lines.skip(first_row - 1);
        skipped.map_err(|error| translate(&self.file, self.format, error))?;
        self.separator = separator;
        self.lines.separated_by(separator);
        Ok(Top { headings, first: None, lines: first_row - 1 })
    }

    /// The row below the header, which may hold units.
    fn units_below(&mut self, mut headings: Vec<Heading>) -> Result<Top, CommandError> {
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
                let lines = self.lines.taken();
                return Ok(Top { headings, first: Some((line, texts)), lines });
            };
            check_length(&self.file, self.separator, line, units.len(), headings.len())?;
            for (heading, unit) in headings.iter_mut().zip(units) {
                heading.unit = unit.or(heading.unit.take());
            }
            break;
        }
        let lines = self.lines.taken();
        Ok(Top { headings, first: None, lines })
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

/// The fields of a row that count: not the empty one behind a separator at its end.
fn fields_of(texts: &[String], names: usize) -> usize {
    let is_long = texts.len() == names + 1 && texts.last().is_some_and(String::is_empty);
    if is_long { names } else { texts.len() }
}

/// LabVIEW calls time `X_Value`, once for each channel if it is asked to, and a last column `Comment`.
fn name_labview_columns(names: &mut [String]) {
    let mut times = names.iter_mut().filter(|name| name.as_str() == "X_Value");
    if let Some(first) = times.next() {
        "time".clone_into(first);
    }
    for (index, name) in times.enumerate() {
        *name = format!("X_Value_{}", index + 2);
    }
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
        LineError::Read(source) if matches!(format, Format::GzippedText | Format::ZstdText) => {
            TableError::Damaged { file, source }.into()
        }
        LineError::Read(source) => CommandError::Read { file, source },
        LineError::Long { line } => TableError::LongLine { file, line, limit: LONGEST_ROW }.into(),
        LineError::OpenQuote { line } => TableError::OpenQuote { file, line }.into(),
    }
}

#[cfg(test)]
mod tests;
