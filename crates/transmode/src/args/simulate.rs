//! The command line of `transmode simulate`.

use std::path::PathBuf;

use clap::ValueEnum;

use crate::records::options::period;
use crate::simulate::{Noise, Sensor};

/// Makes records to try things on, and says what is true of them.
///
/// AIRCRAFT is a name in the catalog (`paper`), or a TOML or JSON file of stability derivatives and moments of inertia. Each record starts at rest and is a
/// file of its own, with a column of time and one for each sensor, that identify reads: by default aileron.csv and rudder.csv. A side file,
/// truth.json, holds what nobody knows of a real aircraft: its modes, its matrices, and the levels of the noise.
#[derive(Debug, clap::Args)]
#[command(after_help = SIMULATE_HELP)]
pub(crate) struct SimulateArgs {
    /// The aircraft: a name in the catalog, or a file (.toml, .json); with --inputs a result of identify --inputs .. --json.
    #[arg(value_name = "AIRCRAFT")]
    pub(crate) aircraft: String,

    /// A flight with the sensors and inputs of the model: what its sensors would read under its inputs is written as simulated.csv, and how well that fits is said.
    #[arg(long, value_name = "FLIGHT", conflicts_with_all = ["excitation", "surface", "amplitude", "duration", "sample_period", "outputs", "noise", "gust", "with_quiet", "seed"])]
    pub(crate) inputs: Option<PathBuf>,

    /// What moves the surfaces.
    #[arg(long, value_enum, default_value_t = ExcitationKind::White)]
    pub(crate) excitation: ExcitationKind,

    /// The surfaces that move: one of them, or both in one record [default: one record for each].
    #[arg(long, value_enum)]
    pub(crate) surface: Option<SurfaceChoice>,

    /// Deflection: standard deviation where it is random, otherwise the height of a step, in radians.
    #[arg(long, default_value_t = 0.05, value_name = "RADIANS", value_parser = positive, allow_negative_numbers = true)]
    pub(crate) amplitude: f64,

    /// Length of each record, in seconds.
    #[arg(long, default_value_t = 200.0, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    pub(crate) duration: f64,

    /// The time between two samples, in seconds.
    #[arg(long, default_value_t = 0.1, value_name = "SECONDS", value_parser = period, allow_negative_numbers = true)]
    pub(crate) sample_period: f64,

    /// The sensors, in that order: beta, p, r, phi.
    #[arg(long, value_delimiter = ',', value_name = "SENSOR,..", default_value = "beta,p,r", value_parser = Sensor::parse)]
    pub(crate) outputs: Vec<Sensor>,

    /// White noise of each sensor: snr=RATIO of standard deviations, that of the response as the mean over the records; or deviations, as beta=0.001,p=0.002, in rad and rad/s; or none.
    #[arg(long, default_value = "snr=100", value_name = "NOISE", value_parser = Noise::parse)]
    pub(crate) noise: Noise,

    /// Side gusts: standard deviation of their angle in radians, that is, of their speed over the airspeed.
    #[arg(long, default_value_t = 0.0, value_name = "SIGMA", value_parser = not_negative, allow_negative_numbers = true)]
    pub(crate) gust: f64,

    /// Another record in which nothing moves the surfaces: quiet.csv, gusts and noise alone.
    #[arg(long)]
    pub(crate) with_quiet: bool,

    /// The same seed gives the same files.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: u64,

    /// The folder for the files; it is made if it is not there.
    #[arg(short, long, default_value = ".", value_name = "DIR")]
    pub(crate) output: PathBuf,

    /// Replace files that are there.
    #[arg(long)]
    pub(crate) force: bool,
}

/// What moves the surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ExcitationKind {
    /// White Gaussian noise, held from sample to sample.
    White,
    /// A 3-2-1-1 every 15 s, its first step of 2.1 s to a side by chance.
    Multistep,
    /// A doublet of twice 1 s every 15 s, to a side by chance.
    Doublet,
    /// White Gaussian noise through a Butterworth filter of fourth order with its corner at 1 Hz, not held.
    Lowpass,
    /// Nothing: quiet.csv alone.
    None,
}

impl ExcitationKind {
    /// As it is written on a command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::White => "white",
            Self::Multistep => "multistep",
            Self::Doublet => "doublet",
            Self::Lowpass => "lowpass",
            Self::None => "none",
        }
    }
}

/// Which surfaces move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SurfaceChoice {
    /// The aileron alone.
    Aileron,
    /// The rudder alone.
    Rudder,
    /// Both at once, each on its own: what no two-sensor transmissibility can explain, and identify must doubt.
    Both,
}

fn seed(text: &str) -> Result<u64, String> {
    text.trim().parse().map_err(|_| format!("a seed is a whole number from 0 to {}", u64::MAX))
}

fn positive(text: &str) -> Result<f64, String> {
    super::values::positive(text).ok_or_else(|| "a positive number is needed".to_owned())
}

fn not_negative(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        _ => Err("a number that is not negative is needed".to_owned()),
    }
}

const SIMULATE_HELP: &str = "\
Examples:
  transmode simulate paper -o flights
  transmode simulate paper --excitation multistep --gust 0.005 --with-quiet --noise snr=30 --seed 7 -o flights
  transmode simulate modes.json --inputs flight.csv -o predicted
  transmode simulate trainer.toml --noise beta=0.001,p=0.002,r=0.001 --duration 300

Exit codes: 0 all files are written; 2 none is, and a sentence says why.";
