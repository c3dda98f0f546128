//! NPY files, as `numpy.save` writes them: a short header, then the numbers of one array.
//!
//! The header is read here, in a few lines, because what is needed is three entries of one form. The crate for it, npyz 0.9.1, brings
//! fourteen more with a parser generator and assembly to build, and a header whose sizes overflow makes it panic.
//!
//! Format: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", and `numpy.lib.format`, versions 1.0 to 3.0.

mod header;

use std::io::{ErrorKind, Read};

use super::binary::{Ends, Number, Order, Placement, Width};
use super::format_error::FormatError;
use header::Header;

/// What every NPY file starts with.
pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

/// Three entries of a plain array take about a hundred bytes, padding included; numpy itself reads 10 000.
const LONGEST_HEADER: u64 = 1 << 16;

/// Why a header was not read.
#[derive(Debug)]
pub(crate) enum NpyError {
    Read(std::io::Error),
    Format(FormatError),
}

impl From<FormatError> for NpyError {
    fn from(error: FormatError) -> Self {
        Self::Format(error)
    }
}

impl From<std::io::Error> for NpyError {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            ErrorKind::UnexpectedEof => Self::Format(FormatError::HeaderEnds),
            _ => Self::Read(error),
        }
    }
}

/// Reads the header of a file of `length` bytes.
pub(crate) fn placement(source: &mut impl Read, length: u64) -> Result<Placement, NpyError> {
    if length == 0 {
        return Err(FormatError::Empty.into());
    }
    let mut magic = Vec::new();
    source.by_ref().take(MAGIC.len() as u64).read_to_end(&mut magic)?;
    if magic != MAGIC {
        return Err(FormatError::NotNpy.into());
    }
    let mut version = [0; 2];
    source.read_exact(&mut version)?;
    let (start, size) = match version {
        [1, 0] => {
            let mut size = [0; 2];
            source.read_exact(&mut size)?;
            (10, u64::from(u16::from_le_bytes(size)))
        }
        [2 | 3, 0] => {
            let mut size = [0; 4];
            source.read_exact(&mut size)?;
            (12, u64::from(u32::from_le_bytes(size)))
        }
        [major, minor] => return Err(FormatError::Version { major, minor }.into()),
    };
    if size > LONGEST_HEADER {
        return Err(FormatError::LongHeader { found: size, limit: LONGEST_HEADER }.into());
    }
    let mut text = Vec::new();
    source.by_ref().take(size).read_to_end(&mut text)?;
    if (text.len() as u64) < size {
        return Err(FormatError::HeaderEnds.into());
    }
    let text =
        String::from_utf8(text).map_err(|_| FormatError::BadHeader { what: "it is not text" })?;
    let header = Header::parse(&text)?;
    let number = number(&header.descr)?;
    let shape =
        <[u64; 2]>::try_from(header.shape).map_err(|found| FormatError::Dimensions { found })?;
    Ok(Placement::new(start + size, shape, header.order, number, length)?)
}

fn number(descr: &str) -> Result<Number, FormatError> {
    let (width, ends) = match descr {
        "<f8" => (Width::Eight, Ends::Little),
        ">f8" => (Width::Eight, Ends::Big),
        "<f4" => (Width::Four, Ends::Little),
        ">f4" => (Width::Four, Ends::Big),
        _ => return Err(FormatError::Numbers { descr: descr.chars().take(20).collect() }),
    };
    Ok(Number { width, ends })
}

impl Order {
    fn of(fortran_order: bool) -> Self {
        if fortran_order { Self::ChannelByChannel } else { Self::SampleBySample }
    }
}

#[cfg(test)]
mod tests;
