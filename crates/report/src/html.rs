//! Documents as one HTML page that needs nothing else: style and pictures are inside, nothing is fetched, no script runs.
//!
//! The page reads well on a desk, on a phone, and on paper. It follows the reader's choice of a light or a dark screen; the pictures
//! change their colours with it, and paper is always white. Every figure is in the page twice, with its panels side by side and
//! below one another, and the narrow screen shows the second, so that the text in it keeps its size.

use crate::document::{Block, CalloutKind, Document, ListKind};
use crate::figure::Figure;
use crate::inline::{Span, spans};
use crate::markdown::sentences;
use crate::svg::{self, Medium, escape};
use crate::table::{Align, Table};
use crate::{ReportError, font};
use std::fmt::Write;

/// Writes a document as a page.
///
/// Figures and tables are numbered in reading order. Figures can be linked to by `#ID`, headings by their words (`#the-result`).
///
/// # Errors
///
/// What [`svg::render`] returns for one of the figures, or [`ReportError::DuplicateFigureId`].
///
/// # Example
///
/// ```
/// use report::{Block, Document, html};
///
/// let page = html::render(&Document::new("Modes & poles").with(Block::section("The result")))?;
/// assert!(page.contains("<h1>Modes &amp; poles</h1>"));
/// assert!(page.contains("<h2 id=\"the-result\">The result</h2>"));
/// # Ok::<(), report::ReportError>(())
/// ```
pub fn render(document: &Document) -> Result<String, ReportError> {
    let mut anchors: Vec<String> = Vec::new();
    for figure in document.figures() {
        if anchors.contains(&figure.id) {
            return Err(ReportError::DuplicateFigureId { id: figure.id.clone() });
        }
        anchors.push(figure.id.clone());
    }
    let title = escape(&document.title);
    let generator = document.generator.as_ref().map_or_else(String::new, |program| {
        format!("<meta name=\"generator\" content=\"{}\">\n", escape(program))
    });
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n{generator}<title>{title}</title>\n\
         <style>\n{}{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n",
        include_str!("html/page.css"),
        dark_pictures(),
        text(&document.title)
    );
    let (mut figures, mut tables) = (0, 0);
    for block in &document.blocks {
        match block {
            Block::Heading { level, text: words } => {
                let level = (*level).clamp(2, 4);
                let anchor = anchor(words, &mut anchors);
                let _ = writeln!(out, "<h{level} id=\"{anchor}\">{}</h{level}>", text(words));
            }
            Block::Paragraph { text: words } => {
                let _ = writeln!(out, "<p>{}</p>", text(words));
            }
            Block::Table(table) => {
                tables += 1;
                write_table(&mut out, table, Some(tables));
            }
            Block::Figure(figure) => {
                figures += 1;
                write_figure(&mut out, figure, figures)?;
            }
            Block::Code { language, text: code } => {
                let class = if language.is_empty() {
                    String::new()
                } else {
                    format!(" class=\"language-{}\"", escape(language))
                };
                let _ = writeln!(
                    out,
                    "<pre><code{class}>{}</code></pre>",
                    escape(code.trim_end_matches('\n'))
                );
            }
            Block::List { style, items } => {
                let tag = match style {
                    ListKind::Bullets => "ul",
                    ListKind::Numbers => "ol",
                };
                let _ = writeln!(out, "<{tag}>");
                for item in items {
                    let _ = writeln!(out, "<li>{}</li>", text(item));
                }
                let _ = writeln!(out, "</{tag}>");
            }
            Block::Callout { tone, text: words } => {
                let (class, name) = match tone {
                    CalloutKind::Note => ("note", "Note."),
                    CalloutKind::Warning => ("warning", "Warning."),
                };
                let _ = writeln!(
                    out,
                    "<aside class=\"{class}\"><p><strong>{name}</strong> {}</p></aside>",
                    text(words)
                );
            }
        }
    }
    out.push_str("</main>\n</body>\n</html>\n");
    Ok(out)
}

impl Table {
    /// The table as an HTML element, its title as the caption.
    pub fn to_html(&self) -> String {
        let mut out = String::new();
        write_table(&mut out, self, None);
        out
    }
}

fn write_table(out: &mut String, table: &Table, number: Option<usize>) {
    out.push_str("<div class=\"table\"><table>\n");
    let name = number.map_or(String::new(), |n| format!("<strong>Table {n}.</strong> "));
    if number.is_some() || !table.title().is_empty() {
        let _ = writeln!(out, "<caption>{name}{}</caption>", text(&sentences(table.title(), "")));
    }
    let class = |align| match align {
        Align::Left => "",
        Align::Right => " class=\"right\"",
        Align::Center => " class=\"center\"",
    };
    let columns = table.columns();
    out.push_str("<thead><tr>");
    for column in columns {
        let _ =
            write!(out, "<th scope=\"col\"{}>{}</th>", class(column.align), text(&column.header));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    for row in table.rows() {
        out.push_str("<tr>");
        for (cell, column) in row.iter().zip(columns) {
            let _ = write!(out, "<td{}>{}</td>", class(column.align), text(cell));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody>\n</table></div>\n");
}

fn write_figure(out: &mut String, figure: &Figure, number: usize) -> Result<(), ReportError> {
    let _ = writeln!(out, "<figure id=\"{}\">", figure.id);
    for (medium, class) in [(Medium::Page, "wide"), (Medium::Phone, "narrow")] {
        let picture = svg::draw(figure, medium)?;
        // Inside a page the name space is known.
        let picture = picture.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
        let _ = write!(out, "<div class=\"{class}\">\n{}\n</div>\n", picture.trim_end());
    }
    let caption = text(&sentences(&figure.title, &figure.caption));
    let _ = writeln!(
        out,
        "<figcaption><strong>Figure {number}.</strong> {caption}</figcaption>\n</figure>"
    );
    Ok(())
}

/// Rules that recolour the pictures on a dark screen; they hold for attributes, so the pictures need no classes.
fn dark_pictures() -> String {
    let mut out = format!(
        "figure svg {{ font-family: {}; }}\n@media screen and (prefers-color-scheme: dark) {{\n",
        font::FAMILIES
    );
    for (light, dark) in svg::ON_DARK {
        let _ = writeln!(
            out,
            "  figure svg[fill=\"{light}\"], figure svg [fill=\"{light}\"] {{ fill: {dark}; }}"
        );
        let _ = writeln!(out, "  figure svg [stroke=\"{light}\"] {{ stroke: {dark}; }}");
    }
    out.push_str("}\n");
    out
}

fn text(source: &str) -> String {
    let piece = |span| match span {
        Span::Text(text) => escape(text),
        Span::Code(text) => format!("<code>{}</code>", escape(text)),
        Span::Strong(text) => format!("<strong>{}</strong>", escape(text)),
    };
    spans(source).into_iter().map(piece).collect()
}

/// The words of a heading as an anchor that nothing else in the page has.
fn anchor(words: &str, taken: &mut Vec<String>) -> String {
    let joined: String = words.chars().map(|c| if c.is_alphanumeric() { c } else { ' ' }).collect();
    let base = joined.to_lowercase().split_whitespace().collect::<Vec<_>>().join("-");
    let base = if base.is_empty() { "section".to_owned() } else { base };
    let free = |name: &String| !taken.contains(name);
    let name = std::iter::once(base.clone())
        .chain((2..).map(|n| format!("{base}-{n}")))
        .find(free)
        .unwrap_or(base);
    taken.push(name.clone());
    name
}

#[cfg(test)]
mod tests;
