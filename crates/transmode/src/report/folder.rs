//! The folder of a report: written beside its place, then renamed.

use std::fs;
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

use super::{FIGURES, PAGE};
use crate::CommandError;

/// Refuses a place where a report cannot go, before any work is done.
///
/// A folder that exists has to be empty or hold nothing but an older report, which is replaced as a whole.
///
/// # Errors
///
/// [`CommandError::NotAReport`] with the first thing in the folder that no report has; [`CommandError::Write`] where the place is a file or its own
/// folder does not exist.
pub(crate) fn check_place(folder: &Path) -> Result<(), CommandError> {
    let fault = |source| CommandError::Write { file: folder.to_owned(), source };
    match fs::read_dir(folder) {
        Ok(entries) => {
            let mut strangers = Vec::new();
            for entry in entries {
                let name = entry.map_err(fault)?.file_name();
                if !name.to_str().is_some_and(is_ours) {
                    strangers.push(name);
                }
            }
            strangers.sort();
            match strangers.into_iter().next() {
                Some(entry) => {
                    Err(CommandError::NotAReport { folder: folder.to_owned(), entry: entry.into() })
                }
                None => Ok(()),
            }
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            parent(folder).metadata().map(|_| ()).map_err(fault)
        }
        Err(error) => Err(fault(error)),
    }
}

fn is_ours(name: &str) -> bool {
    let figure = name.strip_suffix(".svg").or_else(|| name.strip_suffix(".png"));
    name == PAGE || figure.is_some_and(|id| FIGURES.contains(&id))
}

/// Writes all files into a new folder and puts it in the place of `folder`.
pub(super) fn replace(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), CommandError> {
    check_place(folder)?;
    let fault = |source| CommandError::Write { file: folder.to_owned(), source };
    // A link stays, and so does the name that the operating system knows the folder by.
    let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    if place.file_name().is_none() {
        return Err(fault(Error::new(ErrorKind::InvalidInput, "it has no name")));
    }
    let drafts =
        tempfile::Builder::new().prefix(".transmode-").tempdir_in(parent(&place)).map_err(fault)?;
    let (new, old) = (drafts.path().join("new"), drafts.path().join("old"));
    // Made by hand: a temporary folder is closed to others, a report is as open as the user's mask allows.
    fs::create_dir(&new).map_err(fault)?;
    for (name, bytes) in files {
        crate::output::write_whole(&new.join(name), bytes, &mut std::io::sink())
            .map_err(|error| in_place(error, &place, name))?;
    }
    if place.exists() {
        fs::rename(&place, &old).map_err(fault)?;
        if let Err(error) = fs::rename(&new, &place) {
            // Nothing more can be done where the way back fails, too; the first error says what is wrong.
            let _ = fs::rename(&old, &place);
            return Err(fault(error));
        }
        return Ok(());
    }
    fs::rename(&new, &place).map_err(fault)
}

/// An error about a draft, with the name that the user knows.
fn in_place(error: CommandError, place: &Path, name: &str) -> CommandError {
    match error {
        CommandError::Write { source, .. } => {
            CommandError::Write { file: place.join(name), source }
        }
        other => other,
    }
}

fn parent(folder: &Path) -> PathBuf {
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new(".")).to_owned()
}
