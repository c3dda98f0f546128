//! Generated pages: a Markdown file and its figures, in a folder or in docs. No file is ever left
//! half written.

use std::fs::File;
use std::io::Write;
use std::path::Path;

use report::{Document, markdown, png, svg};

use crate::TaskError;

/// A document and where it belongs.
pub(crate) struct Page<'a> {
    /// Name of the Markdown file.
    pub(crate) file: &'a str,
    /// What writes it, for whoever opens the file.
    pub(crate) command: &'a str,
    pub(crate) document: &'a Document,
}

/// Which pictures to write: for the tree the SVG is enough.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pictures {
    Vector,
    Both,
}

impl Page<'_> {
    /// Writes the page into a folder, its figures into a folder in that.
    pub(crate) fn write(
        &self,
        folder: &Path,
        figures: &str,
        pictures: Pictures,
    ) -> Result<(), TaskError> {
        write_figures(self.document, &folder.join(figures), pictures)?;
        write_whole(&folder.join(self.file), self.text(figures).as_bytes())
    }

    /// The Markdown, whose figures are in the folder `figures` beside it.
    pub(crate) fn text(&self, figures: &str) -> String {
        let body = markdown::render(self.document, figures);
        format!("<!-- Written by `{}`. -->\n\n{body}", self.command)
    }
}

/// Draws the figures of a document into a folder, which is made where it is missing.
pub(crate) fn write_figures(
    document: &Document,
    folder: &Path,
    pictures: Pictures,
) -> Result<(), TaskError> {
    std::fs::create_dir_all(folder).map_err(|source| TaskError::io(folder, source))?;
    for figure in document.figures() {
        let picture = svg::render(figure).map_err(TaskError::computation("figures"))?;
        write_whole(&folder.join(format!("{}.svg", figure.id)), picture.as_bytes())?;
        if pictures == Pictures::Both {
            let pixels = png::render(&picture, 2.0).map_err(TaskError::computation("figures"))?;
            write_whole(&folder.join(format!("{}.png", figure.id)), &pixels)?;
        }
    }
    Ok(())
}

/// Writes a file all or not at all: into a draft beside it, which then takes its place.
pub(crate) fn write_whole(file: &Path, bytes: &[u8]) -> Result<(), TaskError> {
    let folder = file.parent().unwrap_or(Path::new("."));
    // `File::create_new` gives the rights of an ordinary file; those of a temporary one are its
    // owner's alone.
    let draft =
        tempfile::Builder::new().prefix(".xtask-").make_in(folder, |draft| File::create_new(draft));
    let written = draft.and_then(|mut draft| {
        draft.write_all(bytes)?;
        draft.as_file().sync_all()?;
        draft.persist(file).map_err(|error| error.error)
    });
    written.map(drop).map_err(|source| TaskError::Write { file: file.to_owned(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_or_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("page.md");
        write_whole(&file, b"first").unwrap();
        write_whole(&file, b"second").unwrap();
        assert_eq!(std::fs::read(&file).unwrap(), b"second");

        // A folder cannot be replaced by a file; no draft stays behind.
        let taken = folder.path().join("taken");
        std::fs::create_dir(&taken).unwrap();
        let error = write_whole(&taken, b"x").unwrap_err().to_string();
        assert!(error.starts_with(&format!("{}: not written: ", taken.display())), "{error}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }
}
