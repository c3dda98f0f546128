//! Columns of measured inputs: read beside the sensors, never taken for one.

use std::path::Path;

use super::options::LoadOptions;
use super::selection::{Selected, TimeSource, position, wanted};
use super::table::Heading;
use crate::CommandError;
use crate::error::SelectionError;

/// Refuses names that no file could satisfy.
pub(super) fn check(options: &LoadOptions) -> Result<(), CommandError> {
    let names = &options.known_inputs;
    for (index, column) in names.iter().enumerate() {
        if names[..index].contains(column) {
            return fault(column, "twice");
        }
        if options.selection.outputs.contains(column) {
            return fault(column, "and --outputs, too; a column is an input or a sensor");
        }
        if options.selection.time == TimeSource::Column(column.clone()) {
            return fault(column, "and --time, too; name the column of the input");
        }
    }
    Ok(())
}

/// Puts the columns of the measured inputs behind the sensors, and takes them from among these where all columns are sensors by default. For each input the
/// reason why the file has no such column, if it has none.
pub(super) fn select(
    file: &Path,
    headings: &[Heading],
    options: &LoadOptions,
    selected: &mut Selected,
) -> Result<Vec<Option<CommandError>>, CommandError> {
    let mut inputs: Vec<usize> = Vec::new();
    let mut missing = Vec::new();
    for column in &options.known_inputs {
        let index = match position(file, headings, column) {
            Ok(index) => index,
            Err(error) => {
                missing.push(Some(error));
                continue;
            }
        };
        missing.push(None);
        // `da` and `da [deg]` are one column.
        if inputs.contains(&index) {
            return Err(refused(column, "twice"));
        }
        if selected.time.is_some_and(|time| time.index == index) {
            return Err(refused(column, "but it is the column of time"));
        }
        let heading = &headings[index];
        if let Some(reason) = &heading.fault {
            let message = format!("{:?} cannot be used: {reason}", heading.name);
            return Err(CommandError::InFile { file: file.to_owned(), message });
        }
        let sensors = &selected.sensors;
        let of_sensors = sensors.first().and_then(|sensor| headings[sensor.index].samples);
        if let (Some(first_samples), Some(second_samples)) = (of_sensors, heading.samples)
            && first_samples != second_samples
        {
            return Err(SelectionError::UnequalLengths {
                file: file.to_owned(),
                first: headings[sensors[0].index].name.clone(),
                first_samples,
                second: heading.name.clone(),
                second_samples,
            }
            .into());
        }
        inputs.push(index);
    }
    let is_input = |index: usize| inputs.contains(&index);
    if options.selection.outputs.is_empty() {
        selected.sensors.retain(|sensor| !is_input(sensor.index));
        if let (true, Some(column)) = (selected.sensors.is_empty(), options.known_inputs.first()) {
            return Err(refused(column, "and leaves no column for the sensors"));
        }
    } else if let Some(sensor) = selected.sensors.iter().find(|sensor| is_input(sensor.index)) {
        let why = "and --outputs, too; a column is an input or a sensor";
        return Err(refused(&headings[sensor.index].name, why));
    }
    for index in inputs {
        selected.sensors.push(wanted(file, headings, index, false)?);
    }
    Ok(missing)
}

fn fault(column: &str, why: &'static str) -> Result<(), CommandError> {
    Err(refused(column, why))
}

fn refused(column: &str, why: &'static str) -> CommandError {
    SelectionError::BadKnownInput { column: column.to_owned(), why }.into()
}
