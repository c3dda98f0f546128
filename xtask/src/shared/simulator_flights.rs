//! Flights of aircraft in a simulator that nobody of the project wrote, and the truth about them, as they are in the tree.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use flate2::read::GzDecoder;
use lti::SamplePeriod;
use num_complex::Complex;
use reconstruct::output_error::RecordedInputs;
use reconstruct::{Channel, Record};
use serde::Deserialize;

use super::modes::TrueModes;
use crate::TaskError;

const PART: &str = "tests/data/simulator";
const SURFACES: [&str; 2] = ["aileron", "rudder"];
/// The first columns; what the surfaces did may follow.
const COLUMNS: [&str; 4] = ["time", "beta", "p", "r"];

/// What is true of each aircraft, by name.
pub(crate) struct Truth(BTreeMap<String, TrueAircraft>);

/// One aircraft in trim.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct TrueAircraft {
    /// What is special about it.
    pub(crate) about: String,
    pub(crate) altitude_m: f64,
    pub(crate) true_airspeed_m_s: f64,
    roll: f64,
    /// Real and imaginary part.
    dutch_roll: [f64; 2],
    spiral: f64,
}

impl TrueAircraft {
    /// The eigenvalues of the simulator, linearised in trim.
    pub(crate) fn modes(&self) -> TrueModes {
        let [re, im] = self.dutch_roll;
        TrueModes {
            spiral: Complex::from(self.spiral),
            roll: Complex::from(self.roll),
            dutch_roll: Complex::new(re, im),
        }
    }
}

impl Truth {
    /// The truth beside the records.
    pub(crate) fn read(folder: &Path) -> Result<Self, TaskError> {
        let file = folder.join("truth.json");
        let text = std::fs::read_to_string(&file).map_err(|source| TaskError::io(&file, source))?;
        serde_json::from_str(&text).map(Self).map_err(TaskError::computation(PART))
    }

    pub(crate) fn of(&self, aircraft: &str) -> Result<&TrueAircraft, TaskError> {
        let missing = || fault(format!("truth.json knows no {aircraft}"));
        self.0.get(aircraft).ok_or_else(missing)
    }
}

/// A flight: its records, and what the surfaces did in them as far as the files hold it.
pub(crate) struct Flight {
    pub(crate) records: Vec<Record>,
    pub(crate) inputs: RecordedInputs,
}

/// Where the flights are.
pub(crate) fn folder() -> PathBuf {
    crate::root().join(PART)
}

/// The records moved through aileron and rudder, or through both at once.
pub(crate) fn read(folder: &Path, aircraft: &str, motion: &str) -> Result<Flight, TaskError> {
    let names: Vec<(&str, String)> = if motion == "both" {
        vec![("both", format!("{aircraft}_both.csv.gz"))]
    } else {
        let name = |surface| (surface, format!("{aircraft}_{surface}_{motion}.csv.gz"));
        SURFACES.map(name).to_vec()
    };
    let (mut records, mut signals) = (Vec::new(), Vec::new());
    for (surface, name) in names {
        let path = folder.join(&name);
        let mut text = String::new();
        File::open(&path)
            .and_then(|file| GzDecoder::new(file).read_to_string(&mut text))
            .map_err(|source| TaskError::io(&path, source))?;
        let (record, moved) =
            parse(surface, &text).map_err(|what| fault(format!("{name}: {what}")))?;
        records.push(record);
        signals.push(moved);
    }
    let names = SURFACES.map(|surface| format!("d_{surface}")).to_vec();
    Ok(Flight { records, inputs: RecordedInputs { names, signals } })
}

/// A record from its text, evenly sampled: sensors, and what aileron and rudder did; zero where the file does not say it.
fn parse(name: &str, text: &str) -> Result<(Record, Vec<Vec<f64>>), String> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    if header.get(..COLUMNS.len()) != Some(&COLUMNS[..]) {
        return Err(format!("the first columns must be {}", COLUMNS.join(",")));
    }
    let mut columns = vec![Vec::new(); header.len()];
    for (index, line) in lines.enumerate() {
        let bad = || format!("line {}: {line:?} is not {} numbers", index + 2, header.len());
        let numbers: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let row = numbers.ok().filter(|row| row.len() == header.len()).ok_or_else(bad)?;
        for (column, value) in columns.iter_mut().zip(row) {
            column.push(value);
        }
    }
    let period = period(&columns[0])?;
    let of_surface = |surface: &str| {
        let place = header.iter().position(|column| column.strip_prefix("d_") == Some(surface));
        place.map_or_else(|| vec![0.0; columns[0].len()], |place| columns[place].clone())
    };
    let moved = SURFACES.iter().map(|surface| of_surface(surface)).collect();
    let channels = (1..COLUMNS.len()).map(|k| Channel::new(COLUMNS[k], columns[k].clone()));
    let record =
        Record::new(name, period, channels.collect()).map_err(|error| error.to_string())?;
    Ok((record, moved))
}

/// The time between two samples, the same throughout.
fn period(time_s: &[f64]) -> Result<SamplePeriod, String> {
    /// Times are written with at least six digits, so that steps of 0.05 s in 120 s are off by less
    /// than this part of a step.
    const UNEVEN: f64 = 0.01;
    let [first, .., last] = time_s else {
        return Err("fewer than two samples".to_owned());
    };
    let step_s = (last - first) / (time_s.len() - 1) as f64;
    let uneven = |pair: &[f64]| ((pair[1] - pair[0]) / step_s - 1.0).abs() > UNEVEN;
    if let Some(index) = time_s.windows(2).position(uneven) {
        return Err(format!("line {}: a step other than {step_s} s", index + 3));
    }
    SamplePeriod::new(step_s).map_err(|error| error.to_string())
}

fn fault(message: String) -> TaskError {
    TaskError::Computation { part: PART, message }
}

#[cfg(test)]
mod tests;
