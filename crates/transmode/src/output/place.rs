//! Where a result may go, judged before any work is done.

use std::io::ErrorKind;
use std::path::Path;

use crate::CommandError;

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

/// A folder is never replaced by a file.
pub(super) fn refuse_folder(place: &Path) -> Result<(), CommandError> {
    if place.is_dir() {
        let source = ErrorKind::IsADirectory.into();
        return Err(CommandError::Write { file: place.to_owned(), source });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
