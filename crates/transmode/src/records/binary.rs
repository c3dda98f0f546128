//! Records as blocks of numbers: where each sample of each channel lies in the file.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

use super::format_error::FormatError;
use crate::CommandError;
use crate::error::in_file;

/// More channels than this are refused: it is an array of channels x samples, and a row of it would fill the memory.
const MOST_CHANNELS: u64 = 1_000_000;

/// Bytes read at once: enough to keep the disk busy, little beside any machine's memory.
const BLOCK_BYTES: u64 = 4 << 20;

/// Where the numbers of a record lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Placement {
    /// Bytes before the first number.
    offset: u64,
    samples: u64,
    channels: u64,
    layout: Layout,
    number: Number,
}

/// Which numbers are neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layout {
    /// All channels of a sample, then the next sample.
    SampleBySample,
    /// All samples of a channel, then the next channel.
    ChannelByChannel,
}

/// How a number is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Number {
    pub(crate) width: Width,
    pub(crate) byte_order: ByteOrder,
}

/// The size of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Width {
    Four,
    Eight,
}

/// Which end of a number comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ByteOrder {
    Little,
    Big,
}

impl Placement {
    /// Numbers that fill a file of `length` bytes from `offset` on.
    pub(crate) fn new(
        offset: u64,
        [samples, channels]: [u64; 2],
        layout: Layout,
        number: Number,
        length: u64,
    ) -> Result<Self, FormatError> {
        if samples == 0 || channels == 0 {
            return Err(FormatError::Empty);
        }
        if channels > MOST_CHANNELS {
            return Err(FormatError::TooManyChannels { channels, limit: MOST_CHANNELS });
        }
        let needed = u128::from(samples) * u128::from(channels) * u128::from(number.width.bytes());
        let found = length.saturating_sub(offset);
        if needed != u128::from(found) {
            return Err(FormatError::Length { samples, channels, needed, found });
        }
        Ok(Self { offset, samples, channels, layout, number })
    }

    /// Reads the channels asked for, all samples of each.
    pub(crate) fn read(
        &self,
        source: &mut (impl Read + Seek),
        wanted: &[usize],
        mut progress: impl FnMut(u64),
    ) -> Result<Vec<Vec<f64>>, Error> {
        let width = u64::from(self.number.width.bytes());
        // One sample after another of all channels, or of one channel alone.
        let (passes, row) = match self.layout {
            Layout::SampleBySample => (1, self.channels * width),
            Layout::ChannelByChannel => (wanted.len(), width),
        };
        let at_once = (BLOCK_BYTES / row).max(1);
        let mut values = vec![Vec::new(); wanted.len()];
        let mut bytes = Vec::new();
        for pass in 0..passes {
            let before =
                if self.layout == Layout::SampleBySample { 0 } else { wanted[pass] as u64 };
            source.seek(SeekFrom::Start(self.offset + before * self.samples * width))?;
            let mut left = self.samples;
            while left > 0 {
                let samples = at_once.min(left);
                bytes.resize(length(samples * row), 0);
                source.read_exact(&mut bytes)?;
                if self.layout == Layout::ChannelByChannel {
                    self.number.decode(&bytes, length(width), &mut values[pass]);
                } else {
                    for (channel, values) in wanted.iter().zip(&mut values) {
                        let from = channel * usize::from(self.number.width.bytes());
                        self.number.decode(
                            bytes.get(from..).unwrap_or_default(),
                            length(row),
                            values,
                        );
                    }
                }
                left -= samples;
                progress(samples * row);
            }
        }
        Ok(values)
    }

    pub(crate) fn offset(&self) -> u64 {
        self.offset
    }

    pub(crate) fn samples(&self) -> u64 {
        self.samples
    }

    pub(crate) fn channels(&self) -> u64 {
        self.channels
    }

    pub(crate) fn layout(&self) -> Layout {
        self.layout
    }

    pub(crate) fn number(&self) -> Number {
        self.number
    }
}

impl ByteOrder {
    /// The whole number that four bytes stand for.
    pub(crate) fn u32(self, bytes: [u8; 4]) -> u32 {
        match self {
            Self::Little => u32::from_le_bytes(bytes),
            Self::Big => u32::from_be_bytes(bytes),
        }
    }
}

impl Width {
    pub(crate) fn bytes(self) -> u8 {
        match self {
            Self::Four => 4,
            Self::Eight => 8,
        }
    }
}

impl Number {
    /// Appends the numbers that stand at the start of every `stride` bytes.
    pub(crate) fn decode(self, bytes: &[u8], stride: usize, values: &mut Vec<f64>) {
        let eight = |read: fn([u8; 8]) -> f64| {
            bytes.chunks(stride).filter_map(|c| c.first_chunk()).map(move |c| read(*c))
        };
        let four = |read: fn([u8; 4]) -> f32| {
            bytes.chunks(stride).filter_map(|c| c.first_chunk()).map(move |c| f64::from(read(*c)))
        };
        match (self.width, self.byte_order) {
            (Width::Eight, ByteOrder::Little) => values.extend(eight(f64::from_le_bytes)),
            (Width::Eight, ByteOrder::Big) => values.extend(eight(f64::from_be_bytes)),
            (Width::Four, ByteOrder::Little) => values.extend(four(f32::from_le_bytes)),
            (Width::Four, ByteOrder::Big) => values.extend(four(f32::from_be_bytes)),
        }
    }
}

/// Opens a file whose length is known, and says it.
pub(crate) fn open(file: &Path) -> Result<(File, u64), CommandError> {
    let fault = |source| CommandError::Read { file: file.to_owned(), source };
    // Before it is opened: opening a pipe would wait for its other end.
    let metadata = file.metadata().map_err(fault)?;
    if metadata.is_dir() {
        return Err(fault(Error::from(ErrorKind::IsADirectory)));
    }
    if !metadata.is_file() {
        return Err(in_file(file, &FormatError::NotRegular));
    }
    Ok((File::open(file).map_err(fault)?, metadata.len()))
}

/// A length in memory.
fn length(bytes: u64) -> usize {
    usize::try_from(bytes).expect("a block and a sample are a few megabytes")
}
