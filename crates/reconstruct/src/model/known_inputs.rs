//! Are recorded inputs fit for their records?

use crate::{ReconstructError, Record};

/// Refuses inputs that do not fit the records: for each record a list of signals as long as the record, finite and not zero throughout.
pub(crate) fn check_known_inputs(
    records: &[Record],
    inputs: &[Vec<Vec<f64>>],
) -> Result<(), ReconstructError> {
    if !inputs.is_empty() && inputs.len() != records.len() {
        return Err(option(format!("lists for {} of {} records", inputs.len(), records.len())));
    }
    for (record, list) in records.iter().zip(inputs) {
        for input in list {
            if input.len() != record.samples() {
                return Err(option(format!(
                    "record {:?} has {} samples, an input of it {}",
                    record.name(),
                    record.samples(),
                    input.len()
                )));
            }
            if input.iter().any(|value| !value.is_finite())
                || input.iter().all(|&v| v.abs() < f64::MIN_POSITIVE)
            {
                return Err(option(format!(
                    "an input of record {:?} is not finite or zero throughout",
                    record.name()
                )));
            }
        }
    }
    Ok(())
}

fn option(message: String) -> ReconstructError {
    ReconstructError::Option { name: "known inputs", message }
}
