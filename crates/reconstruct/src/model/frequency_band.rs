//! The frequencies that a fit uses, and how far up they reach where nobody says.

use std::f64::consts::{PI, TAU};

use lti::SamplePeriod;

use crate::Record;

/// Angular frequencies from `lowest_rad_s` to `highest_rad_s`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyBand {
    /// Lower end in rad/s.
    pub lowest_rad_s: f64,
    /// Upper end in rad/s.
    pub highest_rad_s: f64,
}

/// The part of the Nyquist frequency that the choice among orders and forms uses.
const FIRST_BAND: f64 = 0.25;
/// The band reaches so many times as high as the fastest mode, but never beyond this part of the Nyquist frequency.
const TIMES_THE_FASTEST: f64 = 10.0;
const LARGEST_BAND: f64 = 0.7;
/// A band that differs from the first one by less than this factor is not worth another fit.
const SAME_BAND: f64 = 1.25;

impl FrequencyBand {
    /// For the choice among orders and forms, before the modes are known.
    pub(crate) fn before_the_modes(period: SamplePeriod) -> Self {
        Self { lowest_rad_s: 0.0, highest_rad_s: FIRST_BAND * PI / period.seconds() }
    }

    /// For a system whose fastest mode has this size |s| in rad/s; `None` where that is nearly this one.
    pub(crate) fn reaching_beyond(self, fastest: f64, period: SamplePeriod) -> Option<Self> {
        let largest = LARGEST_BAND * PI / period.seconds();
        let highest = (TIMES_THE_FASTEST * fastest).min(largest);
        let same = (1.0 / SAME_BAND..SAME_BAND).contains(&(highest / self.highest_rad_s));
        (!same).then_some(Self { highest_rad_s: highest, ..self })
    }

    /// Whether a frequency that the transform of a record has is in the band: k steps of 2 pi / (N T).
    pub(crate) fn holds(&self, k: usize, record: &Record) -> bool {
        let step = TAU / (record.samples() as f64 * record.period().seconds());
        let frequency = step * k as f64;
        // Half a millionth of a step, so that a limit meant to be a frequency of the transform is one.
        let slack = 5e-7 * step;
        frequency >= self.lowest_rad_s - slack && frequency <= self.highest_rad_s + slack
    }
}

#[cfg(test)]
mod tests;
