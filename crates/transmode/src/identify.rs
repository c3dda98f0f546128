//! `transmode identify`: records -> modes, on the terminal and as JSON.

mod coefficients;
mod config;
mod doubts;
mod held_out;
mod input;
mod json;
mod near_double;
mod options;
mod outcome;
mod refusal;
mod report_page;
mod text;

use std::io::Write;
use std::path::Path;

use reconstruct::output_error::{RecordedInputs, simulate};
use reconstruct::{Options, Reconstruction, reconstruct};

use crate::args::{Given, IdentifyArgs};
use crate::error::OptionError;
use crate::records::Progress;
use crate::{CommandError, Exit, modes, output};
use held_out::HeldOut;
use input::Input;
use outcome::{FlyingQualitiesCase, Outcome, Prediction};

/// Reads the records, reconstructs the modes and writes them.
pub(crate) fn run(
    given: &Given<IdentifyArgs>,
    typed: &str,
    progress: Progress,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    let args = config::complete(given)?;
    options::check_method(&args)?;
    if let (Some(file), Some(folder)) = (&args.json, &args.report)
        && output::is_within(file, folder)
    {
        let message = format!(
            "{} lies in the folder of --report, which is replaced as a whole; name another place",
            file.display()
        );
        return Err(OptionError::Refused { option: "--json", message }.into());
    }
    if let Some(file) = &args.json {
        let mut files = args.files.paths();
        files.extend(args.noise_record.iter().map(|file| file.path().as_path()));
        files.extend(args.config.as_deref());
        output::check_place(file, &files)?;
    }
    if let Some(folder) = &args.report {
        report_page::check_place(folder)?;
    }
    let read = input::read(&args, progress)?;
    let mut held_out = held_out::read(&args, &read, progress)?;
    let Input { records, sources, known_inputs, noise, decimation, causes, mut warnings } = read;
    warnings.append(&mut held_out.warnings);
    let noise_name = noise.as_ref().map(|record| record.name().to_owned());
    let options = options::options(&args, decimation, &records, noise, known_inputs)?;
    let searching = progress.work("searching for the modes");
    let mut result = reconstruct(&records, &options)
        .map_err(|error| refusal::sentence(&error, noise_name.as_deref()))?;
    drop(searching);
    result.doubts.retain(|doubt| !outcome::is_of_one_excitation(doubt, &records, &sources));
    let found = modes::name(&result, &records[0])?;
    let predictions = predictions(held_out, &options, &result)?;
    let case = args.aircraft_class.zip(args.flight_phase);
    let coefficients = match (&args.aircraft, result.output_error()) {
        (Some(file), Some(fit)) => coefficients::coefficients(file, fit)?,
        _ => Vec::new(),
    };
    let outcome = Outcome {
        command: typed,
        method: args.method(),
        records: &records,
        sources: &sources,
        options: &options,
        result: &result,
        found: &found,
        flying_qualities: case.map(|(class, phase)| FlyingQualitiesCase { class, phase }),
        warnings: &warnings,
        predictions: &predictions,
        coefficients: &coefficients,
        decimation,
        causes: &causes,
    };

    let drawn = match &args.report {
        Some(folder) => Some((folder, report_page::draw(&outcome, progress)?)),
        None => None,
    };
    let write_report = || match &drawn {
        Some((folder, files)) => report_page::replace(folder, files),
        None => Ok(()),
    };
    // Files first: if they cannot be written, nothing has been said yet.
    let standard_output = Path::new("-");
    match &args.json {
        Some(file) => output::write_with(file, &json::render(&outcome)?, out, write_report)?,
        None => output::uninterrupted(write_report)?,
    }
    let to_files = args.report.is_some() || args.json.is_some();
    let repeats = progress == Progress::Hidden && to_files;
    if args.json.as_deref() != Some(standard_output) && !repeats {
        output::write_whole(standard_output, text::render(&outcome).as_bytes(), out)?;
    }
    Ok(if result.doubts.is_empty() { Exit::Fine } else { Exit::Doubtful })
}

/// What the model makes of records that the fit did not see; an error where the result has no model with inputs.
fn predictions(
    HeldOut { records, inputs: signals, .. }: HeldOut,
    options: &Options,
    result: &Reconstruction,
) -> Result<Vec<Prediction>, CommandError> {
    if records.is_empty() {
        return Ok(Vec::new());
    }
    let Some(fit) = result.output_error() else {
        let message = "something that was not recorded excited the system as well, so that no record can be predicted; leave it out".to_owned();
        return Err(OptionError::Refused { option: "--validate", message }.into());
    };
    let inputs = RecordedInputs { names: options.inputs.names.clone(), signals };
    let all = simulate(&records, &inputs, &fit.into())
        .map_err(|error| refusal::sentence(&error, None))?;
    let together = records.into_iter().zip(all);
    Ok(together.map(|(record, simulation)| Prediction { record, simulation }).collect())
}
