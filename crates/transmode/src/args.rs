//! The command line.

mod files;
mod fit;
mod given;
mod identify;
mod inspect;
pub(crate) mod values;

use clap::{Parser, Subcommand};

pub(crate) use files::FileArgs;
pub(crate) use fit::FitArgs;
pub(crate) use given::Given;
pub(crate) use identify::IdentifyArgs;
pub(crate) use inspect::InspectArgs;

/// Reconstructs the dynamics of a system from sensor records alone, without knowing what excited it.
#[derive(Debug, Parser)]
#[command(name = "transmode", version, arg_required_else_help = true, after_help = AFTER_HELP)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const AFTER_HELP: &str = "\
Exit codes: 0 all is well; 1 there is a result, but it cannot be trusted, and the warnings say why; 2 bad input.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Identify(Box<Given<IdentifyArgs>>),
    Fit(FitArgs),
    Inspect(InspectArgs),
}
