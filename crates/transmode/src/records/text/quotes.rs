//! Whether a place in a row is between quotes.

use memchr::memchr;

/// Follows the quotes through the bytes of a row, as a CSV reader does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quotes {
    separator: u8,
    place: Place,
    seen: bool,
}

/// Where in a row the next byte stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    FieldStart,
    Field,
    Inside,
    /// After a quote between quotes: it ends them, unless another one follows.
    AfterQuote,
}

impl Default for Quotes {
    fn default() -> Self {
        Self::new(b',')
    }
}

impl Quotes {
    /// At the start of a row.
    pub(super) fn new(separator: u8) -> Self {
        Self { separator, place: Place::FieldStart, seen: false }
    }

    /// Whether a quote is open.
    pub(super) fn open(self) -> bool {
        self.place == Place::Inside
    }

    /// Whether a field so far was quoted.
    pub(super) fn seen(self) -> bool {
        self.seen
    }

    /// Goes on over these bytes.
    pub(super) fn pass(&mut self, bytes: &[u8]) {
        // Nearly every row has none, and only the first line of a row is at the start of a field.
        if self.place == Place::FieldStart && memchr(b'"', bytes).is_none() {
            return;
        }
        for &byte in bytes {
            self.place = match (self.place, byte) {
                (Place::Inside, b'"') => Place::AfterQuote,
                (Place::Inside, _) => Place::Inside,
                (_, byte) if byte == self.separator => Place::FieldStart,
                // A quote amid a field is a character like any other.
                (Place::FieldStart | Place::AfterQuote, b'"') => {
                    self.seen = true;
                    Place::Inside
                }
                _ => Place::Field,
            };
        }
    }
}
