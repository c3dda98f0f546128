//! Whole files or none: a file is written beside its place and then renamed.

mod folder;

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use crate::CommandError;
pub(crate) use folder::{Overwrite, check_folder, write_folder};

/// Writes `bytes` to `file`, or to `out` where the file is called `-`.
///
/// A regular file appears whole or stays as it was. Anything else that stands in its place (a pipe, a device) is written to as it is.
///
/// # Errors
///
/// [`CommandError::Write`] with the file and what the operating system says.
pub fn write_whole(file: &Path, bytes: &[u8], out: &mut dyn Write) -> Result<(), CommandError> {
    let fault = |source| CommandError::Write { file: file.to_owned(), source };
    if file == Path::new("-") {
        return out.write_all(bytes).and_then(|()| out.flush()).map_err(fault);
    }
    let is_special =
        file.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir());
    if is_special {
        return std::fs::write(file, bytes).map_err(fault);
    }
    let folder =
        file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut draft = draft_in(folder).map_err(fault)?;
    draft.as_file_mut().write_all(bytes).map_err(fault)?;
    draft.as_file().sync_all().map_err(fault)?;
    draft.persist(file).map_err(|error| fault(error.error))?;
    Ok(())
}

/// Refuses to replace one of the records by a result, however the two paths are written, before any work is done.
///
/// # Errors
///
/// [`CommandError::OverwritesRecord`]; [`CommandError::Write`] if the folder of the result does not exist.
pub(crate) fn check_place(file: &Path, records: &[&Path]) -> Result<(), CommandError> {
    if file == Path::new("-") {
        return Ok(());
    }
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

/// A temporary file with the rights of an ordinary one, which the user's mask may narrow.
///
/// It is opened here so that an error is the operating system's own: the draft's name would tell the user nothing.
fn draft_in(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let open = |draft: &Path| OpenOptions::new().write(true).create_new(true).open(draft);
    tempfile::Builder::new().prefix(".transmode-").make_in(folder, open)
}

#[cfg(test)]
mod tests;
