//! Texts that are not in UTF-8, as they are read: UTF-16 behind its byte order mark, and letters of Western European code pages.

use std::io::{Read, Result};

/// Bytes that code pages of Western Europe have for letters and signs, as in Unicode: the degree sign is among them. Below are control characters, and two above
/// are what damaged files are full of.
const LETTERS: std::ops::RangeInclusive<u8> = 0xa0..=0xfd;

const CHUNK: usize = 1 << 16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Unknown,
    /// UTF-8, or a code page of which the letters are replaced.
    Bytes,
    Utf16 {
        big_endian: bool,
    },
}

/// Gives out UTF-8 where it can: bytes that are neither that nor letters stay what they are.
#[derive(Debug)]
pub(super) struct Decoded<R> {
    source: R,
    encoding: Encoding,
    /// What has been read and not been decoded.
    raw: Vec<u8>,
    /// What has been decoded; `ready[given..]` has not been given out.
    ready: Vec<u8>,
    given: usize,
    at_end: bool,
}

impl<R: Read> Decoded<R> {
    pub(super) fn new(source: R) -> Self {
        let (raw, ready) = (Vec::new(), Vec::new());
        Self { source, encoding: Encoding::Unknown, raw, ready, given: 0, at_end: false }
    }

    /// Reads and decodes more; nothing more is ready at the end.
    fn advance(&mut self) -> Result<()> {
        self.ready.clear();
        self.given = 0;
        while self.ready.is_empty() && !self.at_end {
            let start = self.raw.len();
            self.raw.resize(start + CHUNK, 0);
            let length = self.source.read(&mut self.raw[start..])?;
            self.raw.truncate(start + length);
            self.at_end = length == 0;
            if self.encoding == Encoding::Unknown && (self.raw.len() > 1 || self.at_end) {
                self.encoding = match self.raw.get(..2) {
                    Some(b"\xff\xfe") => Encoding::Utf16 { big_endian: false },
                    Some(b"\xfe\xff") => Encoding::Utf16 { big_endian: true },
                    _ => Encoding::Bytes,
                };
            }
            match self.encoding {
                Encoding::Unknown => {}
                Encoding::Bytes => self.decode_bytes(),
                Encoding::Utf16 { big_endian } => self.decode_utf16(big_endian),
            }
        }
        Ok(())
    }

    fn decode_bytes(&mut self) {
        let mut rest = self.raw.as_slice();
        loop {
            let error = match std::str::from_utf8(rest) {
                Ok(_) => {
                    self.ready.extend_from_slice(rest);
                    rest = &[];
                    break;
                }
                Err(error) => error,
            };
            let (valid, more) = rest.split_at(error.valid_up_to());
            self.ready.extend_from_slice(valid);
            // A character that is cut may go on in what comes next.
            if error.error_len().is_none() && !self.at_end {
                rest = more;
                break;
            }
            let (length, bytes) = (error.error_len().unwrap_or(more.len()), more);
            for byte in &bytes[..length] {
                if LETTERS.contains(byte) {
                    let mut text = [0; 2];
                    self.ready
                        .extend_from_slice(char::from(*byte).encode_utf8(&mut text).as_bytes());
                } else {
                    self.ready.push(*byte);
                }
            }
            rest = &bytes[length..];
        }
        self.raw = rest.to_vec();
    }

    fn decode_utf16(&mut self, big_endian: bool) {
        let mut units: Vec<u16> = self
            .raw
            .chunks_exact(2)
            .map(|pair| {
                let pair = [pair[0], pair[1]];
                if big_endian { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
            })
            .collect();
        // The first half of a pair waits for the second.
        if units.last().is_some_and(|unit| (0xd800..0xdc00).contains(unit)) && !self.at_end {
            units.pop();
        }
        let taken = 2 * units.len();
        let text =
            char::decode_utf16(units).map(|found| found.unwrap_or(char::REPLACEMENT_CHARACTER));
        self.ready.extend(text.collect::<String>().as_bytes());
        self.raw.drain(..taken);
    }
}

impl<R: Read> Read for Decoded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        if self.given == self.ready.len() {
            self.advance()?;
        }
        let length = buffer.len().min(self.ready.len() - self.given);
        buffer[..length].copy_from_slice(&self.ready[self.given..self.given + length]);
        self.given += length;
        Ok(length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A source that gives so many bytes at once.
    struct Slow<'a>(&'a [u8], usize);

    impl Read for Slow<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
            let length = self.0.len().min(self.1).min(buffer.len());
            buffer[..length].copy_from_slice(&self.0[..length]);
            self.0 = &self.0[length..];
            Ok(length)
        }
    }

    fn check(bytes: &[u8], expected: &[u8]) {
        for step in [1, 2, 3, 1000] {
            let mut found = Vec::new();
            Decoded::new(Slow(bytes, step)).read_to_end(&mut found).unwrap();
            assert_eq!(found, expected, "{step}");
        }
    }

    #[test]
    fn utf16_with_its_mark() {
        let text = "time,\u{3b2} [\u{b0}]\r\n\u{1d11e}\n";
        for big_endian in [false, true] {
            let unit = |unit: u16| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() };
            let bytes: Vec<u8> =
                std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(unit).collect();
            check(&bytes, format!("\u{feff}{text}").as_bytes());
        }
    }

    #[test]
    fn letters_of_code_pages_and_nothing_else() {
        check(b"p [\xb0/s]", "p [\u{b0}/s]".as_bytes());
        check("p [\u{b0}/s] \u{20ac}".as_bytes(), "p [\u{b0}/s] \u{20ac}".as_bytes());
        check(b"a\xff\xfe\x81b", b"a\xff\xfe\x81b");
        check(b"caf\xe9", "caf\u{e9}".as_bytes());
        check(b"", b"");
        check(b"\xff", b"\xff");
    }
}
