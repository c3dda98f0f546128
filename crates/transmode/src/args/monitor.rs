//! The command line of `transmode monitor`.

use std::path::PathBuf;

use clap::ValueHint;

use super::files::FileArgs;
use crate::records::options::bridge;

/// Tells whether the sensors of new records still go together as those of a healthy one did.
///
/// The transmissibilities between the sensors are fitted to the first half of the reference, or are those that `transmode fit --json` wrote. Its second half says
/// what their residuals are usually like. Each span of a new record is then tested for jumps and for the spread of the residuals. The reference must have been
/// excited in the same way, through the same input: other excitation is an alarm too.
#[derive(Debug, clap::Args)]
#[command(after_help = MONITOR_HELP)]
pub(crate) struct MonitorArgs {
    #[command(flatten)]
    pub(crate) files: FileArgs,

    /// A record of healthy sensors.
    #[arg(long, required = true, value_name = "FILE")]
    pub(crate) reference: PathBuf,

    /// Transmissibilities that fit wrote, which are then not fitted to the reference; give it several times for several pairs.
    #[arg(long, value_name = "FIT.json", value_hint = ValueHint::FilePath, conflicts_with_all = ["iir", "causal", "anticausal"])]
    pub(crate) model: Vec<PathBuf>,

    /// Length of what is tested at once, in seconds [default: 50 samples].
    #[arg(long, value_name = "SECONDS", value_parser = span, allow_negative_numbers = true)]
    pub(crate) span: Option<f64>,

    /// Gaps of up to so many seconds are missing samples inside one record; longer ones split it [default: three samples, or 0.25 s where that is more].
    #[arg(long, value_name = "SECONDS", value_parser = bridge, allow_negative_numbers = true)]
    pub(crate) bridge: Option<f64>,

    /// The chance that one span of a healthy record raises an alarm; or how many in an hour, as 0.5/hour.
    #[arg(long, value_name = "RATE", default_value = "1e-3", value_parser = Rate::parse, allow_negative_numbers = true)]
    pub(crate) false_alarms: Rate,

    /// Poles kept in the IIR factor of the fitted models, l.
    #[arg(long, default_value_t = 4, value_name = "L", value_parser = super::fit::order, allow_negative_numbers = true)]
    pub(crate) iir: usize,

    /// Causal length of their FIR factor in samples, r.
    #[arg(long, default_value_t = 25, value_name = "R", value_parser = super::fit::order, allow_negative_numbers = true)]
    pub(crate) causal: usize,

    /// Anticausal length of their FIR factor in samples, d.
    #[arg(long, default_value_t = 25, value_name = "D", value_parser = super::fit::order, allow_negative_numbers = true)]
    pub(crate) anticausal: usize,

    /// Write the result as JSON to this file, or to standard output in place of the text with -.
    #[arg(long, value_name = "FILE|-")]
    pub(crate) json: Option<PathBuf>,
}

fn span(text: &str) -> Result<f64, String> {
    super::values::positive(text).ok_or_else(|| "a span is a positive number of seconds".to_owned())
}

/// A rate of false alarms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rate {
    /// Chance of one in a span.
    PerSpan(f64),
    /// Expected number in an hour.
    PerHour(f64),
}

impl Rate {
    /// Reads `1e-3`, `1e-3/span` or `0.5/hour`.
    fn parse(text: &str) -> Result<Self, String> {
        let (number, unit) = text.split_once('/').unwrap_or((text, "span"));
        let value: f64 = number
            .trim()
            .parse()
            .ok()
            .filter(|value: &f64| *value > 0.0 && value.is_finite())
            .ok_or_else(|| "a rate is a positive number, as 1e-3, or 0.5/hour".to_owned())?;
        match unit.trim() {
            "span" => Ok(Self::PerSpan(value)),
            "hour" => Ok(Self::PerHour(value)),
            other => Err(format!("{other:?} is neither span nor hour")),
        }
    }

    /// The chance in a span of so many seconds.
    pub(crate) fn per_span(self, span_s: f64) -> f64 {
        match self {
            Self::PerSpan(chance) => chance,
            Self::PerHour(number) => number * span_s / 3600.0,
        }
    }
}

const MONITOR_HELP: &str = "\
Examples:
  transmode monitor --reference healthy.csv today.csv --outputs beta,p,r
  transmode monitor --reference healthy.csv --model beta-to-p.json --false-alarms 0.5/hour today.csv --json alarms.json

Exit codes: 0 no alarm; 1 at least one alarm; 2 bad input.";
