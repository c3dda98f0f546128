//! What the compiler cannot check: equation marks against docs/equations.md, and the shape of
//! source files.

mod equations;
mod sources;

use std::path::Path;

use crate::TaskError;

/// Checks the tree below `root` and reports every fault at once.
pub(crate) fn run(root: &Path, out: &mut dyn std::io::Write) -> Result<(), TaskError> {
    let files = sources::rust_files(root)?;
    let table = root.join("docs/equations.md");
    let text = std::fs::read_to_string(&table).map_err(|source| TaskError::io(&table, source))?;
    let mut faults = equations::disagreements(&text, &files);
    faults.extend(sources::faults(&files));
    if faults.is_empty() {
        writeln!(out, "tidy: {} files, no fault", files.len())
            .map_err(|source| TaskError::io("standard output", source))
    } else {
        Err(TaskError::Untidy { faults })
    }
}
