//! Each equation of the paper is named by one doc comment, and docs/equations.md knows where.

use std::collections::BTreeMap;

use super::sources::Source;

/// What a doc comment says to claim an equation. Split so that this file claims none.
const MARK: &str = concat!("paper ", "eq. (");

/// Where an equation is implemented: the file, and the item whose doc comment names it.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Place {
    file: String,
    item: String,
}

/// One sentence for each equation that table and code place differently.
pub(crate) fn disagreements(table: &str, files: &[Source]) -> Vec<String> {
    let (listed, mut faults) = listed(table);
    let mut found: BTreeMap<u32, Vec<Place>> = BTreeMap::new();
    for (number, place) in files.iter().flat_map(marks) {
        found.entry(number).or_default().push(place);
    }
    for (number, places) in &found {
        if places.len() > 1 {
            let all: Vec<_> =
                places.iter().map(|place| format!("{} ({})", place.item, place.file)).collect();
            faults.push(format!("equation ({number}) is named more than once: {}", all.join(", ")));
        }
        match listed.get(number) {
            None => faults.push(format!(
                "equation ({number}) is missing in docs/equations.md: {:?}",
                places[0]
            )),
            Some(place) if *place != places[0] => {
                faults.push(format!(
                    "equation ({number}): docs/equations.md says {place:?}, the code {:?}",
                    places[0]
                ));
            }
            Some(_) => {}
        }
    }
    for number in listed.keys().filter(|number| !found.contains_key(number)) {
        faults.push(format!(
            "equation ({number}) is in docs/equations.md, but no doc comment names it"
        ));
    }
    faults
}

/// Rows such as ``| (5) | `item` | `file` | .. |``.
fn listed(table: &str) -> (BTreeMap<u32, Place>, Vec<String>) {
    let mut places = BTreeMap::new();
    let mut faults = Vec::new();
    for line in table.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, number, item, file, ..] = cells[..] else { continue };
        let Some(number) = number.strip_prefix('(').and_then(|n| n.strip_suffix(')')?.parse().ok())
        else {
            continue;
        };
        let place = Place { file: unquoted(file), item: unquoted(item) };
        if places.insert(number, place).is_some() {
            faults.push(format!("equation ({number}) has two rows in docs/equations.md"));
        }
    }
    (places, faults)
}

fn unquoted(cell: &str) -> String {
    cell.trim_matches('`').to_owned()
}

/// Every equation that a doc comment of the file names.
fn marks(source: &Source) -> Vec<(u32, Place)> {
    let lines: Vec<&str> = source.text.lines().map(str::trim_start).collect();
    let mut marks = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        if !line.starts_with("//") {
            continue;
        }
        for piece in line.split(MARK).skip(1) {
            if let Some(number) = piece.split(')').next().and_then(|digits| digits.parse().ok()) {
                let file = source.path.to_string_lossy().replace('\\', "/");
                marks.push((number, Place { file, item: documented_item(&lines, index) }));
            }
        }
    }
    marks
}

/// The name of the item below the comment on that line; `module` for the comment of a whole file.
fn documented_item(lines: &[&str], comment: usize) -> String {
    if lines[comment].starts_with("//!") {
        return "module".to_owned();
    }
    const KEYWORDS: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "const", "mod", "static"];
    lines[comment..]
        .iter()
        .filter(|line| !line.starts_with("//") && !line.starts_with('#'))
        .find_map(|line| {
            let words: Vec<&str> = line
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .filter(|word| !word.is_empty())
                .collect();
            // `pub const fn name`: the name follows the last of the keywords. A field or a variant
            // has none.
            let keyword = words
                .iter()
                .take_while(|word| **word != "impl")
                .position(|word| KEYWORDS.contains(word));
            let name = match keyword {
                Some(index) => words[index..].iter().find(|word| !KEYWORDS.contains(word)),
                None => words.iter().find(|word| !matches!(**word, "pub" | "crate")),
            };
            name.map(|name| (*name).to_owned())
        })
        .unwrap_or_default()
}

#[cfg(test)]
mod tests;
