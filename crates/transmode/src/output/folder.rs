//! Several files in a folder: all of them, or none.

use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempDir};

use super::draft::draft_in;
use super::interrupt::uninterrupted;
use super::place::refuse_folder;
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
/// [`CommandError::Exists`] where a file is there and may not be replaced; [`CommandError::Write`] where the folder is none, or a folder stands in a
/// file's place.
pub(crate) fn check_folder(
    folder: &Path,
    names: &[String],
    overwrite: Overwrite,
) -> Result<(), CommandError> {
    if folder.exists() && !folder.is_dir() {
        let source = ErrorKind::NotADirectory.into();
        return Err(CommandError::Write { file: folder.to_owned(), source });
    }
    for name in names {
        let file = folder.join(name);
        refuse_folder(&file)?;
        if overwrite == Overwrite::Refused && file.symlink_metadata().is_ok() {
            return Err(CommandError::Exists { file });
        }
    }
    Ok(())
}

/// Writes all files beside their places, then puts them there.
///
/// After a fault the folder is as it was: what was put there is taken away again, and what it replaced comes back. The folder is made if it is not there; the
/// one above must be.
///
/// # Errors
///
/// [`CommandError::Exists`], [`CommandError::Write`]; [`CommandError::NotRestored`] where a file that was there cannot be put back.
pub(crate) fn write_folder(
    folder: &Path,
    files: &[(String, Vec<u8>)],
    overwrite: Overwrite,
) -> Result<(), CommandError> {
    uninterrupted(|| write_all(folder, files, overwrite))
}

fn write_all(
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
    let written = prepare(folder, files).and_then(|prepared| {
        let result = prepared.drafts.into_iter().enumerate().try_for_each(|(index, draft)| {
            place(draft, &prepared.old.path().join(index.to_string()), overwrite, &mut placed)
        });
        match result {
            Ok(()) => Ok(()),
            Err(error) => Err(undo(&placed, prepared.old, error)),
        }
    });
    if written.is_err() && is_new {
        let _ = std::fs::remove_dir(folder);
    }
    written
}

/// All files beside their places, and a folder for those that they replace.
struct Prepared {
    drafts: Vec<Draft>,
    old: TempDir,
}

struct Draft {
    file: PathBuf,
    text: NamedTempFile,
}

/// A file that may be in its place, and where the one before it was moved, if there was one.
struct Placed {
    file: PathBuf,
    before: Option<PathBuf>,
    is_written: bool,
}

fn prepare(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<Prepared, CommandError> {
    let mut drafts = Vec::new();
    for (name, bytes) in files {
        let file = folder.join(name);
        let fault = |source| CommandError::Write { file: file.clone(), source };
        let text = draft_in(folder, bytes).map_err(fault)?;
        drafts.push(Draft { file, text });
    }
    let old = tempfile::Builder::new()
        .prefix(".transmode-")
        .tempdir_in(folder)
        .map_err(|source| CommandError::Write { file: folder.to_owned(), source })?;
    Ok(Prepared { drafts, old })
}

/// Moves what is in the draft's place to `aside`, where that is allowed, and puts the draft there.
fn place(
    draft: Draft,
    aside: &Path,
    overwrite: Overwrite,
    placed: &mut Vec<Placed>,
) -> Result<(), CommandError> {
    let Draft { file, text } = draft;
    let fault = |source: Error| match source.kind() {
        ErrorKind::AlreadyExists => CommandError::Exists { file: file.clone() },
        _ => CommandError::Write { file: file.clone(), source },
    };
    let before = match file.symlink_metadata() {
        Ok(metadata) if overwrite == Overwrite::Refused || metadata.is_dir() => {
            return Err(CommandError::Exists { file });
        }
        Ok(_) => {
            std::fs::rename(&file, aside).map_err(fault)?;
            Some(aside.to_owned())
        }
        Err(_) => None,
    };
    placed.push(Placed { file: file.clone(), before, is_written: false });
    text.persist_noclobber(&file).map_err(|error| fault(error.error))?;
    if let Some(last) = placed.last_mut() {
        last.is_written = true;
    }
    Ok(())
}

/// Takes away what was put in place and brings back what was there; the error is `error`, unless a file stays where it was moved.
fn undo(placed: &[Placed], old: TempDir, error: CommandError) -> CommandError {
    let mut lost = None;
    for Placed { file, before, is_written } in placed.iter().rev() {
        let result = match before {
            Some(before) => std::fs::rename(before, file),
            None if *is_written => std::fs::remove_file(file),
            None => Ok(()),
        };
        if let (Err(source), Some(before)) = (result, before) {
            lost = Some((file.clone(), before.clone(), source));
        }
    }
    match lost {
        Some((file, kept, source)) => {
            let _ = old.keep();
            CommandError::NotRestored { file, kept, source }
        }
        None => error,
    }
}

#[cfg(test)]
mod tests;
