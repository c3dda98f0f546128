//! `transmode simulate`: records to try things on, and what is true of them.

mod aircraft_file;
mod fault;
mod flights;
mod noise;
mod recorded;
mod sensor;
mod table;
mod truth;

use std::io::Write;
use std::path::Path;

use crate::args::SimulateArgs;
use crate::{CommandError, Exit, output};
pub(crate) use fault::SimulateError;
use flights::Simulator;
pub(crate) use noise::Noise;
pub(crate) use sensor::Sensor;

/// What is true of the records.
const TRUTH: &str = "truth.json";

/// Simulates the records and writes them, all or none.
pub(crate) fn run(args: &SimulateArgs, out: &mut dyn Write) -> Result<Exit, CommandError> {
    if let Some(flight) = &args.inputs {
        return recorded::run(args, flight, out);
    }
    let aircraft = aircraft_file::find(&args.aircraft)?;
    let simulator = Simulator::new(&aircraft, args)?;
    let names = simulator.names();
    let mut files: Vec<String> = names.iter().map(|name| format!("{name}.csv")).collect();
    files.push(TRUTH.to_owned());
    let overwrite =
        if args.force { output::Overwrite::Allowed } else { output::Overwrite::Refused };
    output::check_folder(&args.output, &files, overwrite)?;
    check_others(args, &files)?;

    let flown = simulator.fly()?;
    let mut contents: Vec<Vec<u8>> =
        flown.readings.iter().map(|readings| table::render(&simulator, readings)).collect();
    contents.push(truth::render(&simulator, &flown)?);
    let files: Vec<(String, Vec<u8>)> = files.into_iter().zip(contents).collect();
    output::write_folder(&args.output, &files, overwrite)?;

    let mut text = String::new();
    for (name, _) in &files {
        text += &format!("{}\n", args.output.join(name).display());
    }
    output::write_whole(Path::new("-"), text.as_bytes(), out)?;
    Ok(Exit::Fine)
}

/// Refuses to replace the truth of a record that stays.
fn check_others(args: &SimulateArgs, files: &[String]) -> Result<(), SimulateError> {
    let place = |name: &str| args.output.join(name);
    if !place(TRUTH).exists() {
        return Ok(());
    }
    let records = Simulator::all_names().map(|name| format!("{name}.csv"));
    let stays = |name: &String| !files.contains(name) && place(name).exists();
    match records.into_iter().find(stays) {
        Some(name) => Err(SimulateError::OtherSimulation { file: place(&name), truth: TRUTH }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests;
