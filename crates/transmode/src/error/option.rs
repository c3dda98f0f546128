//! What can be wrong with options, on the command line or in a file.

use std::path::PathBuf;

use crate::numbers::counted;

/// Why an option cannot be used: one sentence with its name and the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OptionError {
    /// A sensor that is a multiple of another one.
    #[error(
        "{copy:?} is {factor:.4} times {original:?} in all records, so that it says nothing of its own; leave it out of --outputs"
    )]
    Copy {
        /// The sensor.
        copy: String,
        /// The other one, which stands before it.
        original: String,
        /// Their ratio.
        factor: f64,
    },
    /// An option that another method has.
    #[error(
        "{option} belongs to --method {owner}, not to --method {method}; leave it out, or choose that method"
    )]
    OtherMethod {
        /// The option.
        option: &'static str,
        /// The methods that know it.
        owner: &'static str,
        /// The method asked for.
        method: &'static str,
    },
    /// Too many or too few numbers for the sensors.
    #[error("{option} has {} for {}; give one for each of {}", counted(*found as u64, "number"), counted(sensors.len() as u64, "sensor"), sensors.join(", "))]
    Count {
        /// The option.
        option: &'static str,
        /// How many numbers.
        found: usize,
        /// The sensors.
        sensors: Vec<String>,
    },
    /// A sensor that is none of the record's.
    #[error("{option} names {column:?}, which is none of the sensors {}; name one of them", sensors.join(", "))]
    NoSensor {
        /// The option.
        option: &'static str,
        /// What was asked for.
        column: String,
        /// The sensors.
        sensors: Vec<String>,
    },
    /// A sensor twice.
    #[error("{option} names {column:?} twice; name it once")]
    Twice {
        /// The option.
        option: &'static str,
        /// The sensor.
        column: String,
    },
    /// A band that reaches beyond what samples tell.
    #[error(
        "--band reaches {edge_rad_s} rad/s, above the Nyquist frequency of {nyquist_rad_s:.4} rad/s (pi over the sample period); \
         lower it, or leave that end out"
    )]
    BandTooHigh {
        /// The end that lies too high.
        edge_rad_s: f64,
        /// The highest frequency that the samples tell.
        nyquist_rad_s: f64,
    },
    /// A quiet record that is, or overlaps with, one of the records.
    #[error(
        "--noise-record: {noise} overlaps with the record {record}; nobody may have moved anything in it, so take another stretch or file"
    )]
    NoiseOverlaps {
        /// The quiet record.
        noise: String,
        /// The record.
        record: String,
    },
    /// A quiet record with too few samples.
    #[error(
        "--noise-record: {noise} has {found} samples, at least {needed} are needed, and several hundred are better; take a longer one"
    )]
    NoiseTooShort {
        /// The quiet record.
        noise: String,
        /// How many samples it has.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A measured input that says nothing.
    #[error(
        "--inputs: {column} is constant in {record}, {value} throughout, and tells nothing; leave it out"
    )]
    ConstantInput {
        /// The input.
        column: String,
        /// The record.
        record: String,
        /// What it reads.
        value: f64,
    },
    /// Records that have too few excitations between them.
    #[error(
        "{} of {}, but {needed} records are needed, each with an excitation of its own{}",
        counted(*found as u64, "record"), counted(*sensors as u64, "sensor"),
        split.as_ref().map_or_else(String::new, |record| format!(
            "; the stretches between the gaps of {record} count as one: where its excitation changes, cut it with --window"
        ))
    )]
    TooFewRecords {
        /// How many were given, those that gaps split counted once.
        found: usize,
        /// How many are needed.
        needed: usize,
        /// Number of sensors.
        sensors: usize,
        /// The first record that gaps split.
        split: Option<String>,
    },
    /// Sensors too few for any number of records.
    #[error("{}, but {needed} are needed; choose them with --outputs", counted(*sensors as u64, "sensor"))]
    TooFewSensors {
        /// How many were given.
        sensors: usize,
        /// How many are needed.
        needed: usize,
    },
    /// What a library says of an option's value.
    #[error("{option}: {message}")]
    Refused {
        /// The option.
        option: &'static str,
        /// What is wrong, with its numbers.
        message: String,
    },
    /// A file of options that cannot be read as such.
    #[error("{}, line {line}, column {column}: {message}", file.display())]
    Configuration {
        /// The file.
        file: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column in characters, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
}
