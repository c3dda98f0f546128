//! The command line.

mod files;
mod fit;
mod given;
mod identify;
mod inspect;
mod monitor;
mod simulate;
pub(crate) mod values;

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use clap_complete::Shell;

pub(crate) use fit::FitArgs;
pub(crate) use given::Given;
pub(crate) use identify::IdentifyArgs;
pub(crate) use inspect::InspectArgs;
pub(crate) use monitor::MonitorArgs;
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
            // A file of options may hold more, so it looks itself.
            Self::Identify(_) | Self::Completions(_) => return false,
            Self::Fit(args) => &args.json,
            Self::Inspect(args) => &args.json,
            Self::Monitor(args) => &args.json,
            Self::Simulate(_) | Self::Man(_) => return true,
        };
        json.as_ref().is_some_and(|file| file.as_os_str() != "-")
    }
}

const AFTER_HELP: &str = "\
Exit codes: 0 all is well; 1 there is a result, but it cannot be trusted, and the warnings say why; 2 bad input.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Identify(Box<Given<IdentifyArgs>>),
    Fit(FitArgs),
    Inspect(InspectArgs),
    Simulate(SimulateArgs),
    Monitor(MonitorArgs),
    Completions(CompletionsArgs),
    Man(ManArgs),
}

/// Writes what a shell needs to complete this program's words.
///
/// For bash: transmode completions bash > ~/.local/share/bash-completion/completions/transmode
#[derive(Debug, clap::Args)]
pub(crate) struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub(crate) shell: Shell,
}

/// Writes the manual pages, one for the program and one for each command.
#[derive(Debug, clap::Args)]
pub(crate) struct ManArgs {
    /// The folder for the pages; it is made if it is not there. Pages that are there are replaced.
    #[arg(short, long, default_value = ".", value_name = "DIR")]
    pub(crate) output: PathBuf,
}
