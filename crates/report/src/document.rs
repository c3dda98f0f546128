//! Documents as plain data: a title and a list of blocks.

use crate::figure::Figure;
use crate::table::Table;
use serde::Serialize;

/// Tone of a callout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum CalloutKind {
    /// Worth knowing.
    Note,
    /// The reader could go wrong without it.
    Warning,
}

/// Whether the items of a list are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ListKind {
    /// Bullets.
    #[default]
    Bullets,
    /// Numbers from 1.
    Numbers,
}

/// One part of a document.
///
/// Text is taken literally, except that `` `code` `` and `**strong**` are set as such.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[non_exhaustive]
pub enum Block {
    /// A heading; level 2 is a section, 3 a subsection, other levels are clamped to 2..=4. The document's title is level 1.
    Heading {
        /// 2 for a section, 3 for a subsection.
        level: u8,
        /// Text.
        text: String,
    },
    /// A paragraph.
    Paragraph {
        /// Text.
        text: String,
    },
    /// A table with its title.
    Table(Table),
    /// A figure with its title and caption.
    Figure(Figure),
    /// Lines in a fixed-width font.
    Code {
        /// Name of the language, may be empty.
        language: String,
        /// The lines.
        text: String,
    },
    /// A list.
    List {
        /// Bullets or numbers.
        style: ListKind,
        /// Text of each item.
        items: Vec<String>,
    },
    /// A paragraph set apart.
    Callout {
        /// Tone.
        tone: CalloutKind,
        /// Text.
        text: String,
    },
}

impl Block {
    /// A section heading.
    pub fn section(text: impl Into<String>) -> Self {
        Self::Heading { level: 2, text: text.into() }
    }

    /// A subsection heading.
    pub fn subsection(text: impl Into<String>) -> Self {
        Self::Heading { level: 3, text: text.into() }
    }

    /// A paragraph.
    pub fn paragraph(text: impl Into<String>) -> Self {
        Self::Paragraph { text: text.into() }
    }

    /// Lines of code or of a terminal.
    pub fn code(language: impl Into<String>, text: impl Into<String>) -> Self {
        Self::Code { language: language.into(), text: text.into() }
    }

    /// A list with bullets.
    pub fn bullets<S: Into<String>>(items: impl IntoIterator<Item = S>) -> Self {
        Self::List { style: ListKind::Bullets, items: items.into_iter().map(Into::into).collect() }
    }

    /// A list with numbers from 1.
    pub fn numbers<S: Into<String>>(items: impl IntoIterator<Item = S>) -> Self {
        Self::List { style: ListKind::Numbers, items: items.into_iter().map(Into::into).collect() }
    }

    /// Something worth knowing.
    pub fn note(text: impl Into<String>) -> Self {
        Self::Callout { tone: CalloutKind::Note, text: text.into() }
    }

    /// Something that could lead the reader astray.
    pub fn warning(text: impl Into<String>) -> Self {
        Self::Callout { tone: CalloutKind::Warning, text: text.into() }
    }
}

impl From<Table> for Block {
    fn from(table: Table) -> Self {
        Self::Table(table)
    }
}

impl From<Figure> for Block {
    fn from(figure: Figure) -> Self {
        Self::Figure(figure)
    }
}

/// A report: a title and blocks in reading order.
///
/// # Example
///
/// ```
/// use report::{Block, Document};
///
/// let document = Document::new("Example").with(Block::section("Result")).with(Block::paragraph("It holds."));
/// assert_eq!(document.blocks.len(), 2);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Document {
    /// Title of the page.
    pub title: String,
    /// The program that wrote it and its version, for the head of a page.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub generator: Option<String>,
    /// Parts in reading order.
    pub blocks: Vec<Block>,
}

impl Document {
    /// An empty document.
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), generator: None, blocks: Vec::new() }
    }

    /// Says which program writes the document.
    #[must_use]
    pub fn generator(mut self, program: impl Into<String>) -> Self {
        self.generator = Some(program.into());
        self
    }

    /// Adds a block at the end.
    #[must_use]
    pub fn with(mut self, block: impl Into<Block>) -> Self {
        self.push(block);
        self
    }

    /// Adds a block at the end.
    pub fn push(&mut self, block: impl Into<Block>) {
        self.blocks.push(block.into());
    }

    /// The figures, in reading order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Figure(figure) => Some(figure),
            _ => None,
        })
    }

    /// The tables, in reading order.
    pub fn tables(&self) -> impl Iterator<Item = &Table> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        })
    }
}
