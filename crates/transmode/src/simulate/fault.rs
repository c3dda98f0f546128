//! What can be wrong with a flight that is asked for.

use std::path::PathBuf;

/// Why a flight could not be simulated: one sentence with the remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// Neither a name in the catalog nor a file.
    #[error(
        "{text:?} is neither an aircraft of the catalog ({known}) nor a file; give one of them, or a TOML or JSON file"
    )]
    NoSuchAircraft {
        /// What was asked for.
        text: String,
        /// The names in the catalog.
        known: String,
    },
    /// Too short or too long a record.
    #[error(
        "{duration_s} s at a sample every {period_s} s are {samples} samples; {least} to {most} are possible: change --duration or --sample-period"
    )]
    Samples {
        /// The length asked for.
        duration_s: f64,
        /// The sample period.
        period_s: f64,
        /// How many samples that are.
        samples: f64,
        /// The fewest.
        least: usize,
        /// The most.
        most: usize,
    },
    /// A record of an earlier simulation, whose truth would be replaced.
    #[error(
        "{} is of an earlier simulation, whose {truth} would be replaced without it; remove it, or choose another folder with --output",
        file.display()
    )]
    OtherSimulation {
        /// The record.
        file: PathBuf,
        /// The file of its truth.
        truth: &'static str,
    },
    /// Surfaces that are to move although nothing moves them.
    #[error(
        "--excitation none moves no surface, so that {option} has no meaning; leave one of the two out"
    )]
    NothingMoves {
        /// The option.
        option: &'static str,
    },
    /// A ratio of signal to noise without a signal.
    #[error(
        "--noise snr={ratio} is a ratio to the response to the surfaces, and none moves; give the deviations, as --noise beta=0.001,p=0.002"
    )]
    NoSignal {
        /// The ratio.
        ratio: f64,
    },
    /// Noise of a sensor that is not there.
    #[error(
        "--noise gives {sensor}, which is not among the --outputs; leave it out, or add the sensor"
    )]
    NoSuchSensor {
        /// The sensor.
        sensor: &'static str,
    },
    /// A sensor asked for twice.
    #[error("--outputs names {sensor} twice; name each sensor once")]
    SensorTwice {
        /// The sensor.
        sensor: &'static str,
    },
    /// A system that cannot be sampled, or a motion that leaves the range of numbers.
    #[error(
        "the flight cannot be computed: {reason}; shorten --duration or --sample-period, or correct the aircraft"
    )]
    Computation {
        /// What the computation said.
        reason: String,
    },
}

impl SimulateError {
    pub(super) fn computation(error: &dyn std::error::Error) -> Self {
        Self::Computation { reason: error.to_string() }
    }
}
