//! Arrays of structures, one a sample, whose fields are channels; and arrays of whole numbers.

use std::io::{Read, Result, Seek, SeekFrom};

use super::Array;
use super::header::Descr;
use crate::records::binary::{ByteOrder, Layout};
use crate::records::format_error::FormatError;

/// Bytes read at once.
const AT_ONCE: u64 = 1 << 20;

/// A sample longer than this is none: the array is the wrong way round, or damaged.
const LONGEST_SAMPLE: u64 = 16 << 20;

/// Where the channels are in each sample.
#[derive(Clone, Debug)]
pub(in crate::records) struct Fields {
    offset: u64,
    samples: u64,
    /// Bytes of a sample.
    stride: u64,
    channels: Vec<Channel>,
}

#[derive(Clone, Debug)]
struct Channel {
    /// `None` in an array without fields.
    name: Option<String>,
    /// Bytes in front of it in a sample.
    at: usize,
    kind: Kind,
}

/// How a number is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::records) struct Kind {
    class: Class,
    width: usize,
    byte_order: ByteOrder,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Float,
    Signed,
    Unsigned,
}

impl Kind {
    /// `<f8`, `|u1`, `>i2`, `|b1`; `None` for what is no number.
    pub(in crate::records) fn parse(descr: &str) -> Option<Self> {
        let (order, rest) = descr.split_at_checked(1)?;
        let byte_order = match order {
            "<" | "|" => ByteOrder::Little,
            ">" => ByteOrder::Big,
            _ => return None,
        };
        let (class, width) = match rest {
            "f4" => (Class::Float, 4),
            "f8" => (Class::Float, 8),
            "i1" => (Class::Signed, 1),
            "i2" => (Class::Signed, 2),
            "i4" => (Class::Signed, 4),
            "i8" => (Class::Signed, 8),
            "u1" | "b1" => (Class::Unsigned, 1),
            "u2" => (Class::Unsigned, 2),
            "u4" => (Class::Unsigned, 4),
            "u8" => (Class::Unsigned, 8),
            _ => return None,
        };
        Some(Self { class, width, byte_order })
    }

    /// The number at the start of these bytes.
    fn read(self, bytes: &[u8]) -> Option<f64> {
        let mut all = [0; 8];
        for (index, byte) in bytes.get(..self.width)?.iter().enumerate() {
            let place =
                if self.byte_order == ByteOrder::Big { self.width - 1 - index } else { index };
            all[place] = *byte;
        }
        let unused = 64 - 8 * self.width;
        Some(match (self.class, self.width) {
            (Class::Float, 4) => f64::from(f32::from_le_bytes([all[0], all[1], all[2], all[3]])),
            (Class::Float, _) => f64::from_le_bytes(all),
            (Class::Unsigned, _) => u64::from_le_bytes(all) as f64,
            (Class::Signed, _) => ((i64::from_le_bytes(all) << unused) >> unused) as f64,
        })
    }
}

/// Bytes of a field that is no number, which is passed over: text, or what has no type.
fn width_of_other(descr: &str) -> Option<u64> {
    let number = |from: usize| descr.get(from..)?.parse::<u64>().ok();
    match descr.as_bytes().get(1)? {
        b'S' | b'V' | b'a' | b'c' => number(2),
        b'U' => number(2)?.checked_mul(4),
        // Dates, and long and short floats.
        b'M' | b'm' => Some(8),
        b'f' => number(2),
        _ => None,
    }
}

impl Fields {
    pub(super) fn new(array: &Array) -> std::result::Result<Self, FormatError> {
        let [samples, columns] = array.shape[..] else {
            return Err(FormatError::Dimensions { found: array.shape.clone() });
        };
        let (mut channels, mut stride) = (Vec::new(), 0_u64);
        let fits = |stride: u64| stride <= LONGEST_SAMPLE;
        let too_many = || FormatError::TooManyChannels { channels: columns, limit: LONGEST_SAMPLE };
        match &array.descr {
            Descr::Number(descr) => {
                let unreadable =
                    || FormatError::Numbers { descr: descr.chars().take(20).collect() };
                let kind = Kind::parse(descr).ok_or_else(unreadable)?;
                let width = kind.width as u64;
                if array.layout == Layout::ChannelByChannel && columns > 1 {
                    return Err(unreadable());
                }
                stride = columns.saturating_mul(width);
                if !fits(stride) {
                    return Err(too_many());
                }
                channels.extend((0..columns).map(|column| Channel {
                    name: None,
                    at: usize::try_from(column * width).unwrap_or(usize::MAX),
                    kind,
                }));
            }
            Descr::Structure(_) if columns != 1 => return Err(FormatError::Structured),
            Descr::Structure(fields) => {
                for field in fields {
                    let kind = Kind::parse(&field.descr);
                    let width = kind.map(|kind| kind.width as u64);
                    let Some(width) = width.or_else(|| width_of_other(&field.descr)) else {
                        let descr = field.descr.chars().take(20).collect();
                        return Err(FormatError::Numbers { descr });
                    };
                    let end = width.saturating_mul(field.count).saturating_add(stride);
                    if !fits(end) {
                        return Err(too_many());
                    }
                    for index in (0..field.count).filter(|_| !field.name.is_empty()) {
                        let Some(kind) = kind else { break };
                        let name = match field.count {
                            1 => field.name.clone(),
                            _ => format!("{}_{index}", field.name),
                        };
                        let at = usize::try_from(stride + index * width).unwrap_or(usize::MAX);
                        channels.push(Channel { name: Some(name), at, kind });
                    }
                    stride = end;
                }
            }
        }
        let needed = u128::from(samples) * u128::from(stride);
        let found = array.length.saturating_sub(array.offset);
        if samples == 0 || channels.is_empty() {
            return Err(FormatError::Empty);
        }
        if needed != u128::from(found) {
            let channels = channels.len() as u64;
            return Err(FormatError::Length { samples, channels, needed, found });
        }
        Ok(Self { offset: array.offset, samples, stride, channels })
    }

    pub(super) fn samples(&self) -> u64 {
        self.samples
    }

    pub(super) fn names(&self) -> Vec<Option<String>> {
        self.channels.iter().map(|channel| channel.name.clone()).collect()
    }

    /// Reads the channels asked for, all samples of each.
    pub(super) fn read(
        &self,
        source: &mut (impl Read + Seek),
        wanted: &[usize],
        mut progress: impl FnMut(u64),
    ) -> Result<Vec<Vec<f64>>> {
        source.seek(SeekFrom::Start(self.offset))?;
        let stride = usize::try_from(self.stride).unwrap_or(usize::MAX).max(1);
        let at_once = (AT_ONCE / self.stride.max(1)).max(1);
        let mut values = vec![Vec::new(); wanted.len()];
        let (mut bytes, mut left) = (Vec::new(), self.samples);
        while left > 0 {
            let samples = at_once.min(left);
            bytes.resize(usize::try_from(samples).unwrap_or(0) * stride, 0);
            source.read_exact(&mut bytes)?;
            for sample in bytes.chunks(stride) {
                for (channel, values) in wanted.iter().zip(&mut values) {
                    let Channel { at, kind, .. } = &self.channels[*channel];
                    values.push(
                        sample.get(*at..).and_then(|bytes| kind.read(bytes)).unwrap_or(f64::NAN),
                    );
                }
            }
            left -= samples;
            progress(samples * self.stride);
        }
        Ok(values)
    }
}
