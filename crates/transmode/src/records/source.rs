//! Opens a file, sees what it is, and has the reader for that read it.

use std::fs::File;
use std::io::{BufReader, Cursor, Error, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::format::{Format, START};
use super::format_error::FormatError;
use super::progress::{Bar, Progress};
use super::table::{Choose, Table};
use super::{in_file, mat, npy, npz, text};
use crate::CommandError;

/// Reads the chosen channels of a file, whatever its format.
pub(crate) fn read(
    file: &Path,
    choose: &mut Choose<'_>,
    progress: Progress,
) -> Result<Table, CommandError> {
    let fault = |source| CommandError::Read { file: file.to_owned(), source };
    let metadata = file.metadata().map_err(fault)?;
    if metadata.is_dir() {
        return Err(fault(Error::from(ErrorKind::IsADirectory)));
    }
    let mut opened = File::open(file).map_err(fault)?;
    let mut start = Vec::new();
    opened.by_ref().take(START as u64).read_to_end(&mut start).map_err(fault)?;
    let format = Format::of(&start, file).map_err(|error| in_file(file, &error))?;
    let bar = progress.bytes(file, metadata.len());
    if matches!(format, Format::Text | Format::GzippedText) {
        // A pipe cannot go back to its start.
        let source = Watched { source: Cursor::new(start).chain(opened), bar };
        return if format == Format::Text {
            text::read(file, format, source, choose)
        } else {
            text::read(file, format, MultiGzDecoder::new(BufReader::new(source)), choose)
        };
    }
    if !metadata.is_file() {
        return Err(in_file(file, &FormatError::NotRegular));
    }
    opened.seek(SeekFrom::Start(0)).map_err(fault)?;
    match format {
        Format::Npy => npy::read(file, opened, metadata.len(), choose, &bar),
        Format::Npz => npz::read(file, opened, choose),
        Format::Mat => mat::read(file, BufReader::new(opened), metadata.len(), choose),
        #[cfg(feature = "parquet")]
        Format::Parquet => super::parquet::read(file, opened, choose, &bar),
        _ => Err(in_file(file, &FormatError::NotRegular)),
    }
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
