//! `cargo xtask study`: what the methods are worth on many records.
//!
//! | file | what it does |
//! |---|---|
//! | `noise.rs`, `disturbance.rs`, `simulator.rs` | the studies: what is varied, where records come from, what is asked of the methods, what is written |
//! | `definition.rs` | what a study provides |
//! | `campaign.rs`, `kept_runs.rs` | how a study gets from the command line through all runs to a page |
//! | `fit.rs`, `statistics.rs` | how far off one fit is and what it states about itself; what many say together |
//! | `sections.rs` | what the documents have in common: sections, tables, figures of errors and coverage |

mod campaign;
mod definition;
mod disturbance;
mod fit;
mod kept_runs;
mod noise;
mod sections;
mod simulator;
mod statistics;

use std::io::Write;
use std::path::Path;

use clap::Subcommand;

use crate::TaskError;
use campaign::{Extent, SeededExtent, carry_out};
use disturbance::DisturbanceStudy;
use noise::NoiseStudy;
use simulator::SimulatorStudy;

/// Try the methods on many records.
#[derive(Debug, clap::Args)]
#[command(arg_required_else_help = true)]
pub(crate) struct Args {
    #[command(subcommand)]
    study: Which,
}

#[derive(Debug, Subcommand)]
enum Which {
    /// Errors, deviations and coverage of each method, for four excitations and four levels of
    /// noise.
    Noise(SeededExtent),
    /// Errors, fit, coverage and doubts in gusts of four strengths, with and without a quiet
    /// record.
    Disturbance(SeededExtent),
    /// Errors, scores and doubts on flights of six aircraft in a nonlinear simulator, beside its
    /// linearised truth.
    Simulator(Extent),
}

pub(crate) fn run(root: &Path, args: &Args, out: &mut dyn Write) -> Result<(), TaskError> {
    match &args.study {
        Which::Noise(SeededExtent { seeds, extent }) => {
            carry_out::<NoiseStudy>(root, extent, *seeds, out)
        }
        Which::Disturbance(SeededExtent { seeds, extent }) => {
            carry_out::<DisturbanceStudy>(root, extent, *seeds, out)
        }
        Which::Simulator(extent) => carry_out::<SimulatorStudy>(root, extent, None, out),
    }
}
