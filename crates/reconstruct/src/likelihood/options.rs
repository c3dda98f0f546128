//! What the likelihood assumes about noise, hold and frequencies, and how far its search goes.

use crate::Measurement;
use crate::model::{FrequencyBand, Hold, NoiseSpectrum};

/// The covariance of what the sensors read beside the response to the unknown excitation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Noise {
    /// White, independent between sensors, with known standard deviations in the sensors' units: one per sensor.
    Given(Vec<f64>),
    /// White, independent between sensors, with standard deviations that are estimated by restricted likelihood.
    Estimated {
        /// Where the search starts, in the sensors' units; `None` starts at 1 % of each sensor's root mean square.
        first_guess: Option<Vec<f64>>,
    },
    /// White noise of unknown levels s_i and, beside it, a relative model error: sensor i has the variance s_i^2 + eps^2 P_i at each frequency, P_i the smoothed
    /// periodogram of the sensor in that record. What a nonlinear system, its coupling into other motions or an input that is held in no textbook
    /// way leave unexplained follows the signal. Both are estimated by restricted likelihood, the levels not below 1e-3 of a sensor's root mean
    /// square and eps not below 1e-3.
    ModelError {
        /// Where the search for the levels starts, in the sensors' units; `None` starts at 1 % of each sensor's root mean square.
        first_guess: Option<Vec<f64>>,
    },
    /// Any spectrum, one for each record, for example that of a [`VectorAutoregression`](super::VectorAutoregression) fitted to a quiet record.
    Spectra(Vec<NoiseSpectrum>),
}

impl Noise {
    /// Whether its variances are estimated from the records.
    pub(crate) fn is_estimated(&self) -> bool {
        matches!(self, Self::Estimated { .. } | Self::ModelError { .. })
    }
}

/// Where the direction of each record's excitation comes from before everything is fitted together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InputDirections {
    /// Estimated anew from the spectra with A and C held, and kept where that fits better than the start's.
    Reestimated,
    /// As the start has them.
    AsStarted,
}

/// How to maximise the likelihood.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The noise; by default white with estimated levels.
    pub noise: Noise,
    /// Offsets, drift and feedthrough of the sensors, recorded inputs.
    pub measurement: Measurement,
    /// The frequencies used; by default all.
    pub band: Option<FrequencyBand>,
    /// How the excitation moves between samples; `None`, the default, takes what is more likely.
    pub hold: Option<Hold>,
    /// How far the search goes.
    pub search: SearchOptions,
    /// How many threads sum over the frequencies of long records; the default is 1. The result does not depend on it.
    pub threads: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            noise: Noise::Estimated { first_guess: None },
            measurement: Measurement::default(),
            band: None,
            hold: None,
            search: SearchOptions::default(),
            threads: 1,
        }
    }
}

/// How far the search for the largest likelihood goes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SearchOptions {
    /// The directions of excitation before the joint fit; by default re-estimated.
    pub directions: InputDirections,
    /// The most steps of Levenberg-Marquardt between two updates of the noise levels. The default is 100: it needs about 5 from a good start.
    pub max_steps: usize,
    /// The search ends where the next step would be shorter than this many standard errors of the estimate. The default is 1e-3.
    pub step_tolerance: f64,
    /// The most rounds of restarts in which the slow real modes of the best local optimum are moved elsewhere; a round that leads no lower
    /// is the last. The default is 3; 0 trusts the starts.
    pub max_restarts: usize,
    /// The most updates of estimated noise levels; the default is 30: it needs about 5.
    pub max_noise_updates: usize,
    /// The levels are final where no variance changes by more than this part. The default is 1e-3, thirty times less than the
    /// uncertainty of a level after 2000 samples.
    pub level_tolerance: f64,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self {
            directions: InputDirections::Reestimated,
            max_steps: 100,
            step_tolerance: 1e-3,
            max_restarts: 3,
            max_noise_updates: 30,
            level_tolerance: 1e-3,
        }
    }
}

impl SearchOptions {
    /// Those of a restart: it gets few steps, since slowly converging restarts never win.
    pub(crate) fn of_a_restart(&self) -> Self {
        const STEPS: usize = 40;
        const NOISE_UPDATES: usize = 5;
        self.at_most(STEPS, NOISE_UPDATES)
    }

    /// The same with no more steps and updates of the noise levels than these.
    pub(crate) fn at_most(&self, steps: usize, noise_updates: usize) -> Self {
        Self {
            max_steps: self.max_steps.min(steps),
            max_noise_updates: self.max_noise_updates.min(noise_updates),
            ..self.clone()
        }
    }

    /// The same with tolerances no smaller than these.
    pub(crate) fn no_finer_than(&self, step: f64, level: f64) -> Self {
        Self {
            step_tolerance: self.step_tolerance.max(step),
            level_tolerance: self.level_tolerance.max(level),
            ..self.clone()
        }
    }

    /// The same from the starts alone.
    pub(crate) fn without_restarts(&self) -> Self {
        Self { max_restarts: 0, ..self.clone() }
    }
}
