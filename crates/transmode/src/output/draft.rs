//! A file beside its place, which is renamed once it is whole.

use std::fs::OpenOptions;
use std::io::{Result, Write};
use std::path::Path;

use tempfile::NamedTempFile;

/// All of a regular file, beside its place.
pub(super) fn draft_of(file: &Path, bytes: &[u8]) -> Result<NamedTempFile> {
    let folder =
        file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    draft_in(folder, bytes)
}

/// The same in a folder; a file with the rights of an ordinary one, which the user's mask may
/// narrow.
///
/// It is opened here so that an error is the operating system's own: the draft's name would tell
/// the user nothing.
pub(super) fn draft_in(folder: &Path, bytes: &[u8]) -> Result<NamedTempFile> {
    let open = |draft: &Path| OpenOptions::new().write(true).create_new(true).open(draft);
    let mut draft = tempfile::Builder::new().prefix(".transmode-").make_in(folder, open)?;
    draft.as_file_mut().write_all(bytes)?;
    draft.as_file().sync_all()?;
    Ok(draft)
}
