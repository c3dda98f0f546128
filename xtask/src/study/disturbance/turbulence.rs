//! Side gusts, what they do to the aircraft, and the spectrum of what the sensors then read.

use flight::{ContinuousNoise, SUBSTEPS, Stream, in_side_gust};
use lti::{Continuous, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use num_complex::Complex;
use reconstruct::likelihood::NoiseSpectrum;

use crate::TaskError;

const PART: &str = "turbulence";

/// Corner of the gusts' filter in rad/s. Dryden's is speed over scale of turbulence: 400 ft/s over
/// 400 ft.
const CORNER_RAD_S: f64 = 1.0;
/// Samples of turbulence before a record begins: 60 s, by when all but the spiral mode have
/// forgotten the rest they started from.
pub(super) const RUN_IN: usize = 600;

/// The aircraft in a side gust g, an angle like sideslip: g' = -w g + w n, n white; x' = A x - a g,
/// a the first column of A, for all that sideslip does to the aircraft it does through the air. The
/// vane reads the sideslip relative to the air, beta - g.
pub(crate) struct Turbulence {
    /// n to beta, p and r.
    noise: ContinuousNoise,
}

impl Turbulence {
    pub(crate) fn new(
        aircraft: &StateSpace<Continuous>,
        period: SamplePeriod,
    ) -> Result<Self, TaskError> {
        let gusty = in_side_gust(aircraft, CORNER_RAD_S).map_err(TaskError::computation(PART))?;
        let noise = ContinuousNoise::new(&gusty, period).map_err(TaskError::computation(PART))?;
        Ok(Self { noise })
    }

    /// The gusts' motion in the sensors, one row each, in turbulence of unit strength that began
    /// [`RUN_IN`] samples before.
    pub(super) fn motion(
        &self,
        samples: usize,
        random: &mut Stream,
    ) -> Result<DMatrix<f64>, TaskError> {
        self.noise.sampled(RUN_IN, samples, random).map_err(TaskError::computation(PART))
    }

    /// The spectrum of the gusts' motion, `strength` times as large, and white noise of these
    /// levels: what a quiet record without an end would say. From sample to sample x(k+1) = F x(k)
    /// + w(k), w white with covariance Q, the sum of what the steps between add.
    pub(super) fn spectrum(
        &self,
        samples: usize,
        strength: f64,
        levels: &[f64],
    ) -> Result<NoiseSpectrum, TaskError> {
        let n = self.noise.fine().order();
        let mut transition = DMatrix::<f64>::identity(n, n);
        let mut q = DMatrix::<f64>::zeros(n, n);
        for _ in 0..SUBSTEPS {
            let gain = &transition * self.noise.fine().b();
            q += &gain * gain.transpose();
            transition = self.noise.fine().a() * transition;
        }
        let complex = |matrix: &DMatrix<f64>| matrix.map(|entry| Complex::new(entry, 0.0));
        let (f, q, c) = (
            complex(&transition),
            complex(&(q * strength * strength)),
            complex(self.noise.fine().c()),
        );
        let at = |k: usize| {
            let z = Complex::from_polar(1.0, std::f64::consts::TAU * k as f64 / samples as f64);
            let inverse = (DMatrix::identity(n, n) * z - &f)
                .try_inverse()
                .ok_or_else(|| TaskError::computation(PART)("an eigenvalue on the unit circle"))?;
            let gain = &c * inverse;
            let mut covariance = &gain * &q * gain.adjoint();
            covariance = (&covariance + covariance.adjoint()) * Complex::new(0.5, 0.0);
            for (sensor, level) in levels.iter().enumerate() {
                covariance[(sensor, sensor)] += level * level;
            }
            Ok(covariance)
        };
        let covariances = (0..=samples / 2).map(at).collect::<Result<Vec<_>, TaskError>>()?;
        NoiseSpectrum::new(samples, covariances).map_err(TaskError::computation(PART))
    }
}

#[cfg(test)]
mod tests;
