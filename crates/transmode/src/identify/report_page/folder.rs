//! The folder of a report: written beside its place, then renamed.

use std::fs::{self, DirEntry};
use std::io::{Error, ErrorKind, Read};
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::contents::{FIGURES, FIGURES_WITH_INPUTS, PAGE, PROGRAM};
use crate::CommandError;

/// The page's mark is within so many bytes of its start.
const MARK_WITHIN: u64 = 4096;

/// Refuses a place where a report cannot go, before any work is done.
///
/// A folder that exists has to be empty or hold nothing but an older report, which is replaced as a whole: a page that carries our mark, and files under the
/// names of its figures.
///
/// # Errors
///
/// [`CommandError::NotAReport`] with the first thing in the folder that no report has; [`CommandError::Write`] where the place is a file or its own
/// folder does not exist.
pub(in crate::identify) fn check_place(folder: &Path) -> Result<(), CommandError> {
    let fault = |source| CommandError::Write { file: folder.to_owned(), source };
    if folder == Path::new("-") {
        return Err(fault(Error::new(ErrorKind::InvalidInput, "a report is a folder of files")));
    }
    match fs::read_dir(folder) {
        Ok(entries) => {
            let entries = entries.collect::<Result<Vec<_>, _>>().map_err(fault)?;
            let has_page = entries.iter().any(is_our_page);
            let is_ours = |entry: &DirEntry| is_our_page(entry) || has_page && is_figure(entry);
            let strangers = entries.iter().filter(|entry| !is_ours(entry));
            match strangers.map(DirEntry::file_name).min() {
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

/// Whether it is a page that this program wrote.
fn is_our_page(entry: &DirEntry) -> bool {
    let marked = || {
        let mut start = Vec::new();
        let read = fs::File::open(entry.path())?.take(MARK_WITHIN).read_to_end(&mut start);
        read.map(|_| String::from_utf8_lossy(&start).contains(&mark()))
    };
    is_file(entry) && entry.file_name() == PAGE && marked().unwrap_or(false)
}

/// The page's mark up to the version, since an older report may be replaced.
fn mark() -> String {
    format!("<meta name=\"generator\" content=\"{PROGRAM} ")
}

/// Whether it is called like one of the figures.
fn is_figure(entry: &DirEntry) -> bool {
    let name = entry.file_name();
    let id = name
        .to_str()
        .and_then(|name| name.strip_suffix(".svg").or_else(|| name.strip_suffix(".png")));
    let is_ours = |id: &str| FIGURES.contains(&id) || FIGURES_WITH_INPUTS.contains(&id);
    is_file(entry) && id.is_some_and(is_ours)
}

/// A regular file; a link is none.
fn is_file(entry: &DirEntry) -> bool {
    entry.file_type().is_ok_and(|kind| kind.is_file())
}

/// Writes all files into a new folder and puts it in the place of `folder`, which [`check_place`] must allow: all of it or nothing.
///
/// # Errors
///
/// Those of [`check_place`], and [`CommandError::Write`].
pub(in crate::identify) fn replace(
    folder: &Path,
    files: &[(String, Vec<u8>)],
) -> Result<(), CommandError> {
    check_place(folder)?;
    let fault = |source| CommandError::Write { file: folder.to_owned(), source };
    // A link stays, and so does the name that the operating system knows the folder by.
    let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    if place.file_name().is_none() {
        return Err(fault(Error::new(ErrorKind::InvalidInput, "it has no name")));
    }
    let drafts = tempfile::Builder::new()
        .prefix(".transmode-")
        .tempdir_in(parent(&place))
        // Without the draft's name, which would tell the user nothing.
        .map_err(|error| fault(error.kind().into()))?;
    let new = drafts.path().join(NEW);
    // Made by hand: a temporary folder is closed to others, a report is as open as the user's mask allows.
    fs::create_dir(&new).map_err(fault)?;
    for (name, bytes) in files {
        // What the user knows is the file's place, not that of its draft.
        let fault = |source| CommandError::Write { file: place.join(name), source };
        fs::write(new.join(name), bytes).map_err(fault)?;
    }
    exchange(drafts, &place, |from, to| fs::rename(from, to))
}

/// The new report and the old one among the drafts.
const NEW: &str = "new";
const OLD: &str = "old";

/// Puts the new report in its place; an old one goes with the drafts, unless it can neither be replaced nor put back.
pub(super) fn exchange(
    drafts: TempDir,
    place: &Path,
    rename: impl Fn(&Path, &Path) -> Result<(), Error>,
) -> Result<(), CommandError> {
    let fault = |source| CommandError::Write { file: place.to_owned(), source };
    let (new, old) = (drafts.path().join(NEW), drafts.path().join(OLD));
    let had_one = place.exists();
    if had_one {
        rename(place, &old).map_err(fault)?;
    }
    let Err(error) = rename(&new, place) else { return Ok(()) };
    if had_one && let Err(source) = rename(&old, place) {
        let _ = drafts.keep();
        return Err(CommandError::NotRestored { file: place.to_owned(), kept: old, source });
    }
    Err(fault(error))
}

fn parent(folder: &Path) -> PathBuf {
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new(".")).to_owned()
}
