//! Documents as Markdown with tables (GitHub's flavour); figures are links to SVG files.

use crate::document::{Block, CalloutKind, Document, ListKind};
use crate::inline::{Span, spans};
use crate::table::{Align, Table};
use std::fmt::Write;

/// Writes a document; each figure becomes a link to `FOLDER/ID.svg`, where the caller has to put what
/// [`svg::render`](crate::svg::render) returns. With an empty folder the pictures lie beside the text.
///
/// Figures and tables are numbered in reading order. Characters that Markdown would take as markup are escaped.
///
/// # Example
///
/// ```
/// use report::{Block, Document, Figure, markdown};
///
/// let document = Document::new("Example").with(Figure::new("map", "Pole map", "One pole."));
/// assert_eq!(markdown::render(&document, "figures"), "# Example\n\n![Pole map](figures/map.svg)\n\n**Figure 1.** Pole map. One pole.\n");
/// ```
pub fn render(document: &Document, figure_folder: &str) -> String {
    let mut out = format!("# {}\n", line(&document.title));
    let (mut figures, mut tables) = (0, 0);
    for block in &document.blocks {
        out.push('\n');
        match block {
            Block::Heading { level, text } => {
                let marks = "#".repeat(usize::from((*level).clamp(2, 4)));
                let _ = writeln!(out, "{marks} {}", line(text));
            }
            Block::Paragraph { text } => {
                let _ = writeln!(out, "{}", paragraph(text));
            }
            Block::Table(table) => {
                tables += 1;
                write_table(&mut out, table, tables);
            }
            Block::Figure(figure) => {
                figures += 1;
                let folder = figure_folder.trim_end_matches('/');
                let folder = if folder.is_empty() { String::new() } else { format!("{folder}/") };
                let target = format!("{folder}{}.svg", figure.id);
                // A target with spaces or brackets has to be fenced.
                let plain = target.chars().all(|c| c.is_ascii_alphanumeric() || "-_./".contains(c));
                let target = if plain {
                    target
                } else {
                    format!("<{}>", target.replace(['<', '>', '\n'], "_"))
                };
                let _ = writeln!(out, "![{}]({target})\n", line(&figure.title));
                let text = sentences(&figure.title, &figure.caption);
                let _ = writeln!(out, "**Figure {figures}.** {}", line(&text));
            }
            Block::Code { language, text } => {
                let fence = "`".repeat(longest_run(text).max(2) + 1);
                let _ =
                    writeln!(out, "{fence}{language}\n{}\n{fence}", text.trim_end_matches('\n'));
            }
            Block::List { style, items } => {
                for (i, item) in items.iter().enumerate() {
                    let mark = match style {
                        ListKind::Bullets => "- ".to_owned(),
                        ListKind::Numbers => format!("{}. ", i + 1),
                    };
                    let indented =
                        paragraph(item).replace('\n', &format!("\n{}", " ".repeat(mark.len())));
                    let _ = writeln!(out, "{mark}{indented}");
                }
            }
            Block::Callout { tone, text } => {
                let name = match tone {
                    CalloutKind::Note => "NOTE",
                    CalloutKind::Warning => "WARNING",
                };
                let _ = writeln!(out, "> [!{name}]\n> {}", paragraph(text).replace('\n', "\n> "));
            }
        }
    }
    out
}

/// A title and a caption as sentences.
pub(crate) fn sentences(title: &str, caption: &str) -> String {
    let ended = title.is_empty() || title.ends_with(['.', '?', '!']);
    format!("{title}{} {caption}", if ended { "" } else { "." }).trim().to_owned()
}

impl Table {
    /// The table as Markdown, its title above in bold. Numbers line up on the right.
    pub fn to_markdown(&self) -> String {
        let mut out = String::new();
        if !self.title().is_empty() {
            let _ = writeln!(out, "**{}**\n", line(self.title()));
        }
        write_grid(&mut out, self);
        out
    }
}

fn write_table(out: &mut String, table: &Table, number: usize) {
    let _ = writeln!(out, "**Table {number}.** {}\n", line(&sentences(table.title(), "")));
    write_grid(out, table);
}

fn write_grid(out: &mut String, table: &Table) {
    if table.columns().is_empty() {
        return;
    }
    let write_row = |out: &mut String, cells: &mut dyn Iterator<Item = String>| {
        out.push('|');
        for cell in cells {
            let _ = write!(out, " {cell} |");
        }
        out.push('\n');
    };
    write_row(out, &mut table.columns().iter().map(|column| cell(&column.header)));
    let rule = |align| match align {
        Align::Left => ":--",
        Align::Right => "--:",
        Align::Center => ":-:",
    };
    write_row(out, &mut table.columns().iter().map(|column| rule(column.align).to_owned()));
    for row in table.rows() {
        write_row(out, &mut row.iter().map(|text| cell(text)));
    }
}

fn cell(text: &str) -> String {
    // A bar ends the cell even inside code, so it is escaped everywhere.
    line(text).replace('|', "\\|")
}

/// Text on one line, not at its beginning.
fn line(text: &str) -> String {
    escaped(&text.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// Text on one or more lines of its own.
fn paragraph(text: &str) -> String {
    let lines: Vec<String> = escaped(text).lines().map(|line| guarded(line.trim_start())).collect();
    lines.join("\n")
}

fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for span in spans(text.trim()) {
        match span {
            Span::Text(text) => push_escaped(&mut out, text),
            Span::Code(text) => {
                let fence = "`".repeat(longest_run(text) + 1);
                let _ = write!(out, "{fence}{text}{fence}");
            }
            Span::Strong(text) => {
                out.push_str("**");
                push_escaped(&mut out, text);
                out.push_str("**");
            }
        }
    }
    out
}

/// A line that does not begin a heading, a list, a quotation or a table.
fn guarded(line: &str) -> String {
    let digits = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let numbered =
        digits > 0 && line[digits..].starts_with(['.', ')']) && line[digits + 1..].starts_with(' ');
    if numbered {
        format!("{}\\{}", &line[..digits], &line[digits..])
    } else if line.starts_with(['#', '+', '-', '=', '>', '|']) && !line.starts_with("-0") {
        format!("\\{line}")
    } else {
        line.to_owned()
    }
}

fn push_escaped(out: &mut String, text: &str) {
    let mut before = ' ';
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let after = rest.peek().copied().unwrap_or(' ');
        let in_word = before.is_alphanumeric() && after.is_alphanumeric();
        match c {
            '\\' | '`' | '*' | '<' | '>' | '[' | ']' => out.push('\\'),
            // Inside a word an underscore is literal already.
            '_' | '~' if !in_word => out.push('\\'),
            '&' if after.is_alphanumeric() || after == '#' => out.push('\\'),
            _ => {}
        }
        out.push(c);
        before = c;
    }
}

fn longest_run(text: &str) -> usize {
    text.split(|c| c != '`').map(str::len).max().unwrap_or(0)
}

#[cfg(test)]
mod tests;
