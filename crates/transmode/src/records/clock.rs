//! Where a record's sample period comes from, for the result.

use std::fmt;

use super::clock_fit::Assumed;

/// How the times of the samples were had.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock {
    pub(crate) basis: Basis,
    /// The least-squares period of the stamps; `None` where there are none, or too few.
    pub(crate) fitted_period_s: Option<f64>,
    /// The largest distance of a stamp from that line.
    pub(crate) largest_deviation_s: Option<f64>,
}

/// What is assumed of the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Basis {
    /// The stamps advance in equal steps.
    EvenStamps,
    /// Even rows, with stamps that are rounded to this many seconds.
    RoundedStamps { resolution_s: f64 },
    /// Even rows, with stamps that are early or late.
    ScatteredStamps,
    /// Even rows, as the sample period of the command line says.
    Given,
    /// Interpolated to this period from the stamps as they are.
    Resampled,
}

impl Clock {
    /// Of a period that was given.
    pub(crate) const GIVEN: Self =
        Self { basis: Basis::Given, fitted_period_s: None, largest_deviation_s: None };

    /// Of samples that were interpolated.
    pub(crate) const RESAMPLED: Self =
        Self { basis: Basis::Resampled, fitted_period_s: None, largest_deviation_s: None };

    /// A word for other programs.
    pub(crate) fn word(self) -> &'static str {
        match self.basis {
            Basis::EvenStamps => "even-stamps",
            Basis::RoundedStamps { .. } => "rounded-stamps",
            Basis::ScatteredStamps => "scattered-stamps",
            Basis::Given => "sample-period",
            Basis::Resampled => "resampled",
        }
    }
}

impl From<Assumed> for Basis {
    fn from(assumed: Assumed) -> Self {
        match assumed {
            Assumed::Rounded { resolution_s } => Self::RoundedStamps { resolution_s },
            Assumed::Scattered => Self::ScatteredStamps,
        }
    }
}

impl fmt::Display for Clock {
    /// What was assumed, as part of a sentence.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.basis {
            Basis::EvenStamps => f.write_str("stamps in equal steps"),
            Basis::RoundedStamps { resolution_s } => {
                write!(f, "evenly spaced rows, stamps rounded to {resolution_s} s")
            }
            Basis::ScatteredStamps => f.write_str("evenly spaced rows, stamps early or late"),
            Basis::Given => f.write_str("the sample period given"),
            Basis::Resampled => f.write_str("interpolated to equal steps"),
        }
    }
}
