//! Several files in a folder: all of them, or none.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::draft_in;
use crate::CommandError;

/// What happens to files that are there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Overwrite {
    Refused,
    Allowed,
}

/// Refuses, before any work is done, a folder that cannot take the files.
///
/// # Errors
///
/// [`CommandError::Exists`] where a file is there and may not be replaced; [`CommandError::Write`] where the folder is no folder.
pub(crate) fn check_folder(
    folder: &Path,
    names: &[String],
    overwrite: Overwrite,
) -> Result<(), CommandError> {
    if folder.exists() && !folder.is_dir() {
        let source = std::io::ErrorKind::NotADirectory.into();
        return Err(CommandError::Write { file: folder.to_owned(), source });
    }
    for name in names {
        let file = folder.join(name);
        let is_there = file.symlink_metadata().is_ok();
        if is_there && (overwrite == Overwrite::Refused || file.is_dir()) {
            return Err(CommandError::Exists { file });
        }
    }
    Ok(())
}

/// Writes all files beside their places, then puts them there; what was put there before a fault is taken away again.
///
/// The folder is made if it is not there; the one above must be.
///
/// # Errors
///
/// [`CommandError::Exists`], [`CommandError::Write`].
pub(crate) fn write_folder(
    folder: &Path,
    files: &[(String, Vec<u8>)],
    overwrite: Overwrite,
) -> Result<(), CommandError> {
    let is_new = match std::fs::create_dir(folder) {
        Ok(()) => true,
        Err(_) if folder.is_dir() => false,
        Err(source) => return Err(CommandError::Write { file: folder.to_owned(), source }),
    };
    let mut placed = Vec::new();
    let written = place(folder, files, overwrite, &mut placed);
    if written.is_err() {
        for file in placed {
            let _ = std::fs::remove_file(file);
        }
        if is_new {
            let _ = std::fs::remove_dir(folder);
        }
    }
    written
}

/// Keeps in `placed` the files that were not there before.
fn place(
    folder: &Path,
    files: &[(String, Vec<u8>)],
    overwrite: Overwrite,
    placed: &mut Vec<PathBuf>,
) -> Result<(), CommandError> {
    let mut drafts = Vec::new();
    for (name, bytes) in files {
        let file = folder.join(name);
        let fault = |source| CommandError::Write { file: file.clone(), source };
        let mut draft = draft_in(folder).map_err(fault)?;
        draft.as_file_mut().write_all(bytes).map_err(fault)?;
        draft.as_file().sync_all().map_err(fault)?;
        drafts.push((file, draft));
    }
    for (file, draft) in drafts {
        let was_there = file.exists();
        let result = match overwrite {
            Overwrite::Allowed => draft.persist(&file),
            Overwrite::Refused => draft.persist_noclobber(&file),
        };
        result.map_err(|error| match error.error.kind() {
            std::io::ErrorKind::AlreadyExists => CommandError::Exists { file: file.clone() },
            _ => CommandError::Write { file: file.clone(), source: error.error },
        })?;
        if !was_there {
            placed.push(file);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
