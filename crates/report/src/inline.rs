//! The little markup that text may hold: `code` and **strong**. Everything else is literal.

/// A piece of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Span<'a> {
    /// Literal text.
    Text(&'a str),
    /// Between back quotes.
    Code(&'a str),
    /// Between double asterisks.
    Strong(&'a str),
}

/// Splits a text into its pieces. A mark without its partner, or with nothing between, is literal.
pub(crate) fn spans(text: &str) -> Vec<Span<'_>> {
    let mut spans = Vec::new();
    let (mut literal, mut at) = (0, 0);
    while let Some(found) = text[at..].find(['`', '*']).map(|offset| at + offset) {
        let mark = if text[found..].starts_with('`') { "`" } else { "**" };
        let inside = found + mark.len();
        let end = if text[found..].starts_with(mark) { text[inside..].find(mark) } else { None };
        match end {
            Some(length) if length > 0 => {
                if literal < found {
                    spans.push(Span::Text(&text[literal..found]));
                }
                let content = &text[inside..inside + length];
                spans.push(if mark == "`" { Span::Code(content) } else { Span::Strong(content) });
                at = inside + length + mark.len();
                literal = at;
            }
            // One byte is enough: both marks are ASCII.
            _ => at = found + 1,
        }
    }
    if literal < text.len() {
        spans.push(Span::Text(&text[literal..]));
    }
    spans
}

#[cfg(test)]
mod tests;
