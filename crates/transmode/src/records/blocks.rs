//! Two channels of a binary record, a block of samples at a time.

use std::io::{Read, Result, Seek, SeekFrom};

use super::binary::{Layout, Placement};

/// Bytes read at once: enough to keep the disk and the sums busy, little beside any machine's memory.
const BLOCK_BYTES: u64 = 4 << 20;

/// Reads two channels of a record of any length in constant memory.
#[derive(Debug)]
pub(crate) struct Blocks<R> {
    source: R,
    placement: Placement,
    /// Input and output.
    channels: [u64; 2],
    samples_at_once: u64,
    next: u64,
    bytes: Vec<u8>,
    values: [Vec<f64>; 2],
}

/// Consecutive samples of two channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block<'a> {
    /// Index of the first sample.
    pub(crate) first: u64,
    pub(crate) input: &'a [f64],
    pub(crate) output: &'a [f64],
}

impl<R: Read + Seek> Blocks<R> {
    /// Blocks of about four megabytes. The channels must be there.
    pub(crate) fn new(source: R, placement: Placement, channels: [u64; 2]) -> Self {
        let width = u64::from(placement.number().width.bytes());
        let sample_bytes = match placement.layout() {
            Layout::SampleBySample => placement.channels() * width,
            Layout::ChannelByChannel => 2 * width,
        };
        Self::of_samples(source, placement, channels, BLOCK_BYTES / sample_bytes)
    }

    /// Blocks of so many samples, at least one.
    fn of_samples(source: R, placement: Placement, channels: [u64; 2], samples: u64) -> Self {
        let (bytes, values) = (Vec::new(), [Vec::new(), Vec::new()]);
        let samples_at_once = samples.max(1);
        Self { source, placement, channels, samples_at_once, next: 0, bytes, values }
    }

    /// The next block; `None` at the end.
    pub(crate) fn next(&mut self) -> Result<Option<Block<'_>>> {
        let first = self.next;
        let samples = self.samples_at_once.min(self.placement.samples() - first);
        if samples == 0 {
            return Ok(None);
        }
        self.values.iter_mut().for_each(Vec::clear);
        match self.placement.layout() {
            Layout::SampleBySample => self.read_samples(first, samples)?,
            Layout::ChannelByChannel => {
                self.read_channel(0, first, samples)?;
                self.read_channel(1, first, samples)?;
            }
        }
        self.next += samples;
        let [input, output] = &self.values;
        Ok(Some(Block { first, input, output }))
    }

    fn read_samples(&mut self, first: u64, samples: u64) -> Result<()> {
        let number = self.placement.number();
        let width = u64::from(number.width.bytes());
        let row = self.placement.channels() * width;
        self.read(first * row, samples * row)?;
        for (channel, values) in self.channels.iter().zip(&mut self.values) {
            let bytes = self.bytes.get(length(channel * width)..).unwrap_or_default();
            number.decode(bytes, length(row), values);
        }
        Ok(())
    }

    fn read_channel(&mut self, which: usize, first: u64, samples: u64) -> Result<()> {
        let number = self.placement.number();
        let width = u64::from(number.width.bytes());
        let from = (self.channels[which] * self.placement.samples() + first) * width;
        self.read(from, samples * width)?;
        number.decode(&self.bytes, length(width), &mut self.values[which]);
        Ok(())
    }

    /// Reads `count` bytes at `from` behind the header.
    fn read(&mut self, from: u64, count: u64) -> Result<()> {
        self.source.seek(SeekFrom::Start(self.placement.offset() + from))?;
        self.bytes.resize(length(count), 0);
        self.source.read_exact(&mut self.bytes)
    }
}

/// A length in memory.
fn length(bytes: u64) -> usize {
    usize::try_from(bytes).expect("a block and a sample are a few megabytes")
}

#[cfg(test)]
mod tests;
