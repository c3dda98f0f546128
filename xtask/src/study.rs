//! `cargo xtask study`: what the methods are worth on many records.

mod matching;
pub(crate) mod noise;
mod runs;

use std::io::Write;
use std::path::Path;

use clap::Subcommand;

pub(crate) use runs::in_parallel;

use crate::TaskError;
use noise::NoiseArgs;

/// Try the methods on many records.
#[derive(Debug, clap::Args)]
#[command(arg_required_else_help = true)]
pub(crate) struct Args {
    #[command(subcommand)]
    study: Study,
}

#[derive(Debug, Subcommand)]
enum Study {
    Noise(NoiseArgs),
}

pub(crate) fn run(root: &Path, args: &Args, out: &mut dyn Write) -> Result<(), TaskError> {
    match &args.study {
        Study::Noise(args) => noise::run(root, args, out),
    }
}

#[cfg(test)]
mod tests;
