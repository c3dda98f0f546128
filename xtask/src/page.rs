//! Generated pages: a Markdown file and its figures, in a folder or in docs.

use std::path::Path;

use report::{Document, markdown, png, svg};
use transmode::write_whole;

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
        let place = folder.join(figures);
        std::fs::create_dir_all(&place).map_err(|source| TaskError::io(&place, source))?;
        for figure in self.document.figures() {
            let picture = svg::render(figure).map_err(TaskError::computation("figures"))?;
            write(&place.join(format!("{}.svg", figure.id)), picture.as_bytes())?;
            if pictures == Pictures::Both {
                let pixels =
                    png::render(&picture, 2.0).map_err(TaskError::computation("figures"))?;
                write(&place.join(format!("{}.png", figure.id)), &pixels)?;
            }
        }
        let text = format!(
            "<!-- Written by `{}`. -->\n\n{}",
            self.command,
            markdown::render(self.document, figures)
        );
        write(&folder.join(self.file), text.as_bytes())
    }
}

fn write(file: &Path, bytes: &[u8]) -> Result<(), TaskError> {
    Ok(write_whole(file, bytes, &mut std::io::sink())?)
}
