//! Where the table of a text begins, where its first line is no header: below a title, a preamble or
//! comments, with other separators, or without names.
//!
//! The table is the longest run of rows with equally many fields, at least half of them numbers,
//! under any of the separators. Its header is the nearest line above it with as many names, be it behind
//! `#` or `%`, and a row of units may stand between the two.

use super::dialect::{self, BLANK};
use super::header;
use super::lines::Row;

/// More lines than this are not looked at: by then a preamble is over.
const MOST_LINES: usize = 4000;

/// A header stands at most so many lines above its table.
const FARTHEST_HEADER: usize = 60;

/// What may separate fields. Of equally good ones the first is taken.
const SEPARATORS: [u8; 5] = [b'\t', b';', b',', b'|', BLANK];

/// A table, and how it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) separator: u8,
    /// Empty where no line names the columns.
    pub(super) names: Vec<String>,
    /// The line of the names, where there is one.
    pub(super) header_line: Option<u64>,
    pub(super) units: Option<Vec<Option<String>>>,
    /// The line of the units, where there is one.
    units_line: Option<u64>,
    /// The line of its first row of numbers.
    pub(super) first_row: u64,
    /// Fields of each row.
    pub(super) fields: usize,
    /// Whether the last of them is always empty: each row ends with a separator.
    ends_empty: bool,
}

/// Looks for a table in the start of a text, below so many lines. `is_whole` says that it is all of the text.
pub(super) fn search(start: &[u8], is_whole: bool, skip_lines: u64) -> Option<Layout> {
    let all = lines(start, is_whole);
    let lines: Vec<Line<'_>> =
        all.into_iter().filter(|line| line.number > skip_lines).take(MOST_LINES).collect();
    let named = lines.iter().find(|line| !line.bytes.trim_ascii().is_empty());
    let (separators, lines) = match named.and_then(|line| dialect::named_separator(line.bytes)) {
        Some(separator) => (vec![separator], &lines[1..]),
        None => (SEPARATORS.to_vec(), &lines[..]),
    };
    let mut best: Option<(Block, u8)> = None;
    for separator in separators {
        let Some(block) = longest(lines, separator) else { continue };
        if best.as_ref().is_none_or(|(other, _)| block.is_better(other)) {
            best = Some((block, separator));
        }
    }
    let (block, separator) = best?;
    let mut layout = Layout {
        separator,
        names: Vec::new(),
        header_line: None,
        units: None,
        units_line: None,
        first_row: lines[block.first].number,
        fields: block.fields,
        ends_empty: block.ends_empty,
    };
    header_above(&lines[..block.first], &mut layout);
    // Rows between the header and the table would be lost, be they of words or of another length.
    let is_lost = |line: &Line<'_>| {
        let is_row = row(line.bytes, separator).is_some()
            || texts(line.bytes, separator).is_some_and(|texts| texts.len() == layout.fields);
        layout.header_line.is_some_and(|header| line.number > header)
            && layout.units_line != Some(line.number)
            && !dialect::is_comment(line.bytes)
            && !is_rule(line.bytes)
            && is_row
    };
    (!lines[..block.first].iter().any(is_lost)).then_some(layout)
}

#[derive(Clone, Copy)]
struct Line<'a> {
    /// From 1.
    number: u64,
    bytes: &'a [u8],
}

/// All whole lines.
fn lines(text: &[u8], is_whole: bool) -> Vec<Line<'_>> {
    let text = text.strip_prefix("\u{feff}".as_bytes()).unwrap_or(text);
    let (mut found, mut from, mut number) = (Vec::new(), 0, 1);
    while let Some(length) = memchr::memchr2(b'\n', b'\r', &text[from..]) {
        let end = from + length;
        found.push(Line { number, bytes: &text[from..end] });
        let is_pair = text[end] == b'\r' && text.get(end + 1) == Some(&b'\n');
        from = end + 1 + usize::from(is_pair);
        number += 1;
    }
    if is_whole && from < text.len() {
        found.push(Line { number, bytes: &text[from..] });
    }
    found
}

/// Rows that belong together.
#[derive(Clone, Copy)]
struct Block {
    /// Index of its first line.
    first: usize,
    fields: usize,
    /// Fields that are numbers, in all rows.
    numbers: usize,
    ends_empty: bool,
}

impl Block {
    /// More numbers are the better reading of the same lines.
    fn is_better(&self, other: &Self) -> bool {
        let columns = |block: &Self| block.fields > 1;
        (columns(self), self.numbers) > (columns(other), other.numbers)
    }
}

