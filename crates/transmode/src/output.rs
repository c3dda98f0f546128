//! Whole files or none: a file is written beside its place and then renamed.

mod folder;
mod interrupt;

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use crate::CommandError;

pub(crate) use folder::{Overwrite, check_folder, write_folder};
pub use interrupt::end_between_files;
pub(crate) use interrupt::uninterrupted;

/// Writes a result: as JSON to a file or to `out`, where it is asked for, and as text to `out` unless the JSON went there.
///
/// The file comes first: if it cannot be written, nothing has been said yet.
///
/// # Errors
///
/// [`CommandError::Write`], and those of `as_json`.
pub(crate) fn write_result(
    json: Option<&Path>,
    as_json: impl FnOnce() -> Result<Vec<u8>, CommandError>,
    as_text: impl FnOnce() -> String,
    out: &mut dyn Write,
) -> Result<(), CommandError> {
    let standard_output = Path::new("-");
    if let Some(file) = json {
        write_whole(file, &as_json()?, out)?;
    }
    if json != Some(standard_output) {
        write_whole(standard_output, as_text().as_bytes(), out)?;
    }
    Ok(())
}

/// Writes `bytes` to `file`, or to `out` where the file is called `-`.
///
/// A regular file appears whole or stays as it was, also where a person interrupts the program. Anything else that stands in its place (a pipe, a device) is
/// written to as it is.
///
/// # Errors
///
/// [`CommandError::Write`] with the file and what the operating system says.
pub fn write_whole(file: &Path, bytes: &[u8], out: &mut dyn Write) -> Result<(), CommandError> {
    write_with(file, bytes, out, || Ok(()))
}

/// Writes `bytes` as [`write_whole`] does, and in the same go what `rest` writes: if one of them cannot be written, neither is.
///
/// # Errors
///
/// [`CommandError::Write`], and those of `rest`.
pub(crate) fn write_with(
    file: &Path,
    bytes: &[u8],
    out: &mut dyn Write,
    rest: impl FnOnce() -> Result<(), CommandError>,
) -> Result<(), CommandError> {
    let fault = |source| CommandError::Write { file: file.to_owned(), source };
    if file == Path::new("-") {
        uninterrupted(rest)?;
        return out.write_all(bytes).and_then(|()| out.flush()).map_err(fault);
    }
    refuse_folder(file)?;
    let is_special = file.metadata().is_ok_and(|metadata| !metadata.is_file());
    if is_special {
        std::fs::write(file, bytes).map_err(fault)?;
        return uninterrupted(rest);
    }
    uninterrupted(|| {
        let draft = draft_of(file, bytes).map_err(fault)?;
        rest()?;
        draft.persist(file).map_err(|error| fault(error.error))?;
        Ok(())
    })
}

/// All of a regular file, beside its place.
fn draft_of(file: &Path, bytes: &[u8]) -> std::io::Result<NamedTempFile> {
    let folder =
        file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut draft = draft_in(folder)?;
    draft.as_file_mut().write_all(bytes)?;
    draft.as_file().sync_all()?;
    Ok(draft)
}

/// Refuses to replace one of the records by a result, however the two paths are written, before any work is done.
///
/// # Errors
///
/// [`CommandError::OverwritesRecord`]; [`CommandError::Write`] if the folder of the result does not exist, or a folder stands in its place.
pub(crate) fn check_place(file: &Path, records: &[&Path]) -> Result<(), CommandError> {
    if file == Path::new("-") {
        return Ok(());
    }
    refuse_folder(file)?;
    let folder =
        file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    folder.metadata().map_err(|source| CommandError::Write { file: file.to_owned(), source })?;
    let Ok(place) = file.canonicalize() else { return Ok(()) };
    let same = |record: &&&Path| record.canonicalize().is_ok_and(|record| record == place);
    match records.iter().find(same) {
        Some(_) => Err(CommandError::OverwritesRecord { file: file.to_owned() }),
        None => Ok(()),
    }
}

/// Whether a file is that folder or will lie in it, however the two paths are written.
pub(crate) fn is_within(file: &Path, folder: &Path) -> bool {
    let whole = |path: &Path| {
        // What is not there yet has a folder that is.
        let known = path.ancestors().find_map(|known| Some((known, known.canonicalize().ok()?)));
        let rest =
            known.and_then(|(known, place)| Some(place.join(path.strip_prefix(known).ok()?)));
        rest.or_else(|| std::path::absolute(path).ok()).unwrap_or_else(|| path.to_owned())
    };
    file != Path::new("-")
        && whole(&Path::new(".").join(file)).starts_with(whole(&Path::new(".").join(folder)))
}

fn refuse_folder(place: &Path) -> Result<(), CommandError> {
    if place.is_dir() {
        let source = ErrorKind::IsADirectory.into();
        return Err(CommandError::Write { file: place.to_owned(), source });
    }
    Ok(())
}

/// A temporary file with the rights of an ordinary one, which the user's mask may narrow.
///
/// It is opened here so that an error is the operating system's own: the draft's name would tell the user nothing.
fn draft_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let open = |draft: &Path| OpenOptions::new().write(true).create_new(true).open(draft);
    tempfile::Builder::new().prefix(".transmode-").make_in(folder, open)
}

#[cfg(test)]
mod tests;
