//! The command line of `transmode fit`.

use std::path::PathBuf;

use super::files::{ReadArgs, TimeArgs};
use crate::records::options::period;
use crate::records::pair::PairOptions;
use crate::records::selection::TimeSource;

/// Identifies the transmissibility from one sensor to another.
///
/// The model is a noncausal composite of a finite and an infinite impulse response: D(q) y_o(k) = sum of h_i y_i(k - i), i from -d to r. FILE
/// is any that identify reads; an NPY file (.npy) with a 2-D array of floats, samples x channels; or raw little-endian doubles (.f64), one sample
/// of all channels after another. NPY and raw files may have any length: they are read once, in blocks. A NaN marks a gap, across which no
/// equation reaches.
#[derive(Debug, clap::Args)]
#[command(after_help = FIT_HELP)]
pub(crate) struct FitArgs {
    /// The record.
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,

    /// The pseudo input: a column's name, or its index from 0 in NPY and raw files.
    #[arg(long, value_name = "COLUMN")]
    pub(crate) input: String,

    /// The pseudo output: a column's name, or its index from 0 in NPY and raw files.
    #[arg(long, value_name = "COLUMN")]
    pub(crate) output: String,

    /// Number of channels in a file of raw doubles.
    #[arg(long, value_name = "C", value_parser = channels, allow_negative_numbers = true)]
    pub(crate) channels: Option<u64>,

    #[command(flatten)]
    pub(crate) time: TimeArgs,

    #[command(flatten)]
    pub(crate) reading: ReadArgs,

    /// Interpolate to a sample every so many seconds, if not of an NPY or raw file.
    #[arg(long, value_name = "SECONDS", value_parser = period, allow_negative_numbers = true)]
    pub(crate) resample: Option<f64>,

    /// Poles kept in the IIR factor of the model, l.
    #[arg(long, default_value_t = 4, value_name = "L", value_parser = order, allow_negative_numbers = true)]
    pub(crate) iir: usize,

    /// Causal length of the FIR factor in samples, r.
    #[arg(long, default_value_t = 25, value_name = "R", value_parser = order, allow_negative_numbers = true)]
    pub(crate) causal: usize,

    /// Anticausal length of the FIR factor in samples, d.
    #[arg(long, default_value_t = 25, value_name = "D", value_parser = order, allow_negative_numbers = true)]
    pub(crate) anticausal: usize,

    /// Give D(q) a constant term, so that none of its L roots is fixed at zero.
    #[arg(long)]
    pub(crate) constant_term: bool,

    /// Threads that sum [default: one for each processor]. The result does not depend on it.
    #[arg(long, value_name = "N", value_parser = super::values::threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<usize>,

    /// Write the result as JSON to this file, or to standard output in place of the text with -.
    #[arg(long, value_name = "FILE|-")]
    pub(crate) json: Option<PathBuf>,
}

impl FitArgs {
    /// How the two sensors are read.
    pub(crate) fn pair_options(&self) -> PairOptions {
        let time = match self.time.source() {
            TimeSource::Usual => TimeSource::UsualOrUnknown,
            asked => asked,
        };
        PairOptions { time, reading: self.reading.options(), resample_s: self.resample }
    }

    /// Whether an option says where times come from, which arrays that are streamed do not have.
    pub(crate) fn names_time(&self) -> bool {
        self.time.column.is_some() || self.time.sample_period.is_some() || self.resample.is_some()
    }
}

/// An order of the model, which may be zero here.
pub(super) fn order(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "an order is a whole number, at least 0".to_owned())
}

fn channels(text: &str) -> Result<u64, String> {
    let found = text.trim().parse().ok().filter(|channels| *channels > 0);
    found.ok_or_else(|| "a number of channels is a whole number, at least 1".to_owned())
}

const FIT_HELP: &str = "\
Examples:
  transmode fit flight.csv --input beta --output p
  transmode fit flight.npy --input 0 --output 1 --iir 3 --constant-term
  transmode fit flight.f64 --channels 3 --input 0 --output 2 --json fit.json

Exit codes: 0 all is well; 1 the parameters cannot be trusted (rank deficient, or rounding too large); 2 bad input.";
