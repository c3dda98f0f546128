//! Whether the sensors of several files are in the same units.

use std::path::Path;

use reconstruct::Record;

use super::source::Source;
use super::warning::LoadWarning;
use crate::error::SelectionError;

/// Refuses sensors that the first file has in other units, and warns where one of two files alone says what they are.
pub(super) fn check(
    records: &[Record],
    sources: &[Source],
) -> Result<Vec<LoadWarning>, SelectionError> {
    let mut warnings = Vec::new();
    let mut all = records.iter().zip(sources);
    let Some((first, before)) = all.next() else { return Ok(warnings) };
    let mut seen: Vec<&Path> = vec![&before.file];
    for (record, source) in all {
        // The stretches and windows of a file have its units.
        if seen.contains(&source.file.as_path()) {
            continue;
        }
        seen.push(&source.file);
        for (channel, unit) in record.channels().iter().zip(&source.units) {
            let place = first.channels().iter().position(|other| other.name == channel.name);
            let Some(other_unit) = place.map(|place| before.units[place]) else { continue };
            let (unit, [stated, silent]) = match (*unit, other_unit) {
                (Some(unit), Some(other_unit)) if unit != other_unit => {
                    return Err(SelectionError::UnitsDiffer {
                        file: source.file.clone(),
                        column: channel.name.clone(),
                        unit,
                        other: before.file.clone(),
                        other_unit,
                    });
                }
                (Some(unit), None) => (unit, [source, before]),
                (None, Some(unit)) => (unit, [before, source]),
                _ => continue,
            };
            let files = [stated, silent].map(|source| source.file.display().to_string());
            let column = channel.name.clone();
            warnings.push(LoadWarning::UnitMissing { files, column, unit });
        }
    }
    Ok(warnings)
}
