//! NPZ files, as `numpy.savez` writes them: a ZIP archive with an NPY file for each array.
//!
//! Arrays of one dimension are channels, called like the array; a 2-D array `x` of samples x channels has the channels `x_0`, `x_1` and so
//! on, unless it is the only array: then `0`, `1`. Arrays with a single number, and those that hold no floats, are passed over unless they are
//! asked for.

use std::io::{Cursor, Read, Seek};
use std::path::{Path, PathBuf};

use zip::ZipArchive;
use zip::result::ZipError;

use super::format::Format;
use super::format_error::FormatError;
use super::npy::{self, Content, NpyError};
use super::table::{Chosen, Heading, Opened, Table};
use crate::CommandError;
use crate::error::in_file;

/// One array of the archive.
struct Member {
    index: usize,
    name: String,
    content: Result<Content, FormatError>,
}

/// An archive whose list of arrays has been read.
pub(crate) struct OpenedNpz<R> {
    file: PathBuf,
    archive: ZipArchive<R>,
    members: Vec<Member>,
    headings: Vec<Heading>,
    /// For each channel its member and its index there.
    homes: Vec<(usize, usize)>,
}

/// Opens an archive and reads the header of each array in it.
pub(crate) fn open<R: Read + Seek>(file: &Path, source: R) -> Result<OpenedNpz<R>, CommandError> {
    let fault = |error: &FormatError| in_file(file, error);
    let mut archive = ZipArchive::new(source).map_err(|error| fault(&damaged(&error)))?;
    let members = members(&mut archive).map_err(|error| fault(&error))?;
    if members.is_empty() {
        let is_sheet = ["xl/workbook.xml", "content.xml"]
            .iter()
            .any(|name| archive.index_for_name(name).is_some());
        return Err(fault(if is_sheet {
            &FormatError::Spreadsheet
        } else {
            &FormatError::NoArrays
        }));
    }
    let (mut headings, mut homes) = (Vec::new(), Vec::new());
    for (at, member) in members.iter().enumerate() {
        match &member.content {
            Ok(content) => {
                let samples = usize::try_from(content.samples()).ok();
                let names = content.names();
                let count = names.len();
                for (channel, name) in names.into_iter().enumerate() {
                    let name = match name {
                        Some(field) if members.len() == 1 => field,
                        Some(field) => format!("{}.{field}", member.name),
                        None if count == 1 => member.name.clone(),
                        None if members.len() == 1 => channel.to_string(),
                        None => format!("{}_{channel}", member.name),
                    };
                    headings.push(Heading { samples, ..super::text::heading(&name) });
                    homes.push((at, channel));
                }
            }
            Err(error) => {
                headings.push(Heading {
                    fault: Some(error.to_string()),
                    ..super::text::heading(&member.name)
                });
                homes.push((at, 0));
            }
        }
    }
    // Beside floats, arrays of other kinds are counters and flags.
    let is_float = |at: usize| matches!(members[at].content, Ok(Content::Floats(_)));
    let is_float: Vec<bool> = homes.iter().map(|(at, _)| is_float(*at)).collect();
    Heading::prefer(&mut headings, &is_float);
    Ok(OpenedNpz { file: file.to_owned(), archive, members, headings, homes })
}

impl<R: Read + Seek> Opened for OpenedNpz<R> {
    fn format(&self) -> Format {
        Format::Npz
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let Self { file, mut archive, members, headings, homes } = *self;
        let fault = |error: &FormatError| in_file(&file, error);
        let chosen = chosen.channels;
        let mut values = vec![Vec::new(); chosen.len()];
        for (at, member) in members.iter().enumerate() {
            let wanted: Vec<_> = chosen
                .iter()
                .map(|channel| homes[*channel])
                .enumerate()
                .filter(|(_, (home, _))| *home == at)
                .collect();
            let Ok(content) = &member.content else { continue };
            if wanted.is_empty() {
                continue;
            }
            let bytes = unpacked(&mut archive, member.index).map_err(|error| fault(&error))?;
            let channels: Vec<_> = wanted.iter().map(|(_, (_, channel))| *channel).collect();
            let read = content.read(&mut Cursor::new(bytes), &channels, |_| ());
            let read =
                read.map_err(|error| fault(&FormatError::Archive { what: error.to_string() }))?;
            for ((slot, _), column) in wanted.iter().zip(read) {
                values[*slot] = column;
            }
        }
        Table::of_arrays(Format::Npz, headings, chosen, values).finite(&file)
    }
}

/// The arrays in the order of the archive.
fn members(archive: &mut ZipArchive<impl Read + Seek>) -> Result<Vec<Member>, FormatError> {
    let mut members = Vec::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(|error| damaged(&error))?;
        let name = entry.name().map(|name| name.into_owned()).map_err(|error| damaged(&error))?;
        let Some(name) = name.strip_suffix(".npy").map(str::to_owned) else { continue };
        let length = entry.size();
        let content = match npy::content(&mut entry, length) {
            Ok(content) => Ok(content),
            Err(NpyError::Format(error)) => Err(error),
            Err(NpyError::Read(error)) => {
                return Err(FormatError::Archive { what: error.to_string() });
            }
        };
        members.push(Member { index, name, content });
    }
    Ok(members)
}

/// The bytes of a member, no more than the archive says there are.
fn unpacked(
    archive: &mut ZipArchive<impl Read + Seek>,
    index: usize,
) -> Result<Vec<u8>, FormatError> {
    let entry = archive.by_index(index).map_err(|error| damaged(&error))?;
    let (mut bytes, length) = (Vec::new(), entry.size());
    let read = entry.take(length).read_to_end(&mut bytes);
    read.map_err(|error| FormatError::Archive { what: error.to_string() })?;
    Ok(bytes)
}

fn damaged(error: &ZipError) -> FormatError {
    FormatError::Archive { what: error.to_string() }
}
