//! Opens a file, sees what it is, and has the reader for that read what channels it has.

use std::fs::File;
use std::io::{BufReader, Cursor, Error, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::format::{Format, START};
use super::format_error::FormatError;
use super::options::ReadOptions;
use super::progress::{Bar, Progress};
use super::table::Opened;
use super::{hdf5, mat, npy, npz, text, zstd};
use crate::CommandError;
use crate::error::in_file;

/// Opens a file of any format as far as its headings.
pub(crate) fn open(
    file: &Path,
    options: &ReadOptions,
    progress: Progress,
) -> Result<Box<dyn Opened>, CommandError> {
    let fault = |source| CommandError::Read { file: file.to_owned(), source };
    let metadata = file.metadata().map_err(fault)?;
    if metadata.is_dir() {
        return Err(fault(Error::from(ErrorKind::IsADirectory)));
    }
    let mut source = File::open(file).map_err(fault)?;
    let mut start = Vec::new();
    source.by_ref().take(START as u64).read_to_end(&mut start).map_err(fault)?;
    let format = Format::of(&start, file).map_err(|error| in_file(file, &error))?;
    let bar = progress.bytes(file, metadata.len());
    if !format.is_text() {
        if !metadata.is_file() {
            return Err(in_file(file, &FormatError::NotRegular));
        }
        source.seek(SeekFrom::Start(0)).map_err(fault)?;
    }
    let variable = options.variable.as_deref();
    // A text may be a pipe, which cannot go back to its start.
    let text = |source, bar| Watched { source: Cursor::new(start).chain(source), bar };
    match format {
        Format::Text => boxed(text::open(file, format, text(source, bar), options)),
        Format::GzippedText => {
            let source = MultiGzDecoder::new(BufReader::new(text(source, bar)));
            boxed(text::open(file, format, source, options))
        }
        Format::Npy => boxed(npy::open(file, source, metadata.len(), bar)),
        Format::Npz => boxed(npz::open(file, source)),
        Format::ZstdText => {
            let source = zstd::Frames::new(BufReader::new(text(source, bar)));
            boxed(text::open(file, format, source, options))
        }
        Format::Mat => boxed(mat::open(file, BufReader::new(source), metadata.len(), variable)),
        Format::Mat73 | Format::Hdf5 => boxed(hdf5::open(file, format, metadata.len(), variable)),
        #[cfg(feature = "parquet")]
        Format::Parquet => boxed(super::parquet::open(file, source, bar)),
        #[cfg(not(feature = "parquet"))]
        Format::Parquet => Err(in_file(file, &FormatError::NoParquet)),
    }
}

fn boxed(
    opened: Result<impl Opened + 'static, CommandError>,
) -> Result<Box<dyn Opened>, CommandError> {
    opened.map(|opened| Box::new(opened) as Box<dyn Opened>)
}

/// A source whose reading a person may watch.
struct Watched<R> {
    source: R,
    bar: Bar,
}

impl<R: Read> Read for Watched<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let length = self.source.read(buffer)?;
        self.bar.advance(length as u64);
        Ok(length)
    }
}
