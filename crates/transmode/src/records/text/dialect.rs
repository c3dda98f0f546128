//! How a text is written: what separates its fields, which lines are comments.

use std::borrow::Cow;

use memchr::memchr;

use super::lines::Row;
use super::quotes::Quotes;

/// What may separate fields. Where two are equally frequent in the header, the first one does.
const SEPARATORS: [u8; 4] = [b'\t', b';', b',', b'|'];

/// Stands for any run of blanks between fields.
pub(super) const BLANK: u8 = b' ';

/// What a text has in place of a number that is missing, in lower case.
const NOT_AVAILABLE: [&str; 21] = [
    "na",
    "n/a",
    "#n/a",
    "null",
    "none",
    "nil",
    "missing",
    "-",
    "--",
    "---",
    "?",
    ".",
    "nan(ind)",
    "-nan(ind)",
    "nan(snan)",
    "-nan(snan)",
    "1.#qnan",
    "-1.#qnan",
    "1.#ind",
    "-1.#ind",
    "1.#snan",
];

/// What spreadsheets write for a cell that has no value, in lower case.
const CELL_ERRORS: [&str; 5] = ["#value!", "#div/0!", "#num!", "#ref!", "#null!"];

/// Whether a line holds neither names nor numbers.
pub(super) fn is_comment(bytes: &[u8]) -> bool {
    matches!(bytes.trim_ascii_start().first(), Some(b'#' | b'%'))
}

/// The separator that a line names, as spreadsheets write it: `sep=;`.
pub(super) fn named_separator(line: &[u8]) -> Option<u8> {
    let line = line.strip_prefix("\u{feff}".as_bytes()).unwrap_or(line).trim_ascii_start();
    let line = line.strip_prefix(b"\"").unwrap_or(line);
    let (word, rest) = line.split_at_checked(4)?;
    let [separator, rest @ ..] = rest else { return None };
    let is_end = rest.trim_ascii().is_empty() || rest.trim_ascii() == b"\"";
    let is_separator = matches!(separator, b'\t' | b';' | b',' | b' ' | b'|');
    (word.eq_ignore_ascii_case(b"sep=") && is_end && is_separator).then_some(*separator)
}

/// What separates the fields of a header: the most frequent candidate outside quotes.
pub(super) fn separator(header: &[u8]) -> u8 {
    let count = |separator: u8| {
        let mut quotes = Quotes::new(separator);
        let counted = header.iter().filter(|byte| {
            let inside = quotes.open();
            quotes.pass(std::slice::from_ref(byte));
            **byte == separator && !inside
        });
        counted.count()
    };
    // The last of equal ones is the greatest.
    SEPARATORS.into_iter().rev().max_by_key(|separator| count(*separator)).unwrap_or(b',')
}

/// Calls `each` with every field of a row, blanks around it cut off, and returns how many there were.
pub(super) fn fields<E>(
    row: Row<'_>,
    separator: u8,
    mut each: impl FnMut(usize, &[u8]) -> Result<(), E>,
) -> Result<usize, E> {
    if row.quoted {
        return quoted_fields(row.bytes, separator, each);
    }
    if separator == BLANK {
        let fields = row.bytes.split(u8::is_ascii_whitespace).filter(|field| !field.is_empty());
        return fields.enumerate().try_fold(0, |_, (index, field)| {
            each(index, field)?;
            Ok(index + 1)
        });
    }
    let (mut rest, mut index) = (row.bytes, 0);
    loop {
        let end = memchr(separator, rest);
        each(index, rest[..end.unwrap_or(rest.len())].trim_ascii())?;
        index += 1;
        match end {
            Some(end) => rest = &rest[end + 1..],
            None => return Ok(index),
        }
    }
}

