//! What is done to the columns of a file that its owner may not expect.

use std::path::Path;

use super::selection::{Selected, Selection, TimeSource, is_time};
use super::table::Table;
use super::unit::Unit;
use super::warning::LoadWarning;
use super::wrap;

/// Columns that are left out, units that are not known, a column of time that is not used.
pub(super) fn of_columns(
    file: &Path,
    table: &Table,
    selected: &Selected,
    selection: &Selection,
) -> Vec<LoadWarning> {
    let file = || file.to_owned();
    let mut warnings = Vec::new();
    if selection.outputs.is_empty() {
        let words = table.headings.iter().filter(|heading| heading.is_words);
        let mut columns: Vec<String> = words.map(|heading| heading.name.clone()).collect();
        columns
            .extend(table.ignored.iter().map(|column| table.headings[column.index].name.clone()));
        if !columns.is_empty() {
            warnings.push(LoadWarning::ColumnsIgnored { file: file(), columns });
        }
    }
    let unknown: Vec<(String, String)> = selected
        .sensors
        .iter()
        .map(|sensor| &table.headings[sensor.index])
        .filter_map(|heading| Some((heading.name.clone(), heading.unit.clone()?)))
        .filter(|(_, unit)| Unit::parse(unit).is_none())
        .collect();
    if !unknown.is_empty() {
        warnings.push(LoadWarning::UnitUnknown { file: file(), columns: unknown });
    }
    if table.repeated > 0 {
        warnings.push(LoadWarning::RowsRepeated { file: file(), rows: table.repeated });
    }
    if let TimeSource::Period(period_s) = selection.time
        && let Some(time) = table.headings.iter().find(|heading| is_time(&heading.name))
        && !selection.outputs.contains(&time.name)
    {
        let column = time.name.clone();
        warnings.push(LoadWarning::TimeUnused { file: file(), column, period_s });
    }
    warnings
}

/// Has angles go on beyond a turn.
pub(super) fn unwrap(file: &Path, table: &mut Table, selected: &Selected) -> Option<LoadWarning> {
    let mut columns = Vec::new();
    for (index, sensor) in selected.sensors.iter().enumerate() {
        let Some(values) = table.values.get_mut(index) else { continue };
        if let Some(turn) = wrap::turn(values, sensor.si) {
            wrap::unwrap(values, turn);
            columns.push(table.headings[sensor.index].name.clone());
        }
    }
    let file = file.to_owned();
    (!columns.is_empty()).then_some(LoadWarning::Unwrapped { file, columns })
}
