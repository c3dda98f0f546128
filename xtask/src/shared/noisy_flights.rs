//! Flights with noisy sensors: the paper's aircraft, moved through the aileron in one record and
//! through the rudder in the other.

use flight::{
    ContinuousNoise, FlightError, Stream, add_multistep, autoregressive, behind_low_pass, normal,
};
use nalgebra::DMatrix;
use reconstruct::Record;
use serde::{Deserialize, Serialize};

use super::paper_aircraft::{PaperAircraft, SURFACES, noise_levels};
use crate::TaskError;

const PART: &str = "records";
/// Corner of the band-limited excitation in rad/s: 1 Hz, beyond what a pilot does.
const CORNER_RAD_S: f64 = std::f64::consts::TAU;
/// Samples of a multistep's single step: 0.7 s.
pub(crate) const STEP: usize = 7;
/// Where the multistep begins.
const FIRST_STEP: usize = 10;

/// How the surface moves. Every record is of the paper's aircraft, sampled at 10 Hz.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Excitation {
    /// White Gaussian noise, held between samples.
    White,
    /// u(k+1) = 0.9 u(k) + white Gaussian noise, held between samples.
    Autoregressive,
    /// Gaussian noise below 1 Hz that moves on between samples.
    BandLimited,
    /// Steps of 3, 2, 1 and 1 times 0.7 s to alternating sides, the same in every record.
    Multistep,
}

impl Excitation {
    pub(crate) const ALL: [Self; 4] =
        [Self::White, Self::Autoregressive, Self::BandLimited, Self::Multistep];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::White => "white",
            Self::Autoregressive => "AR(1), 0.9",
            Self::BandLimited => "band-limited",
            Self::Multistep => "3-2-1-1",
        }
    }

    /// Samples of each record: 200 s, or 30 s of a multistep.
    pub(crate) fn samples(self) -> usize {
        match self {
            Self::White | Self::Autoregressive | Self::BandLimited => 2000,
            Self::Multistep => 300,
        }
    }
}

/// Two records, and the noise in them.
pub(crate) struct Pair {
    pub(crate) records: [Record; 2],
    /// Standard deviation of each sensor's noise, the same in both records.
    pub(crate) levels: Vec<f64>,
}

/// Makes records.
pub(crate) struct Simulator {
    pub(crate) aircraft: PaperAircraft,
    /// For each surface, noise to sensors, through a low-pass filter in continuous time.
    filtered: Vec<ContinuousNoise>,
}

impl Simulator {
    pub(crate) fn new() -> Result<Self, TaskError> {
        let aircraft = PaperAircraft::new()?;
        let filtered = (0..SURFACES.len()).map(|surface| {
            let system = behind_low_pass(&aircraft.continuous, surface, CORNER_RAD_S)?;
            ContinuousNoise::new(&system, aircraft.period())
        });
        let filtered =
            filtered.collect::<Result<_, FlightError>>().map_err(TaskError::computation(PART))?;
        Ok(Self { aircraft, filtered })
    }

    /// Two records with this signal to noise ratio; infinity is no noise. Excitation and noise
    /// depend on the seed alone, so that records of one seed differ only in the size of the noise.
    pub(crate) fn fly(
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
            let mut random = Stream::new(seed, 2 + surface as u64);
            let y = &clean[surface];
            self.aircraft.noisy_record(SURFACES[surface], y, &levels, &mut random)
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
        let mut random = Stream::new(seed, surface as u64);
        let input = match excitation {
            Excitation::White => normal(1, samples, &mut random),
            Excitation::Autoregressive => autoregressive(normal(1, samples, &mut random)),
            Excitation::Multistep => {
                let mut input = DMatrix::zeros(1, samples);
                add_multistep(&mut input, FIRST_STEP, STEP, 1.0);
                input
            }
            Excitation::BandLimited => {
                return self.filtered[surface]
                    .sampled(0, samples, &mut random)
                    .map_err(TaskError::computation(PART));
            }
        };
        self.aircraft.response(surface, &input)
    }
}

#[cfg(test)]
mod tests;
