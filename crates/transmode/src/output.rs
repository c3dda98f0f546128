//! Whole files or none: a file is written beside its place and then renamed.

mod draft;
mod folder;
mod interrupt;
mod place;

use std::io::Write;
use std::path::Path;

use crate::CommandError;
use draft::draft_of;
pub(crate) use folder::{Overwrite, check_folder, write_folder};
pub use interrupt::end_between_files;
pub(crate) use interrupt::uninterrupted;
use place::refuse_folder;
pub(crate) use place::{check_place, is_within};

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
pub(crate) fn write_whole(
    file: &Path,
    bytes: &[u8],
    out: &mut dyn Write,
) -> Result<(), CommandError> {
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

#[cfg(test)]
mod tests;
