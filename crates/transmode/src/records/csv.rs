//! A delimited text file with a header line -> named columns of numbers.

use std::io::Read;
use std::path::Path;

use crate::CommandError;

/// The columns of a file, all of the same length.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Columns {
    pub(crate) names: Vec<String>,
    /// `values[c][row]`, finite.
    pub(crate) values: Vec<Vec<f64>>,
    /// Line of the file, from 1, on which each row stands.
    pub(crate) lines: Vec<u64>,
}

impl Columns {
    pub(crate) fn rows(&self) -> usize {
        self.lines.len()
    }

    pub(crate) fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|other| other == name)
    }
}

/// Reads a whole file. `file` is for messages only.
pub(crate) fn read(file: &Path, source: impl Read) -> Result<Columns, CommandError> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(source);
    let names: Vec<String> = reader
        .headers()
        .map_err(|error| translate(file, error))?
        .iter()
        .map(str::to_owned)
        .collect();
    check_header(file, &names)?;
    let mut values = vec![Vec::new(); names.len()];
    let mut lines = Vec::new();
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(|error| translate(file, error))? {
        let line = row.position().map_or(0, csv::Position::line);
        for ((text, name), column) in row.iter().zip(&names).zip(&mut values) {
            let number = text.parse().ok().filter(|number: &f64| number.is_finite());
            column.push(number.ok_or_else(|| CommandError::NotANumber {
                file: file.to_owned(),
                line,
                column: name.clone(),
                text: shortened(text),
            })?);
        }
        lines.push(line);
    }
    if lines.is_empty() {
        return Err(CommandError::Empty { file: file.to_owned() });
    }
    Ok(Columns { names, values, lines })
}

fn check_header(file: &Path, names: &[String]) -> Result<(), CommandError> {
    if names.iter().all(String::is_empty) {
        return Err(CommandError::Empty { file: file.to_owned() });
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

fn translate(file: &Path, error: csv::Error) -> CommandError {
    let file = file.to_owned();
    let line = error.position().map_or(1, csv::Position::line);
    match error.into_kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            CommandError::Ragged { file, line, found: len, expected: expected_len }
        }
        csv::ErrorKind::Utf8 { .. } => CommandError::NotText { file, line },
        csv::ErrorKind::Io(source) => CommandError::Read { file, source },
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
