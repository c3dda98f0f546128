//! docs/errata.md names a check for each slip, and each check with that verdict is named there.

use std::path::Path;

use super::check::{Check, Verdict};
use crate::TaskError;

pub(crate) fn check(root: &Path, checks: &[&Check]) -> Result<(), TaskError> {
    let file = root.join("docs/errata.md");
    let text = std::fs::read_to_string(&file).map_err(|source| TaskError::io(&file, source))?;
    let faults = faults(&text, checks.iter().map(|check| (check.id, check.verdict)));
    if faults.is_empty() { Ok(()) } else { Err(TaskError::Errata { faults }) }
}

fn faults<'a>(text: &str, checks: impl Iterator<Item = (&'a str, Verdict)>) -> Vec<String> {
    let checks: Vec<_> = checks.collect();
    // The table's last column holds the names, in backticks.
    let last_cells = text
        .lines()
        .filter(|line| line.starts_with("| "))
        .filter_map(|line| line.trim_end_matches('|').rsplit('|').next());
    let named: Vec<&str> = last_cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).collect();
    let unknown = named
        .iter()
        .filter(|name| !checks.iter().any(|(id, _)| id == *name))
        .map(|name| format!("no check is called {name}"));
    let unlisted = checks
        .iter()
        .filter(|(id, verdict)| *verdict == Verdict::Erratum && !named.contains(id))
        .map(|(id, _)| format!("{id} is an erratum that is not listed"));
    unknown.chain(unlisted).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_directions_are_checked() {
        let text = "| where | printed | right | check |\n|---|---|---|---|\n| a | b | c | `known`, `gone` |\n";
        let checks =
            [("known", Verdict::Erratum), ("silent", Verdict::Erratum), ("fine", Verdict::Match)];
        assert_eq!(
            faults(text, checks.into_iter()),
            ["no check is called gone", "silent is an erratum that is not listed"]
        );
    }
}
