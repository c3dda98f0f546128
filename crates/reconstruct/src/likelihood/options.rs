//! What the likelihood takes for granted about noise, offsets, trends, inputs and frequencies.

use crate::NoiseSpectrum;

/// The covariance of what the sensors read beside the response to the unknown excitation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LikelihoodNoise {
    /// White, independent between sensors, with known standard deviations in the sensors' units: one per sensor.
    Given(Vec<f64>),
    /// White, independent between sensors, with standard deviations that are estimated by restricted likelihood.
    Estimated {
        /// Where the search starts, in the sensors' units; `None` starts at 1 % of each sensor's root mean square.
        first_guess: Option<Vec<f64>>,
    },
    /// Any spectrum, one for each record, for example that of a [`VectorAutoregression`](crate::VectorAutoregression) fitted to a quiet record.
    Spectra(Vec<NoiseSpectrum>),
}

/// The constant that each sensor adds to its readings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Offsets {
    /// The sensors read zero in trim.
    Zero,
    /// Zero on average with these standard deviations, in the sensors' units: one per sensor, drawn anew for each record.
    PriorDeviation(Vec<f64>),
    /// Anything: frequency zero is left out. That costs the slow modes most of what the record says about them.
    Free,
}

/// Slow drift of the sensors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Trend {
    /// None.
    Absent,
    /// Each sensor drifts by an unknown constant rate in each record.
    Linear,
}

/// Where the direction of each record's excitation comes from before everything is fitted together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Directions {
    /// Estimated anew from the spectra with A and C held, and kept where that fits better than the start's.
    Reestimated,
    /// As the start has them.
    AsStarted,
}

/// How the excitation moves between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Hold {
    /// It stays what it was, as the output of a digital controller does.
    ZeroOrder,
    /// It moves on straight from sample to sample: close to anything that moves slowly beside the sampling, as a pilot's hand and a gust do.
    FirstOrder,
}

/// Angular frequencies from `lowest_rad_s` to `highest_rad_s`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyBand {
    /// Lower end in rad/s.
    pub lowest_rad_s: f64,
    /// Upper end in rad/s.
    pub highest_rad_s: f64,
}

/// How to maximise the likelihood.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LikelihoodOptions {
    /// The noise; by default white with estimated levels.
    pub noise: LikelihoodNoise,
    /// Sensor offsets; by default zero, since leaving frequency zero out multiplies the deviation of slow modes (by 30 for the roll mode
    /// of a 30 s record).
    pub offsets: Offsets,
    /// Drift of the sensors; by default absent.
    pub trend: Trend,
    /// The frequencies used; by default all.
    pub band: Option<FrequencyBand>,
    /// Indices of the sensors that read the excitation directly, as accelerometers do; by default none.
    pub feedthrough_sensors: Vec<usize>,
    /// Inputs that were recorded (a yaw damper's, say): for each record a list of signals with as many samples as the record. Empty where
    /// nothing was recorded. How they enter the state, and the sensors with feedthrough, is estimated for each record.
    pub known_inputs: Vec<Vec<Vec<f64>>>,
    /// How the excitation moves between samples; `None`, the default, takes what is more likely.
    pub hold: Option<Hold>,
    /// The directions of excitation before the joint fit; by default re-estimated.
    pub directions: Directions,
    /// The most steps of Levenberg-Marquardt between two updates of the noise levels. The default is 100: it needs about 5 from a good start.
    pub largest_steps: usize,
    /// The search ends where the next step would be shorter than this many standard deviations of the estimate. The default is 1e-3.
    pub step_tolerance: f64,
    /// The most rounds in which the slow real modes of the best top are moved elsewhere, each followed by a search; a round that leads no higher
    /// is the last. The default is 3; 0 trusts the starts.
    pub largest_moves: usize,
    /// The most updates of estimated noise levels; the default is 30: it needs about 5.
    pub largest_updates: usize,
    /// The levels are final where no variance changes by more than this part. The default is 1e-3, thirty times less than the
    /// uncertainty of a level after 2000 samples.
    pub level_tolerance: f64,
    /// How many threads sum over the frequencies of long records; the default is 1. The result does not depend on it.
    pub threads: usize,
}

impl Default for LikelihoodOptions {
    fn default() -> Self {
        Self {
            noise: LikelihoodNoise::Estimated { first_guess: None },
            offsets: Offsets::Zero,
            trend: Trend::Absent,
            band: None,
            feedthrough_sensors: Vec::new(),
            known_inputs: Vec::new(),
            hold: None,
            directions: Directions::Reestimated,
            largest_steps: 100,
            step_tolerance: 1e-3,
            largest_moves: 3,
            largest_updates: 30,
            level_tolerance: 1e-3,
            threads: 1,
        }
    }
}
