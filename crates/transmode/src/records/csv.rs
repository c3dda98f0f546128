//! A delimited text file with a header line -> named columns of numbers.

use std::io::Read;
use std::path::Path;

use super::lines::CountedLines;
use crate::CommandError;

/// The columns of a file, all of the same length.
#[derive(Debug)]
pub(crate) struct Columns<R> {
    pub(crate) names: Vec<String>,
    /// `values[c][row]`, finite, or NaN where it may mark a gap.
    pub(crate) values: Vec<Vec<f64>>,
    source: CountedLines<R>,
}

impl<R> Columns<R> {
    pub(crate) fn rows(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// The line of the file, from 1, on which row `row` stands.
    pub(crate) fn line(&self, row: usize) -> u64 {
        // The header is the first line with content.
        self.source.line(row as u64 + 1)
    }

    pub(crate) fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|other| other == name)
    }
}

/// What a NaN in a file means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Missing {
    /// A fault.
    IsFault,
    /// That nothing was recorded there.
    IsGap,
}

/// Reads a whole file. `file` is for messages only.
pub(crate) fn read<R: Read>(
    file: &Path,
    source: R,
    missing: Missing,
) -> Result<Columns<R>, CommandError> {
    let mut reader =
        ::csv::ReaderBuilder::new().trim(::csv::Trim::All).from_reader(CountedLines::new(source));
    let header = reader.headers().map(|header| header.iter().map(str::to_owned).collect());
    let names: Vec<String> = header.map_err(|error| translate(file, error, reader.get_ref()))?;
    check_header(file, &names, reader.get_ref())?;
    let mut values = vec![Vec::new(); names.len()];
    let mut row = ::csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(|error| translate(file, error, reader.get_ref()))? {
        check_quotes(file, place(row.position(), reader.get_ref()), reader.get_ref())?;
        for ((text, name), column) in row.iter().zip(&names).zip(&mut values) {
            let is_gap = |number: f64| missing == Missing::IsGap && number.is_nan();
            let number =
                text.parse().ok().filter(|number: &f64| number.is_finite() || is_gap(*number));
            column.push(number.ok_or_else(|| CommandError::NotANumber {
                file: file.to_owned(),
                line: place(row.position(), reader.get_ref()),
                column: name.clone(),
                text: shortened(text),
            })?);
        }
    }
    if values[0].is_empty() {
        return Err(CommandError::Empty { file: file.to_owned() });
    }
    Ok(Columns { names, values, source: reader.into_inner() })
}

/// The line of a record. The CSV reader's own count of lines is off after blank ones and where lines end with two characters.
fn place<R>(position: Option<&::csv::Position>, source: &CountedLines<R>) -> u64 {
    source.line(position.map_or(0, ::csv::Position::record))
}

/// Refuses a record, the last one, whose quote never ends: it swallowed the rest of the file.
fn check_quotes<R>(file: &Path, line: u64, source: &CountedLines<R>) -> Result<(), CommandError> {
    if source.ended_in_quotes() {
        return Err(CommandError::OpenQuote { file: file.to_owned(), line });
    }
    Ok(())
}

fn check_header<R>(
    file: &Path,
    names: &[String],
    source: &CountedLines<R>,
) -> Result<(), CommandError> {
    if names.is_empty() {
        return Err(CommandError::Empty { file: file.to_owned() });
    }
    let line = source.line(0);
    check_quotes(file, line, source)?;
    if names.iter().all(String::is_empty) {
        return Err(CommandError::BlankHeader { file: file.to_owned(), line });
    }
    if let [name] = names
        && let Some(separator) = name.chars().find(|c| matches!(c, ';' | '\t'))
    {
        return Err(CommandError::NotCommas { file: file.to_owned(), separator });
    }
    if names.iter().all(|name| name.parse::<f64>().is_ok()) {
        return Err(CommandError::NoHeader { file: file.to_owned() });
    }
    for (index, name) in names.iter().enumerate() {
        if names[..index].contains(name) {
            return Err(CommandError::RepeatedColumn {
                file: file.to_owned(),
                column: name.clone(),
            });
        }
    }
    Ok(())
}

fn translate<R>(file: &Path, error: ::csv::Error, source: &CountedLines<R>) -> CommandError {
    let file = file.to_owned();
    let line = place(error.position(), source);
    if source.ended_in_quotes() {
        return CommandError::OpenQuote { file, line };
    }
    match error.into_kind() {
        ::csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            CommandError::Ragged { file, line, found: len, expected: expected_len }
        }
        ::csv::ErrorKind::Utf8 { .. } => CommandError::NotText { file, line },
        ::csv::ErrorKind::Io(source) => CommandError::Read { file, source },
        other => CommandError::Read { file, source: std::io::Error::other(format!("{other:?}")) },
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