fn quoted_fields<E>(
    bytes: &[u8],
    separator: u8,
    mut each: impl FnMut(usize, &[u8]) -> Result<(), E>,
) -> Result<usize, E> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .delimiter(separator)
        .buffer_capacity(256)
        .from_reader(bytes);
    let mut record = csv::ByteRecord::new();
    // Memory can neither fail to be read nor hold rows of different lengths where there is one.
    let _ = reader.read_byte_record(&mut record);
    // Several blanks separate as one does.
    let fields = record.iter().filter(|field| separator != BLANK || !field.is_empty());
    fields.enumerate().try_fold(0, |_, (index, field)| {
        each(index, field.trim_ascii())?;
        Ok(index + 1)
    })
}

/// All fields of a row as text; `None` if one of them is not UTF-8.
pub(super) fn texts(row: Row<'_>, separator: u8) -> Option<Vec<String>> {
    let mut texts = Vec::new();
    let text = |_, field: &[u8]| {
        texts.push(std::str::from_utf8(field)?.trim().to_owned());
        Ok::<(), std::str::Utf8Error>(())
    };
    fields(row, separator, text).ok().map(|_| texts)
}

/// A number as it is written, its decimal mark a point or, where commas do not separate fields, a comma.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Number {
    /// NaN for an empty field, for `NaN` and for other words that say so; may be infinite.
    pub(super) value: f64,
    pub(super) mark: Option<u8>,
}

/// Reads a field; `None` if it is no number.
pub(super) fn number(field: &[u8], separator: u8) -> Option<Number> {
    if field.is_empty() {
        return Some(Number { value: f64::NAN, mark: None });
    }
    let mut mark = memchr(b'.', field).map(|_| b'.');
    let mut text = Cow::Borrowed(std::str::from_utf8(field).ok()?);
    if separator != b',' && memchr(b',', field).is_some() {
        // Both marks in one number: one of them groups digits, and which one it is may not be guessed.
        if mark.replace(b',').is_some() {
            return None;
        }
        text = Cow::Owned(text.replace(',', "."));
    }
    match text.parse() {
        Ok(value) => Some(Number { value, mark }),
        Err(_) if is_not_available(field) => Some(Number { value: f64::NAN, mark: None }),
        Err(_) => {
            let value = with_fortran_exponent(&text).or_else(|| with_groups(&text, separator))?;
            Some(Number { value, mark })
        }
    }
}

/// A number whose power of ten stands behind a `D`, as Fortran writes those of double precision.
fn with_fortran_exponent(text: &str) -> Option<f64> {
    let (mantissa, exponent) = text.split_once(['D', 'd'])?;
    mantissa.bytes().any(|byte| byte.is_ascii_digit()).then_some(())?;
    let exponent: i32 = exponent.parse().ok()?;
    format!("{mantissa}e{exponent}").parse().ok()
}

/// A number whose digits are in groups of three, `-1,407.57`: only where commas separate, so that it was quoted, and a point or a second group says that no comma is decimal.
fn with_groups(text: &str, separator: u8) -> Option<f64> {
    if separator != b',' {
        return None;
    }
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let mut groups = whole.split(',');
    let first = groups.next()?;
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let others: Vec<&str> = groups.collect();
    let is_grouped = (1..=3).contains(&first.len())
        && is_digits(first)
        && others.iter().all(|group| group.len() == 3 && is_digits(group))
        && is_digits(decimals);
    let is_clear = others.len() > 1 || (others.len() == 1 && digits.contains('.'));
    (is_grouped && is_clear).then(|| text.replace(',', "").parse().ok())?
}

/// Whether a field says that there is no number.
fn is_not_available(field: &[u8]) -> bool {
    let is = |word: &&str| field.eq_ignore_ascii_case(word.as_bytes());
    NOT_AVAILABLE.iter().chain(&CELL_ERRORS).any(is)
}

/// Whether a text is a number or what a clock shows.
pub(super) fn is_value(text: &str, separator: u8) -> bool {
    number(text.as_bytes(), separator).is_some() || super::clock::is_time(text)
}

#[cfg(test)]
mod tests;
