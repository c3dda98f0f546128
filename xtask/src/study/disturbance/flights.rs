//! The flights of a case: one record moved through the aileron, one through the rudder, a quiet
//! one, all in the same turbulence.

use flight::{Stream, add_multistep, autoregressive, normal};
use nalgebra::DMatrix;
use reconstruct::Record;
use reconstruct::likelihood::NoiseSpectrum;

use super::kind::{Excitation, Kind};
use super::turbulence::Turbulence;
use crate::TaskError;
use crate::shared::noisy_flights::STEP;
use crate::shared::paper_aircraft::{PaperAircraft, SENSORS, SURFACES, noise_levels};

/// Samples of each record: 180 s.
pub(super) const SAMPLES: usize = 1800;
/// Root mean square of each sensor's response to the controls over that of its noise.
pub(super) const SIGNAL_TO_NOISE: f64 = 100.0;
/// Samples between the beginnings of two multisteps, and before the first.
const MULTISTEP_EVERY: usize = 150;
const FIRST_MULTISTEP: usize = 10;

/// Three records and what is true of them.
pub(crate) struct Flight {
    /// Aileron, rudder.
    pub(crate) records: [Record; 2],
    /// Nobody moves the controls.
    pub(crate) quiet: Record,
    /// What the controls did in the two records, which no method but the one for comparison is
    /// told.
    pub(crate) controls: [DMatrix<f64>; 2],
    /// Standard deviation of each sensor's white noise.
    pub(crate) levels: Vec<f64>,
    /// The true spectrum of gusts and noise.
    pub(crate) spectrum: NoiseSpectrum,
}

/// Makes flights.
pub(crate) struct Simulator {
    pub(crate) aircraft: PaperAircraft,
    turbulence: Turbulence,
}

impl Simulator {
    pub(crate) fn new() -> Result<Self, TaskError> {
        let aircraft = PaperAircraft::new()?;
        let turbulence = Turbulence::new(&aircraft.continuous, aircraft.period())?;
        Ok(Self { aircraft, turbulence })
    }

    /// The records of one run. Controls, gusts and noise depend on the seed alone, so that records
    /// of one seed differ only in the strength of the gusts.
    pub(crate) fn fly(&self, kind: Kind, seed: u64) -> Result<Flight, TaskError> {
        let strength = f64::from(kind.gust_percent) / 100.0;
        let gusts = (0..3)
            .map(|record| self.turbulence.motion(SAMPLES, &mut Stream::new(seed, 5 + record)));
        let gusts = gusts.collect::<Result<Vec<_>, _>>()?;
        let typical = deviations(&gusts);
        let (mut controls, mut responses) = (Vec::new(), Vec::new());
        for surface in 0..SURFACES.len() {
            let input = controls_of(kind.excitation, seed, surface);
            let response = self.aircraft.response(surface, &input)?;
            // With this the gusts' motion of unit strength is as large as the response.
            let factor = size_ratio(&typical, &deviations(std::slice::from_ref(&response)));
            controls.push(input * factor);
            responses.push(response * factor);
        }
        let levels = noise_levels(&responses, SIGNAL_TO_NOISE);
        let record = |name: &str, index: usize, response: Option<&DMatrix<f64>>| {
            let gust = &gusts[index] * strength;
            let y = response.map_or_else(|| gust.clone(), |response| response + &gust);
            let mut random = Stream::new(seed, 2 + index as u64);
            self.aircraft.noisy_record(name, &y, &levels, &mut random)
        };
        let [aileron, rudder] =
            [0, 1].map(|index| record(SURFACES[index], index, Some(&responses[index])));
        let mut controls = controls.into_iter();
        let mut next = || controls.next().unwrap_or_default();
        Ok(Flight {
            records: [aileron?, rudder?],
            quiet: record("quiet", 2, None)?,
            controls: [next(), next()],
            spectrum: self.turbulence.spectrum(SAMPLES, strength, &levels)?,
            levels,
        })
    }
}

/// What one surface does, in radians of nobody's aircraft: its size is chosen afterwards.
fn controls_of(excitation: Excitation, seed: u64, surface: usize) -> DMatrix<f64> {
    let mut random = Stream::new(seed, surface as u64);
    match excitation {
        Excitation::Autoregressive => autoregressive(normal(1, SAMPLES, &mut random)),
        Excitation::Multisteps => {
            let mut signal = DMatrix::zeros(1, SAMPLES);
            let starts: Vec<usize> = (FIRST_MULTISTEP..SAMPLES).step_by(MULTISTEP_EVERY).collect();
            let sides = normal(1, starts.len(), &mut random);
            for (start, side) in starts.into_iter().zip(&sides) {
                add_multistep(&mut signal, start, STEP, side.signum());
            }
            signal
        }
    }
}

/// Standard deviation of each sensor over all motions, each about its own mean.
fn deviations(motions: &[DMatrix<f64>]) -> Vec<f64> {
    let deviation = |sensor| {
        let sum: f64 = motions.iter().map(|y| y.row(sensor).variance()).sum();
        (sum / motions.len() as f64).sqrt()
    };
    (0..SENSORS.len()).map(deviation).collect()
}

/// The size of one motion over that of another: root mean square of the sensors' ratios.
fn size_ratio(motion: &[f64], other: &[f64]) -> f64 {
    let squares = motion.iter().zip(other).map(|(x, y)| (x / y).powi(2));
    (squares.sum::<f64>() / motion.len() as f64).sqrt()
}

#[cfg(test)]
mod tests;
