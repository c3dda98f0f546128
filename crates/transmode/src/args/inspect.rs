//! The command line of `transmode inspect`.

use std::path::PathBuf;

use super::files::{ReadArgs, TimeArgs, selection};
use crate::records::Selection;

/// Says what is in files before anything is made of them.
///
/// Channels, units, sampling and gaps; for each channel its range, outliers, stuck stretches and saturation; which columns look like sideslip,
/// roll rate and yaw rate, as a command line that is ready to use.
#[derive(Debug, clap::Args)]
#[command(after_help = INSPECT_HELP)]
pub(crate) struct InspectArgs {
    /// The files, in any format that identify reads.
    #[arg(required = true, num_args = 1.., value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// The channels to look at [default: all columns but time].
    #[arg(long, value_delimiter = ',', value_name = "COLUMN,..")]
    pub(crate) outputs: Vec<String>,

    #[command(flatten)]
    pub(crate) time: TimeArgs,

    #[command(flatten)]
    pub(crate) reading: ReadArgs,

    /// Write the result as JSON to this file, or to standard output in place of the text with -.
    #[arg(long, value_name = "FILE|-")]
    pub(crate) json: Option<PathBuf>,
}

impl InspectArgs {
    /// The columns that the words ask for.
    pub(crate) fn selection(&self) -> Selection {
        Selection { lenient: true, ..selection(&self.outputs, &self.time) }
    }
}

const INSPECT_HELP: &str = "\
Examples:
  transmode inspect flight.mat
  transmode inspect aileron.csv rudder.csv --json -

Exit codes: 0 nothing keeps the files from being used; 1 something does, and a line says what; 2 a file cannot be read.";
