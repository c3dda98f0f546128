//! Counts the lines of a text while it is being read, so that a message can name the line that an editor shows.

use std::io::Read;

/// Passes a text on and remembers which of its line ends end no record: those of blank lines, which a CSV reader skips in silence, and
/// those between quotes.
#[derive(Debug)]
pub(super) struct CountedLines<R> {
    source: R,
    /// For each line end that ends no record, the index of the first record that stands below it. Ascending.
    extra_above: Vec<u64>,
    /// Records that have ended.
    ended: u64,
    place: Place,
    after_carriage_return: bool,
    /// Bytes of a byte order mark passed so far; its length once there can be no more.
    mark: usize,
    at_end: bool,
}

/// Where in a record the next byte stands. A CSV reader goes through the same states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    LineStart,
    FieldStart,
    Field,
    Quotes,
    /// After a quote between quotes: it ends them, unless another one follows.
    QuoteInQuotes,
}

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

impl<R> CountedLines<R> {
    pub(super) fn new(source: R) -> Self {
        Self {
            source,
            extra_above: Vec::new(),
            ended: 0,
            place: Place::LineStart,
            after_carriage_return: false,
            mark: 0,
            at_end: false,
        }
    }

    /// The number, from 1, of the line on which record `index`, from 0, starts. It must have been read already.
    pub(super) fn line(&self, index: u64) -> u64 {
        let extra = self.extra_above.partition_point(|&below| below <= index);
        index + 1 + extra as u64
    }

    /// Whether the text is over and a quote is still open.
    pub(super) fn ended_in_quotes(&self) -> bool {
        self.at_end && self.place == Place::Quotes
    }

    fn count(&mut self, byte: u8) {
        if BYTE_ORDER_MARK.get(self.mark) == Some(&byte) {
            self.mark += 1;
            return;
        }
        self.mark = BYTE_ORDER_MARK.len();
        // A line ends with a line feed, a carriage return, or both in that order.
        let second_half = byte == b'\n' && self.after_carriage_return;
        self.after_carriage_return = byte == b'\r';
        if second_half {
            return;
        }
        self.place = match (self.place, byte) {
            (Place::Quotes, b'"') => Place::QuoteInQuotes,
            (Place::Quotes, b'\n' | b'\r') => {
                self.extra_above.push(self.ended + 1);
                Place::Quotes
            }
            (Place::Quotes, _) => Place::Quotes,
            (Place::LineStart, b'\n' | b'\r') => {
                self.extra_above.push(self.ended);
                Place::LineStart
            }
            (_, b'\n' | b'\r') => {
                self.ended += 1;
                Place::LineStart
            }
            (_, b',') => Place::FieldStart,
            // A quote amid a field is a character like any other.
            (Place::LineStart | Place::FieldStart | Place::QuoteInQuotes, b'"') => Place::Quotes,
            _ => Place::Field,
        };
    }
}

impl<R: Read> Read for CountedLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let length = self.source.read(buffer)?;
        self.at_end = length == 0 && !buffer.is_empty();
        for &byte in &buffer[..length] {
            self.count(byte);
        }
        Ok(length)
    }
}
