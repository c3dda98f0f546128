//! The rows of a text, with the line of the file on which each starts.

use std::io::{Error, Read};

use memchr::memchr2;

use super::quotes::Quotes;

/// A row longer than this is none: the file has no line breaks, or it is no text.
pub(super) const LONGEST_ROW: usize = 32 << 20;

/// Bytes read at once.
const CHUNK: usize = 1 << 18;

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Cuts a text into rows. A line ends with a line feed, a carriage return, or both in that order; a row is a line, and more where a quote is
/// open at its end.
#[derive(Debug)]
pub(super) struct Lines<R> {
    source: R,
    buffer: Vec<u8>,
    /// What has been read and not yet been given out is `buffer[start..end]`.
    start: usize,
    end: usize,
    /// Lines given out.
    lines: u64,
    at_end: bool,
    quotes: Quotes,
}

/// One row, without its end of line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row<'a> {
    /// The line on which it starts, from 1.
    pub(super) line: u64,
    pub(super) bytes: &'a [u8],
    /// Whether fields of it are quoted.
    pub(super) quoted: bool,
}

/// Why there is no next row.
#[derive(Debug)]
pub(super) enum LineError {
    Read(Error),
    /// A row that starts on this line does not end.
    Long {
        line: u64,
    },
    /// A quote is opened in the row that starts on this line, and never closed.
    OpenQuote {
        line: u64,
    },
}

impl<R: Read> Lines<R> {
    pub(super) fn new(source: R) -> Self {
        let (buffer, quotes) = (vec![0; CHUNK], Quotes::default());
        Self { source, buffer, start: 0, end: 0, lines: 0, at_end: false, quotes }
    }

    /// The first bytes of the text, a byte order mark among them, before any row is taken.
    pub(super) fn peek(&mut self) -> Result<&[u8], Error> {
        while self.end < CHUNK && self.fill()? {}
        Ok(&self.buffer[self.start..self.end])
    }

    /// Passes over a byte order mark.
    pub(super) fn skip_mark(&mut self) {
        if self.buffer[self.start..self.end].starts_with(BYTE_ORDER_MARK) {
            self.start += BYTE_ORDER_MARK.len();
        }
    }

    /// Quotes open at the start of a field, so that what separates the fields has to be known.
    pub(super) fn separated_by(&mut self, separator: u8) {
        self.quotes = Quotes::new(separator);
    }

    /// Passes over so many lines, whatever quotes they hold.
    pub(super) fn skip(&mut self, count: u64) -> Result<(), LineError> {
        for _ in 0..count {
            let line = self.lines + 1;
            let Some([_, whole]) = self.line(0, line, Quotes::default())? else { break };
            self.lines += 1;
            self.start += whole;
        }
        Ok(())
    }

    /// Lines given out or passed over.
    pub(super) fn taken(&self) -> u64 {
        self.lines
    }

    /// Whether what has been read is all there is.
    pub(super) fn is_at_end(&self) -> bool {
        self.at_end
    }

    /// The next row; `None` at the end.
    pub(super) fn next(&mut self) -> Result<Option<Row<'_>>, LineError> {
        let line = self.lines + 1;
        let mut quotes = self.quotes;
        // Of the row, and with the end of its last line.
        let (mut length, mut taken) = (0, 0);
        loop {
            let Some([text, whole]) = self.line(taken, line, quotes)? else {
                if length == 0 && taken == 0 {
                    return Ok(None);
                }
                return Err(LineError::OpenQuote { line });
            };
            self.lines += 1;
            let piece = self.start + taken..self.start + taken + text;
            quotes.pass(&self.buffer[piece]);
            length = taken + text;
            taken += whole;
            if !quotes.open() {
                break;
            }
            quotes.pass(b"\n");
        }
        let start = self.start;
        self.start += taken;
        let quoted = quotes.seen();
        Ok(Some(Row { line, bytes: &self.buffer[start..start + length], quoted }))
    }

    /// Length of the line that starts `from` bytes behind the start, without and with its end; `None` if nothing is left.
    fn line(
        &mut self,
        from: usize,
        row: u64,
        quotes: Quotes,
    ) -> Result<Option<[usize; 2]>, LineError> {
        let mut searched = 0;
        loop {
            let rest = &self.buffer[self.start + from..self.end];
            if let Some(found) = memchr2(b'\n', b'\r', &rest[searched..]) {
                let length = searched + found;
                let second = rest.get(length + 1);
                if rest[length] == b'\n' || second.is_some_and(|byte| *byte != b'\n') {
                    return Ok(Some([length, length + 1]));
                }
                if second.is_some() {
                    return Ok(Some([length, length + 2]));
                }
                // A carriage return ends what has been read: the line feed may follow.
                if !self.fill().map_err(LineError::Read)? {
                    return Ok(Some([length, length + 1]));
                }
                searched = length;
                continue;
            }
            searched = rest.len();
            if self.end - self.start > LONGEST_ROW {
                let open = quotes.open();
                return Err(if open {
                    LineError::OpenQuote { line: row }
                } else {
                    LineError::Long { line: row }
                });
            }
            if !self.fill().map_err(LineError::Read)? {
                return Ok((searched > 0).then_some([searched, searched]));
            }
        }
    }

    /// Reads more behind what is there; whether there was more.
    fn fill(&mut self) -> Result<bool, Error> {
        if self.at_end {
            return Ok(false);
        }
        if self.start > 0 {
            self.buffer.copy_within(self.start..self.end, 0);
            self.end -= self.start;
            self.start = 0;
        }
        if self.buffer.len() < self.end + CHUNK {
            self.buffer.resize((self.end + CHUNK).next_power_of_two(), 0);
        }
        loop {
            match self.source.read(&mut self.buffer[self.end..]) {
                Ok(0) => self.at_end = true,
                Ok(length) => self.end += length,
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            }
            return Ok(!self.at_end);
        }
    }
}

#[cfg(test)]
mod tests;
