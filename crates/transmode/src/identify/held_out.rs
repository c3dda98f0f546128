//! `--validate`: records that the fit does not see.

use reconstruct::Record;

use super::input::{self, Input};
use crate::CommandError;
use crate::args::IdentifyArgs;
use crate::error::OptionError;
use crate::records::{self, LoadWarning, Loaded, Progress};

/// Records that the fit does not see.
#[derive(Debug, Default)]
pub(super) struct HeldOut {
    pub(super) records: Vec<Record>,
    /// For each record its inputs.
    pub(super) inputs: Vec<Vec<Vec<f64>>>,
    /// What was done to their files.
    pub(super) warnings: Vec<LoadWarning>,
}

/// Reads records that the fit does not see, with the sensors and inputs of the others.
pub(super) fn read(
    args: &IdentifyArgs,
    input: &Input,
    progress: Progress,
) -> Result<HeldOut, CommandError> {
    if args.validate.is_empty() {
        return Ok(HeldOut::default());
    }
    let mut options = args.files.options();
    options.windows.clear();
    options.bridge = input::bridge(args);
    options.most_missing = usize::MAX;
    options.decimate = input.decimation;
    options.inputs_may_be_missing = true;
    options.known_inputs = args.inputs.iter().map(|name| name.trim().to_owned()).collect();
    if let Some(record) = input.records.first() {
        let names = record.channels().iter().map(|channel| channel.name.clone());
        options.selection.outputs = names.collect();
    }
    let Loaded { records, known_inputs, mut warnings, .. } =
        records::load(&args.validate, &options, progress)?;
    for warning in &mut warnings {
        if let LoadWarning::Bridged { interpolated, .. } = warning {
            *interpolated = true;
        }
    }
    let same = |record: &Record| {
        let (own, other) = (record.period().seconds(), input.records[0].period().seconds());
        (own - other).abs() <= 1e-3 * other
    };
    if let Some(record) = records.iter().find(|record| !same(record)) {
        let message = format!(
            "{} is sampled every {} s, the other records every {} s; resample it",
            record.name(),
            record.period().seconds(),
            input.records[0].period().seconds()
        );
        return Err(OptionError::Refused { option: "--validate", message }.into());
    }
    Ok(HeldOut { records, inputs: known_inputs, warnings })
}
