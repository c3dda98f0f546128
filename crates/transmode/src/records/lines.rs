//! Counts the lines of a text while it is being read, so that a message can name the line that an editor shows.

use std::io::Read;

/// Passes a text on and remembers where its blank lines are, which a CSV reader skips in silence.
#[derive(Debug)]
pub(super) struct CountedLines<R> {
    source: R,
    /// For each blank line, how many lines with content came before it.
    blank_after: Vec<u64>,
    /// Lines with content that have ended.
    ended: u64,
    has_content: bool,
    after_carriage_return: bool,
}

impl<R> CountedLines<R> {
    pub(super) fn new(source: R) -> Self {
        Self {
            source,
            blank_after: Vec::new(),
            ended: 0,
            has_content: false,
            after_carriage_return: false,
        }
    }

    /// The number, from 1, of line `index` of those with content, from 0. It must have been read already.
    pub(super) fn line(&self, index: u64) -> u64 {
        let blank = self.blank_after.partition_point(|&before| before <= index);
        index + 1 + blank as u64
    }

    fn count(&mut self, byte: u8) {
        // A line ends with a line feed, a carriage return, or both in that order.
        let second_half = byte == b'\n' && self.after_carriage_return;
        self.after_carriage_return = byte == b'\r';
        match byte {
            _ if second_half => {}
            b'\n' | b'\r' if self.has_content => {
                self.ended += 1;
                self.has_content = false;
            }
            b'\n' | b'\r' => self.blank_after.push(self.ended),
            _ => self.has_content = true,
        }
    }
}

impl<R: Read> Read for CountedLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let length = self.source.read(buffer)?;
        for &byte in &buffer[..length] {
            self.count(byte);
        }
        Ok(length)
    }
}
