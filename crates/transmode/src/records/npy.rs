//! NPY files, as `numpy.save` writes them: a short header, then the numbers of one array.
//!
//! The header is read here, in a few lines, because what is needed is three entries of one form. The crate for it, npyz 0.9.1, brings
//! fourteen more with a parser generator and assembly to build, and a header whose sizes overflow makes it panic.
//!
//! Format: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", and `numpy.lib.format`, versions 1.0 to 3.0.

mod fields;
mod header;

use std::io::{ErrorKind, Read, Seek};
use std::path::{Path, PathBuf};

use super::binary::{ByteOrder, Layout, Number, Placement, Width};
use super::format::{Format, NPY_MAGIC};
use super::format_error::FormatError;
use super::progress::Bar;
use super::segments::SHORTEST;
use super::table::{Chosen, Heading, Opened, Table};
use crate::CommandError;
use crate::error::in_file;
use fields::Fields;
use header::{Descr, Header};

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
            Self::Format(error) => in_file(file, &error),
        }
    }
}

/// An array whose header has been read.
pub(crate) struct OpenedNpy<R> {
    file: PathBuf,
    source: R,
    content: Content,
    headings: Vec<Heading>,
    bar: Bar,
}

/// Where the numbers of an array lie.
#[derive(Clone, Debug)]
pub(super) enum Content {
    /// Floats of samples x channels, or the other way round.
    Floats(Placement),
    /// The fields of structures, one a sample; or whole numbers.
    Fields(Fields),
}

impl Content {
    pub(super) fn samples(&self) -> u64 {
        match self {
            Self::Floats(placement) => placement.samples(),
            Self::Fields(fields) => fields.samples(),
        }
    }

    /// What the file calls its channels: `None` for those without names.
    pub(super) fn names(&self) -> Vec<Option<String>> {
        match self {
            Self::Floats(placement) => (0..placement.channels()).map(|_| None).collect(),
            Self::Fields(fields) => fields.names(),
        }
    }

    pub(super) fn read(
        &self,
        source: &mut (impl Read + Seek),
        wanted: &[usize],
        progress: impl FnMut(u64),
    ) -> std::io::Result<Vec<Vec<f64>>> {
        match self {
            Self::Floats(placement) => placement.read(source, wanted, progress),
            Self::Fields(fields) => fields.read(source, wanted, progress),
        }
    }
}

/// Opens an array of samples x channels, which are called by their index, or of a single channel. The fields of
/// a structured array are channels by their names.
pub(crate) fn open<R: Read + Seek>(
    file: &Path,
    mut source: R,
    length: u64,
    bar: Bar,
) -> Result<OpenedNpy<R>, CommandError> {
    let content = content(&mut source, length).map_err(|error| error.of_file(file))?;
    let samples = usize::try_from(content.samples()).ok();
    let heading = |(index, name): (usize, Option<String>)| match name {
        Some(name) => Heading { samples, ..super::text::heading(&name) },
        None => Heading { samples, ..Heading::named(index.to_string()) },
    };
    let headings = content.names().into_iter().enumerate().map(heading).collect();
    Ok(OpenedNpy { file: file.to_owned(), source, content, headings, bar })
}

impl<R: Read + Seek> Opened for OpenedNpy<R> {
    fn format(&self) -> Format {
        Format::Npy
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let Self { file, mut source, content, headings, bar } = *self;
        let chosen = chosen.channels;
        let values = content
            .read(&mut source, &chosen, |bytes| bar.advance(bytes))
            .map_err(|source| CommandError::Read { file: file.clone(), source })?;
        Table::of_arrays(Format::Npy, headings, chosen, values).finite(&file)
    }
}

/// Reads the header of a file of `length` bytes that holds an array of samples x channels.
pub(crate) fn placement(source: &mut impl Read, length: u64) -> Result<Placement, NpyError> {
    header(source, length)?.placement()
}

/// Where the channels of any array are that holds some: one of one dimension is one channel, one that is much wider than high is
/// channels x samples, and structures have a channel for each field.
pub(super) fn content(source: &mut impl Read, length: u64) -> Result<Content, NpyError> {
    let mut array = header(source, length)?;
    if array.shape.len() == 1 {
        array.shape.push(1);
    }
    let is_float = matches!(&array.descr, Descr::Number(descr) if number(descr).is_ok());
    if !is_float {
        return Ok(Content::Fields(Fields::new(&array)?));
    }
    if let [rows, columns] = array.shape[..]
        && columns > rows
        && columns >= SHORTEST as u64
    {
        array.shape.reverse();
        array.layout = match array.layout {
            Layout::SampleBySample => Layout::ChannelByChannel,
            Layout::ChannelByChannel => Layout::SampleBySample,
        };
    }
    Ok(Content::Floats(array.placement()?))
}

/// What a header says.
struct Array {
    offset: u64,
    shape: Vec<u64>,
    layout: Layout,
    descr: Descr,
    /// Bytes of the whole file.
    length: u64,
}

impl Array {
    fn placement(self) -> Result<Placement, NpyError> {
        let number = match &self.descr {
            Descr::Number(descr) => number(descr)?,
            Descr::Structure(_) => return Err(FormatError::Structured.into()),
        };
        let shape =
            <[u64; 2]>::try_from(self.shape).map_err(|found| FormatError::Dimensions { found })?;
        Ok(Placement::new(self.offset, shape, self.layout, number, self.length)?)
    }
}

/// Reads the header of a file of `length` bytes.
fn header(source: &mut impl Read, length: u64) -> Result<Array, NpyError> {
    if length == 0 {
        return Err(FormatError::Empty.into());
    }
    let mut magic = Vec::new();
    source.by_ref().take(NPY_MAGIC.len() as u64).read_to_end(&mut magic)?;
    if magic != NPY_MAGIC {
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
    let Header { descr, layout, shape } = header;
    // What is no number is refused first, whatever its shape.
    if let Descr::Number(descr) = &descr
        && fields::Kind::parse(descr).is_none()
    {
        return Err(number(descr).err().unwrap_or(FormatError::Structured).into());
    }
    Ok(Array { offset: start + size, shape, layout, descr, length })
}

fn number(descr: &str) -> Result<Number, FormatError> {
    let (width, byte_order) = match descr {
        "<f8" => (Width::Eight, ByteOrder::Little),
        ">f8" => (Width::Eight, ByteOrder::Big),
        "<f4" => (Width::Four, ByteOrder::Little),
        ">f4" => (Width::Four, ByteOrder::Big),
        _ => return Err(FormatError::Numbers { descr: descr.chars().take(20).collect() }),
    };
    Ok(Number { width, byte_order })
}

#[cfg(test)]
mod tests;
