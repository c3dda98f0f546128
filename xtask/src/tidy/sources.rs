//! The shape of source files: each starts with what it is for, and none holds two ideas' worth of
//! lines.

use std::path::{Path, PathBuf};

use crate::TaskError;

/// Above this a file is no longer one idea.
const LONGEST_FILE: usize = 500;

/// A Rust file of the tree, with its path from the root.
pub(crate) struct Source {
    pub(crate) path: PathBuf,
    pub(crate) text: String,
}

/// Every `.rs` file below `root` but those of the build folder, sorted by path.
pub(crate) fn rust_files(root: &Path) -> Result<Vec<Source>, TaskError> {
    let mut files = Vec::new();
    for folder in ["crates", "xtask", "tests"] {
        collect(root, &root.join(folder), &mut files)?;
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

fn collect(root: &Path, folder: &Path, files: &mut Vec<Source>) -> Result<(), TaskError> {
    for entry in std::fs::read_dir(folder).map_err(|source| TaskError::io(folder, source))? {
        let path = entry.map_err(|source| TaskError::io(folder, source))?.path();
        if path.is_dir() {
            if !path.ends_with("target") {
                collect(root, &path, files)?;
            }
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text =
                std::fs::read_to_string(&path).map_err(|source| TaskError::io(&path, source))?;
            files.push(Source { path: path.strip_prefix(root).unwrap_or(&path).to_owned(), text });
        }
    }
    Ok(())
}

/// One sentence for each file that is too long or does not say what it is for.
pub(crate) fn faults(files: &[Source]) -> Vec<String> {
    let mut faults = Vec::new();
    for Source { path, text } in files {
        let lines = text.lines().count();
        if lines > LONGEST_FILE {
            faults.push(format!(
                "{}: {lines} lines, at most {LONGEST_FILE} make one idea",
                path.display()
            ));
        }
        let is_tests =
            path.ends_with("tests.rs") || path.components().any(|part| part.as_os_str() == "tests");
        if !is_tests && !text.starts_with("//!") {
            faults.push(format!(
                "{}: the first line must be //! and say what the file is for",
                path.display()
            ));
        }
    }
    faults
}
