//! Text compressed with Zstandard: one frame or several, one after another.

use std::io::{BufRead, Error, ErrorKind, Read, Result};

use ruzstd::decoding::{FrameDecoder, StreamingDecoder};

/// The bytes of all frames.
pub(super) struct Frames<R: BufRead> {
    state: State<R>,
}

enum State<R: BufRead> {
    Between(R),
    Within(Box<StreamingDecoder<R, FrameDecoder>>),
    /// At its end, or behind an error.
    Over,
}

impl<R: BufRead> Frames<R> {
    pub(super) fn new(source: R) -> Self {
        Self { state: State::Between(source) }
    }
}

impl<R: BufRead> Read for Frames<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let damaged = |error: String| Error::new(ErrorKind::InvalidData, error);
        loop {
            match std::mem::replace(&mut self.state, State::Over) {
                State::Over => return Ok(0),
                State::Between(mut source) => {
                    if source.fill_buf()?.is_empty() {
                        return Ok(0);
                    }
                    let frame = StreamingDecoder::new(source);
                    let frame = frame.map_err(|error| damaged(error.to_string()))?;
                    self.state = State::Within(Box::new(frame));
                }
                State::Within(mut frame) => {
                    let length = frame.read(buffer)?;
                    if length > 0 || buffer.is_empty() {
                        self.state = State::Within(frame);
                        return Ok(length);
                    }
                    self.state = State::Between(frame.into_inner());
                }
            }
        }
    }
}