fn longest(lines: &[Line<'_>], separator: u8) -> Option<Block> {
    let mut best: Option<Block> = None;
    let mut now: Option<Block> = None;
    for (index, line) in lines.iter().enumerate() {
        if line.bytes.trim_ascii().is_empty() || dialect::is_comment(line.bytes) {
            continue;
        }
        now = match (row(line.bytes, separator), now) {
            (Some(row), Some(block)) if block.fields == row.fields => Some(Block {
                numbers: block.numbers + row.numbers,
                ends_empty: block.ends_empty && row.ends_empty,
                ..block
            }),
            (Some(row), _) => Some(Block { first: index, ..row }),
            (None, _) => None,
        };
        if let Some(block) = now
            && best.is_none_or(|best| block.numbers > best.numbers)
        {
            best = Some(block);
        }
    }
    best
}

/// A row of numbers; `None` if it is none.
fn row(bytes: &[u8], separator: u8) -> Option<Block> {
    let texts = texts(bytes, separator)?;
    let is_number = |text: &&String| !text.is_empty() && dialect::is_value(text, separator);
    let numbers = texts.iter().filter(is_number).count();
    let empty = texts.iter().filter(|text| text.is_empty()).count();
    let ends_empty = texts.last().is_some_and(String::is_empty);
    let row = Block { first: 0, fields: texts.len(), numbers, ends_empty };
    (numbers > 0 && 2 * (numbers + empty) >= texts.len()).then_some(row)
}

fn texts(bytes: &[u8], separator: u8) -> Option<Vec<String>> {
    let quotes = bytes.iter().filter(|byte| **byte == b'"').count();
    if quotes % 2 == 1 {
        return None;
    }
    dialect::texts(Row { line: 0, bytes, quoted: quotes > 0 }, separator)
}

/// Finds the names, and the units between them and the rows.
fn header_above(above: &[Line<'_>], layout: &mut Layout) {
    for line in above.iter().rev().take(FARTHEST_HEADER) {
        let Some(fields) = fields_of(line.bytes, layout) else { continue };
        if is_rule(line.bytes) {
            continue;
        }
        let units = header::units(&fields);
        let is_name = |text: &&String| !text.is_empty() && !dialect::is_value(text, b';');
        if units.is_none() && 2 * fields.iter().filter(is_name).count() < fields.len() {
            continue;
        }
        if layout.names.is_empty() {
            (layout.names, layout.header_line) = (fields, Some(line.number));
            if units.is_none() {
                return;
            }
            // Either units, with the names above them, or names that look like units.
            continue;
        }
        if let Some(units) = header::units(&layout.names) {
            (layout.units, layout.units_line) = (Some(units), layout.header_line);
            (layout.names, layout.header_line) = (fields, Some(line.number));
        }
        return;
    }
}

/// Whether a line is drawn below a header: `# ---- ----`.
fn is_rule(bytes: &[u8]) -> bool {
    let drawn = |byte: &u8| b"-=+|_*#% \t,;".contains(byte);
    bytes.iter().all(drawn) && bytes.windows(2).any(|pair| matches!(pair, b"--" | b"==" | b"__"))
}

/// The fields of a line that may be a header: as many as the rows have, or one more or less at
/// the end where it is empty. One behind `#` or `%` may have other separators than they.
fn fields_of(bytes: &[u8], layout: &Layout) -> Option<Vec<String>> {
    let text = bytes.trim_ascii();
    let is_comment = dialect::is_comment(text);
    let text = if is_comment { without_marks(text) } else { text };
    let separators =
        if is_comment { &SEPARATORS[..] } else { std::slice::from_ref(&layout.separator) };
    separators.iter().find_map(|separator| {
        let mut fields = texts(text, *separator)?;
        if fields.len() == layout.fields + 1 && fields.last().is_some_and(String::is_empty) {
            fields.pop();
        }
        if fields.len() + 1 == layout.fields && layout.ends_empty {
            fields.push(String::new());
        }
        (fields.len() == layout.fields).then_some(fields)
    })
}

/// A comment without the marks in front of it.
fn without_marks(comment: &[u8]) -> &[u8] {
    let marks = comment.iter().take_while(|byte| matches!(byte, b'#' | b'%')).count();
    comment[marks..].trim_ascii()
}

#[cfg(test)]
mod tests;
