//! Side gusts, what they do to the aircraft, and the spectrum of what the sensors then read.

use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use num_complex::Complex;
use rand_chacha::ChaCha8Rng;
use reconstruct::NoiseSpectrum;

use crate::TaskError;
use crate::study::averages::count;
use crate::study::readings::SENSORS;
use crate::study::signals::normal;

const PART: &str = "turbulence";

/// Corner of the gusts' filter in rad/s. Dryden's is speed over scale of turbulence: 400 ft/s over 400 ft.
const CORNER_RAD_S: f64 = 1.0;
/// Steps of the simulation between two samples, in each of which the filter's input is held.
const SUBSTEPS: usize = 20;
/// Samples of turbulence before a record begins: 60 s, by when all but the spiral mode have forgotten the rest they started from.
pub(super) const RUN_IN: usize = 600;

/// The aircraft in a side gust g, an angle like sideslip: g' = -w g + w n, n white; x' = A x - a g, a the first column of A, for all that
/// sideslip does to the aircraft it does through the air. The vane reads the sideslip relative to the air, beta - g.
pub(crate) struct Turbulence {
    /// n to beta, p and r, for steps of the simulation.
    fine: StateSpace<Discrete>,
}

impl Turbulence {
    pub(crate) fn new(
        aircraft: &StateSpace<Continuous>,
        period: SamplePeriod,
    ) -> Result<Self, TaskError> {
        let fault = TaskError::computation(PART);
        let n = aircraft.order();
        let mut a = DMatrix::zeros(n + 1, n + 1);
        a.view_mut((0, 0), (n, n)).copy_from(aircraft.a());
        a.view_mut((0, n), (n, 1)).copy_from(&-aircraft.a().column(0));
        a[(n, n)] = -CORNER_RAD_S;
        let mut b = DMatrix::zeros(n + 1, 1);
        b[n] = CORNER_RAD_S;
        let mut c = DMatrix::zeros(SENSORS.len(), n + 1);
        c.view_mut((0, 0), (SENSORS.len(), n)).copy_from(aircraft.c());
        c[(0, n)] = -1.0;
        let d = DMatrix::zeros(SENSORS.len(), 1);
        let step = SamplePeriod::new(period.seconds() / count(SUBSTEPS)).map_err(fault)?;
        let continuous =
            StateSpace::<Continuous>::new(a, b, c, d).map_err(TaskError::computation(PART))?;
        let fine = continuous.zoh(step).map_err(TaskError::computation(PART))?;
        Ok(Self { fine })
    }

    /// The gusts' motion in the sensors, one row each, in turbulence of unit strength that began [`RUN_IN`] samples before.
    pub(super) fn motion(
        &self,
        samples: usize,
        random: &mut ChaCha8Rng,
    ) -> Result<DMatrix<f64>, TaskError> {
        let input = normal(1, (RUN_IN + samples) * SUBSTEPS, random);
        let simulation = self.fine.simulate(&input, None).map_err(TaskError::computation(PART))?;
        let fine = simulation.outputs;
        Ok(DMatrix::from_fn(SENSORS.len(), samples, |i, k| fine[(i, (RUN_IN + k) * SUBSTEPS)]))
    }

    /// The spectrum of the gusts' motion, `strength` times as large, and white noise of these levels: what a quiet record without an end would
    /// say. From sample to sample x(k+1) = F x(k) + w(k), w white with covariance Q, the sum of what the steps between add.
    pub(super) fn spectrum(
        &self,
        samples: usize,
        strength: f64,
        levels: &[f64],
    ) -> Result<NoiseSpectrum, TaskError> {
        let n = self.fine.order();
        let mut transition = DMatrix::<f64>::identity(n, n);
        let mut q = DMatrix::<f64>::zeros(n, n);
        for _ in 0..SUBSTEPS {
            let gain = &transition * self.fine.b();
            q += &gain * gain.transpose();
            transition = self.fine.a() * transition;
        }
        let complex = |matrix: &DMatrix<f64>| matrix.map(|entry| Complex::new(entry, 0.0));
        let (f, q, c) =
            (complex(&transition), complex(&(q * strength * strength)), complex(self.fine.c()));
        let at = |k: usize| {
            let z = Complex::from_polar(1.0, std::f64::consts::TAU * count(k) / count(samples));
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
