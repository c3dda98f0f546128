//! Raw files: little-endian doubles, one sample of all channels after another, nothing else.

use std::io::Read;

use super::binary::{ByteOrder, Layout, Number, Placement, Width};
use super::format::NPY_MAGIC;
use super::format_error::FormatError;
use super::npy;

/// Where the numbers of a file of `length` bytes lie. The source stands at its beginning.
pub(crate) fn placement(
    source: &mut impl Read,
    length: u64,
    channels: u64,
) -> Result<Placement, npy::NpyError> {
    if length == 0 {
        return Err(FormatError::Empty.into());
    }
    let mut start = Vec::new();
    source.by_ref().take(NPY_MAGIC.len() as u64).read_to_end(&mut start)?;
    if start == NPY_MAGIC {
        return Err(FormatError::IsNpy.into());
    }
    let number = Number { width: Width::Eight, byte_order: ByteOrder::Little };
    let row = channels.saturating_mul(u64::from(number.width.bytes()));
    if row == 0 || !length.is_multiple_of(row) {
        return Err(FormatError::RawLength { length, channels, row }.into());
    }
    Ok(Placement::new(0, [length / row, channels], Layout::SampleBySample, number, length)?)
}

#[cfg(test)]
mod tests;
