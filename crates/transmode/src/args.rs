//! The command line.

mod files;
mod fit;
mod inspect;
mod monitor;
mod pages;
mod simulate;

use std::path::PathBuf;

use clap::{Parser, Subcommand};

pub(crate) use files::FileArgs;
pub(crate) use fit::FitArgs;
pub(crate) use inspect::InspectArgs;
pub(crate) use monitor::MonitorArgs;
pub(crate) use pages::{CompletionsArgs, ManArgs};
pub(crate) use simulate::{ExcitationKind, SimulateArgs, SurfaceChoice};

/// Reconstructs the dynamics of a system from sensor records alone, without knowing what excited it.
#[derive(Debug, Parser)]
#[command(name = "transmode", version, arg_required_else_help = true, after_help = AFTER_HELP)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Show no progress, and no text on standard output where the result goes to files.
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,

    /// Colours of help and of messages; with auto they are used on a terminal, unless NO_COLOR is set.
    #[arg(long, global = true, value_enum, default_value_t = clap::ColorChoice::Auto, hide_possible_values = false, value_name = "WHEN")]
    pub(crate) color: clap::ColorChoice,
}

impl Command {
    /// Whether the result goes to files, so that standard output only repeats it.
    pub(crate) fn writes_files(&self) -> bool {
        let json = match self {
            Self::Identify(args) => &args.json,
            Self::Fit(args) => &args.json,
            Self::Inspect(args) => &args.json,
            Self::Monitor(args) => &args.json,
            Self::Simulate(_) | Self::Man(_) => return true,
            Self::Completions(_) => return false,
        };
        json.as_ref().is_some_and(|file| file.as_os_str() != "-")
    }
}

const AFTER_HELP: &str = "\
Exit codes: 0 all is well; 1 there is a result, but it cannot be trusted, and the warnings say why; 2 bad input.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Identify(IdentifyArgs),
    Fit(FitArgs),
    Inspect(InspectArgs),
    Simulate(SimulateArgs),
    Monitor(MonitorArgs),
    Completions(CompletionsArgs),
    Man(ManArgs),
}

/// Names the modes of a system from two or more records of its sensors.
///
/// Each file is one record, or each window of a file: a column of time and one column for each sensor, at least three; first the pseudo input,
/// then the pseudo outputs. Each record needs an excitation of its own: aileron in one, rudder in the other. Nobody needs to have measured it.
#[derive(Debug, clap::Args)]
#[command(after_help = IDENTIFY_HELP)]
pub(crate) struct IdentifyArgs {
    #[command(flatten)]
    pub(crate) files: FileArgs,

    /// Poles kept in the IIR factor of the composite model, l.
    #[arg(long, default_value_t = 4, value_name = "L", value_parser = order, allow_negative_numbers = true)]
    pub(crate) iir: usize,

    /// Causal length of the FIR factor in samples, r.
    #[arg(long, default_value_t = 25, value_name = "R", value_parser = order, allow_negative_numbers = true)]
    pub(crate) causal: usize,

    /// Anticausal length of the FIR factor in samples, d.
    #[arg(long, default_value_t = 25, value_name = "D", value_parser = order, allow_negative_numbers = true)]
    pub(crate) anticausal: usize,

    /// Write the result as JSON to this file, or to standard output in place of the table with -.
    #[arg(long, value_name = "FILE|-")]
    pub(crate) json: Option<PathBuf>,
}

/// An order of the composite model.
fn order(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("an order must be at least 1".to_owned()),
        Ok(order) => Ok(order),
        Err(_) => Err("an order is a whole number, at least 1".to_owned()),
    }
}

const IDENTIFY_HELP: &str = "\
Examples:
  transmode identify aileron.csv rudder.csv --outputs beta,p,r
  transmode identify aileron.csv rudder.csv --time clock --json modes.json
  transmode identify --window flight.mat:10:40 --window flight.mat:60:90 --outputs beta,p,r";
