//! The records of a case: the paper's aircraft, moved through the aileron in one record and through the rudder in the other, with noise.

use flight::{ContinuousNoise, FlightError, behind_low_pass};
use lti::{Discrete, StateSpace};
use nalgebra::DMatrix;
use reconstruct::{Record, SharedModel};

use super::case::{Case, Excitation};
use crate::TaskError;
use crate::reproduce::flight::sampled_aircraft;
use crate::study::modes::{TrueModes, told_apart};
use crate::study::readings::{SURFACES, noise_levels, noisy_record};
use crate::study::signals::{autoregressive, multistep, normal, stream};

const PART: &str = "records";

/// Corner of the band-limited excitation in rad/s: 1 Hz, beyond what a pilot does.
const CORNER_RAD_S: f64 = std::f64::consts::TAU;
/// Where the multistep begins.
const FIRST_STEP: usize = 10;

/// Two records, and the noise in them.
pub(crate) struct Pair {
    pub(crate) records: [Record; 2],
    /// Standard deviation of each sensor's noise, the same in both records.
    pub(crate) levels: Vec<f64>,
}

/// Makes records.
pub(crate) struct Simulator {
    discrete: StateSpace<Discrete>,
    /// For each surface, noise to sensors, through a low-pass filter in continuous time.
    filtered: Vec<ContinuousNoise>,
    modes: TrueModes,
}

impl Simulator {
    pub(crate) fn new() -> Result<Self, TaskError> {
        let aircraft = sampled_aircraft()?;
        let period = aircraft.discrete.period();
        let filtered = (0..SURFACES.len()).map(|surface| {
            let system = behind_low_pass(&aircraft.continuous, surface, CORNER_RAD_S)?;
            ContinuousNoise::new(&system, period)
        });
        let filtered =
            filtered.collect::<Result<_, FlightError>>().map_err(TaskError::computation(PART))?;
        let poles = aircraft.continuous.poles().map_err(TaskError::computation(PART))?;
        Ok(Self { discrete: aircraft.discrete, filtered, modes: told_apart(&poles)? })
    }

    pub(crate) fn modes(&self) -> TrueModes {
        self.modes
    }

    /// The system as the methods see it.
    pub(crate) fn truth(&self) -> SharedModel {
        let column = |surface| self.discrete.b().column(surface).into_owned();
        SharedModel {
            a: self.discrete.a().clone(),
            c: self.discrete.c().clone(),
            b: (0..SURFACES.len()).map(column).collect(),
            feedthrough: None,
            period: self.discrete.period(),
        }
    }

    /// The records of a case. Excitation and noise depend on its seed alone, so that records of one seed differ only in the size of the noise.
    pub(crate) fn fly(&self, case: &Case) -> Result<Pair, TaskError> {
        self.fly_at(case.excitation, f64::from(case.signal_to_noise), case.seed)
    }

    /// The same for any signal to noise ratio; infinity is no noise.
    pub(crate) fn fly_at(
        &self,
        excitation: Excitation,
        signal_to_noise: f64,
        seed: u64,
    ) -> Result<Pair, TaskError> {
        self.fly_samples(excitation, signal_to_noise, seed, excitation.samples())
    }

    /// The same for any number of samples.
    pub(crate) fn fly_samples(
        &self,
        excitation: Excitation,
        signal_to_noise: f64,
        seed: u64,
        samples: usize,
    ) -> Result<Pair, TaskError> {
        let clean = |surface| self.clean(excitation, samples, seed, surface);
        let clean = [clean(0)?, clean(1)?];
        let levels = noise_levels(&clean, signal_to_noise);
        let noisy = |surface: usize| {
            let mut random = stream(seed, 2 + surface as u64);
            let (name, period) = (SURFACES[surface], self.discrete.period());
            noisy_record(name, period, &clean[surface], &levels, &mut random)
        };
        Ok(Pair { records: [noisy(0)?, noisy(1)?], levels })
    }

    /// What the sensors would read without noise: one row each.
    fn clean(
        &self,
        excitation: Excitation,
        samples: usize,
        seed: u64,
        surface: usize,
    ) -> Result<DMatrix<f64>, TaskError> {
        let mut random = stream(seed, surface as u64);
        let input = match excitation {
            Excitation::White => normal(1, samples, &mut random),
            Excitation::Autoregressive => autoregressive(normal(1, samples, &mut random)),
            Excitation::Multistep => {
                let mut input = DMatrix::zeros(1, samples);
                multistep(&mut input, FIRST_STEP, 1.0);
                input
            }
            Excitation::BandLimited => {
                return self.filtered[surface]
                    .sampled(0, samples, &mut random)
                    .map_err(TaskError::computation(PART));
            }
        };
        let system = self
            .discrete
            .subsystem(&[0, 1, 2], &[surface])
            .map_err(TaskError::computation(PART))?;
        let simulation = system.simulate(&input, None).map_err(TaskError::computation(PART))?;
        Ok(simulation.outputs)
    }
}

#[cfg(test)]
mod tests;
