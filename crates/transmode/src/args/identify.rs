//! The command line of `transmode identify`.

use std::path::PathBuf;

use aircraft::{AircraftClass, FlightPhaseCategory};
use clap::ValueHint;

use super::files::FileArgs;
use super::values::{
    Band, ExcitationAsked, HoldAsked, LagAsked, MethodName, OffsetsAsked, OrderAsked, QuietFile,
    StructureAsked, level, order, threads,
};
use crate::records::options::bridge;

/// Names the modes of a system from two or more records of its sensors.
///
/// Each file is one record, or each window of a file: a column of time and one column for each sensor, at least three (or two, with three records).
/// Each record needs an excitation of its own: aileron in one, rudder in the other. Nobody needs to have measured it; where it was (--inputs), one record is enough. Numbers are converted to SI with
/// angles in radians where a file states units, and options in the sensors' units are in those.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct IdentifyArgs {
    #[command(flatten)]
    pub(crate) files: FileArgs,

    /// Gaps of up to so many seconds are missing samples inside one record, longer ones split it; 0 splits at each
    /// [default: three samples, or a quarter of a second where that is more, up to 25 samples].
    #[arg(long, value_name = "SECONDS", value_parser = bridge, allow_negative_numbers = true)]
    pub(crate) bridge: Option<f64>,

    /// How to find the modes [default: ml].
    #[arg(long, value_enum, value_name = "METHOD")]
    pub(crate) method: Option<MethodName>,

    /// The number of states, or auto to see it from the records [default: auto].
    #[arg(long, value_name = "N|auto", allow_negative_numbers = true)]
    pub(crate) order: Option<OrderAsked>,

    /// What sensors read in trim: zero, free (anything), or zero within these standard deviations, one for all sensors or one for each
    /// [default: auto, zero unless the records say otherwise].
    #[arg(long, value_name = "auto|zero|free|DEVIATION,..", allow_hyphen_values = true)]
    pub(crate) offsets: Option<OffsetsAsked>,

    /// Each sensor drifts by a constant rate in each record [default: where the records call for it].
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true", value_name = "true|false")]
    pub(crate) trend: Option<bool>,

    /// How the excitation moves between samples: it is held, as a digital controller does, or moves on straight, as a pilot's hand nearly does
    /// [default: auto, what is more likely].
    #[arg(long, value_enum, value_name = "HOLD")]
    pub(crate) hold: Option<HoldAsked>,

    /// Use only these frequencies, in rad/s; either end may be left out [default: all; with --decimate up to 0.8 of the new Nyquist frequency].
    #[arg(long, value_name = "LO:HI", allow_hyphen_values = true)]
    pub(crate) band: Option<Band>,

    /// Sensors that read the excitation directly, as accelerometers do.
    #[arg(long, value_delimiter = ',', value_name = "COLUMN,..")]
    pub(crate) feedthrough: Vec<String>,

    /// Standard deviation of each sensor's noise, in its unit and in the order of the sensors [default: estimated from the records].
    #[arg(long, value_delimiter = ',', value_name = "LEVEL,..", value_parser = level, allow_hyphen_values = true)]
    pub(crate) noise: Vec<f64>,

    /// White noise alone, without the relative model error that flights show: for simulations of linear systems.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true", value_name = "true|false", conflicts_with_all = ["noise", "noise_record"])]
    pub(crate) white_noise: Option<bool>,

    /// A record of the same sensors while nobody moved anything on purpose: its noise, of any colour, is that of the records.
    #[arg(long, value_name = "FILE[:START:END]", value_hint = ValueHint::FilePath, conflicts_with = "noise")]
    pub(crate) noise_record: Option<QuietFile>,

    /// Columns that hold recorded inputs: control surfaces, a yaw damper's output. A file without one of them is one in which it did not move.
    #[arg(long, value_delimiter = ',', value_name = "COLUMN,..", alias = "known-input")]
    pub(crate) inputs: Vec<String>,

    /// Whether something that was not recorded may have excited the system as well, with --inputs
    /// [default: auto, only if the inputs leave too much unexplained].
    #[arg(long, value_enum, value_name = "yes|no|auto", requires = "inputs")]
    pub(crate) unknown_excitation: Option<ExcitationAsked>,

    /// The form of the equations: a system with all entries of its matrices free, or the lateral equations of an aircraft with their derivatives, for sensors
    /// beta, p, r and phi [default: auto, what is more likely].
    #[arg(long, value_enum, value_name = "FORM")]
    pub(crate) structure: Option<StructureAsked>,

    /// A sensor or an input that is late, with --inputs: by so many seconds, or by a lag that is estimated. May be given several times.
    #[arg(
        long,
        value_name = "COLUMN=SECONDS|free",
        requires = "inputs",
        allow_hyphen_values = true
    )]
    pub(crate) lag: Vec<LagAsked>,

    /// A TOML or JSON file with the size, mass and inertia of the aircraft, tables geometry and inertia: derivatives are given in nondimensional form, too.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "inputs")]
    pub(crate) aircraft: Option<PathBuf>,

    /// A record that the fit does not see, with the same columns: how well the model predicts it is said. May be given several times.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "inputs")]
    pub(crate) validate: Vec<PathBuf>,

    /// Class of the aircraft after MIL-F-8785C, for flying-quality levels: I, II-L, II-C, III or IV.
    #[arg(long, value_name = "CLASS", requires = "flight_phase")]
    pub(crate) aircraft_class: Option<AircraftClass>,

    /// Category of the flight phase after MIL-F-8785C, for flying-quality levels: A-CO, A, B or C.
    #[arg(long, value_name = "CATEGORY", requires = "aircraft_class")]
    pub(crate) flight_phase: Option<FlightPhaseCategory>,

    /// As printed: poles kept in the IIR factor of the composite model, l [default: 4].
    #[arg(long, value_name = "L", value_parser = order, allow_negative_numbers = true)]
    pub(crate) iir: Option<usize>,

    /// As printed: causal length of the FIR factor in samples, r [default: 25].
    #[arg(long, value_name = "R", value_parser = order, allow_negative_numbers = true)]
    pub(crate) causal: Option<usize>,

    /// As printed: anticausal length of the FIR factor in samples, d [default: 25].
    #[arg(long, value_name = "D", value_parser = order, allow_negative_numbers = true)]
    pub(crate) anticausal: Option<usize>,

    /// Threads for long records, for the method ml [default: one for each processor]. The result does not depend on it.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<usize>,

    /// Options from a TOML file, each by its long name, and files = [..]; lists are arrays. The command line wins.
    #[arg(long, value_name = "run.toml")]
    pub(crate) config: Option<PathBuf>,

    /// Write the result as JSON to this file, or to standard output in place of the table with -.
    #[arg(long, value_name = "FILE|-")]
    pub(crate) json: Option<PathBuf>,

    /// Write a page with figures that says what was found and why it can be trusted, report.html, and each figure as SVG and PNG into this folder;
    /// it is new, empty, or holds an older report, which is replaced.
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) report: Option<PathBuf>,
}

impl IdentifyArgs {
    /// The method asked for.
    pub(crate) fn method(&self) -> MethodName {
        self.method.unwrap_or_default()
    }
}

const HELP: &str = "\
Examples:
  transmode identify aileron.csv rudder.csv --outputs beta,p,r
  transmode identify aileron.csv rudder.csv --noise-record calm.csv --json modes.json
  transmode identify --window flight.mat:10:40 --window flight.mat:60:90 --outputs beta,p,r --offsets 0.002,0.005,0.005
  transmode identify flight.csv --outputs beta,p,r --inputs aileron,rudder --lag beta=free --validate other.csv
  transmode identify --config run.toml --order 4

run.toml:
  files = [\"aileron.csv\", \"rudder.csv\"]   # from the folder of run.toml on
  outputs = [\"beta\", \"p\", \"r\"]
  noise = [5e-4, 1e-3, 1e-3]

Exit codes: 0 all is well; 1 there are modes, but they cannot be trusted, and the warnings say why; 2 bad input.";
