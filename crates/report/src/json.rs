//! Documents as JSON, with the data of every figure.

use crate::{Document, ReportError};

/// The whole document as indented JSON, figures with all their numbers: what another program needs to draw or check them.
///
/// Numbers are written so that they read back exactly; a number that is not finite becomes `null`.
///
/// # Errors
///
/// [`ReportError::Json`] where the text cannot be made, which does not happen for the blocks of this crate.
///
/// # Example
///
/// ```
/// use report::{Block, Document, json};
///
/// let text = json::render(&Document::new("Example").with(Block::paragraph("It holds.")))?;
/// assert!(text.contains(r#""kind": "paragraph""#));
/// # Ok::<(), report::ReportError>(())
/// ```
pub fn render(document: &Document) -> Result<String, ReportError> {
    serde_json::to_string_pretty(document)
        .map_err(|error| ReportError::Json { reason: error.to_string() })
}

#[cfg(test)]
mod tests;
