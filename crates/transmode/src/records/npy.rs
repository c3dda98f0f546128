//! NPY files, as `numpy.save` writes them: a short header, then the numbers of one array.
//!
//! The header is read here, in a few lines, because what is needed is three entries of one form. The crate for it, npyz 0.9.1, brings
//! fourteen more with a parser generator and assembly to build, and a header whose sizes overflow makes it panic.
//!
//! Format: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", and `numpy.lib.format`, versions 1.0 to 3.0.

mod header;

use std::io::{ErrorKind, Read, Seek};
use std::path::Path;

use super::binary::{Ends, Number, Order, Placement, Width};
use super::format::Format;
use super::format_error::FormatError;
use super::progress::Bar;
use super::table::{Choose, Heading, Places, Table};
use crate::CommandError;
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

impl NpyError {
    pub(crate) fn of_file(self, file: &Path) -> CommandError {
        match self {
            Self::Read(source) => CommandError::Read { file: file.to_owned(), source },
            Self::Format(error) => super::in_file(file, &error),
        }
    }
}

/// Reads the chosen channels of an array of samples x channels, which are called by their index, or of a single channel.
pub(crate) fn read(
    file: &Path,
    mut source: impl Read + Seek,
    length: u64,
    choose: &mut Choose<'_>,
    bar: &Bar,
) -> Result<Table, CommandError> {
    let placement = any_placement(&mut source, length).map_err(|error| error.of_file(file))?;
    let samples = usize::try_from(placement.samples()).ok();
    let heading = |index: u64| Heading { samples, ..Heading::named(index.to_string()) };
    let headings: Vec<Heading> = (0..placement.channels()).map(heading).collect();
    let chosen = choose(Format::Npy, &headings)?.channels;
    let fault = |source| CommandError::Read { file: file.to_owned(), source };
    let values = placement.read(&mut source, &chosen, |bytes| bar.advance(bytes)).map_err(fault)?;
    let table = Table { format: Format::Npy, headings, chosen, values, places: Places::Samples };
    super::finite(file, table)
}

/// Reads the header of a file of `length` bytes that holds an array of samples x channels.
pub(crate) fn placement(source: &mut impl Read, length: u64) -> Result<Placement, NpyError> {
    header(source, length)?.placement()
}

/// The same, and an array of one dimension is one channel.
pub(super) fn any_placement(source: &mut impl Read, length: u64) -> Result<Placement, NpyError> {
    let mut array = header(source, length)?;
    if array.shape.len() == 1 {
        array.shape.push(1);
    }
    array.placement()
}

/// What a header says.
struct Array {
    offset: u64,
    shape: Vec<u64>,
    order: Order,
    number: Number,
    /// Bytes of the whole file.
    length: u64,
}

impl Array {
    fn placement(self) -> Result<Placement, NpyError> {
        let shape =
            <[u64; 2]>::try_from(self.shape).map_err(|found| FormatError::Dimensions { found })?;
        Ok(Placement::new(self.offset, shape, self.order, self.number, self.length)?)
    }
}

/// Reads the header of a file of `length` bytes.
fn header(source: &mut impl Read, length: u64) -> Result<Array, NpyError> {
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
    Ok(Array { offset: start + size, shape: header.shape, order: header.order, number, length })
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
