//! `cargo xtask study`: what the methods are worth on many records.
//!
//! | file | what it does |
//! |---|---|
//! | `noise.rs`, `disturbance.rs` | the studies: what is varied, how records are made, what is asked of the methods, what is written |
//! | `campaign.rs`, `runs.rs` | from the command line through all runs to a page; what every study does alike |
//! | `signals.rs`, `readings.rs`, `modes.rs` | random signals; records with noise; the modes that a method is to find |
//! | `matching.rs`, `verdict.rs`, `averages.rs` | which eigenvalue stands for which mode, how far off it is, what many runs say |

mod averages;
mod campaign;
mod disturbance;
pub(crate) mod look;
mod matching;
pub(crate) mod modes;
pub(crate) mod noise;
mod readings;
mod runs;
mod signals;
pub(crate) mod verdict;

use std::io::Write;
use std::path::Path;

use clap::Subcommand;

pub(crate) use averages::median;
pub(crate) use runs::in_parallel;

use crate::TaskError;
use campaign::Extent;
use disturbance::DisturbanceStudy;
use noise::NoiseStudy;

/// Try the methods on many records.
#[derive(Debug, clap::Args)]
#[command(arg_required_else_help = true)]
pub(crate) struct Args {
    #[command(subcommand)]
    study: Study,
}

#[derive(Debug, Subcommand)]
enum Study {
    /// Errors, deviations and coverage of each method, for four excitations and four levels of noise.
    Noise(Extent),
    /// Errors, fit, coverage and doubts in gusts of four strengths, with and without a quiet record.
    Disturbance(Extent),
}

pub(crate) fn run(root: &Path, args: &Args, out: &mut dyn Write) -> Result<(), TaskError> {
    match &args.study {
        Study::Noise(extent) => campaign::carry_out(&NoiseStudy::new()?, root, extent, out),
        Study::Disturbance(extent) => {
            campaign::carry_out(&DisturbanceStudy::new()?, root, extent, out)
        }
    }
}
