//! The discrete Fourier transform of signals of one record, and the frequencies of it that are used.

use std::f64::consts::TAU;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};

use crate::ReconstructError;

/// Of so many samples, at frequencies 2 pi k / N.
pub(crate) struct Fourier {
    samples: usize,
    /// k of each frequency that is used, ascending.
    pub(crate) kept: Vec<usize>,
    forward: Arc<dyn RealToComplex<f64>>,
}

impl Fourier {
    pub(crate) fn new(samples: usize, kept: Vec<usize>, planner: &mut RealFftPlanner<f64>) -> Self {
        Self { samples, kept, forward: planner.plan_fft_forward(samples) }
    }

    /// N^(-1/2) sum v(i) z^-i, from frequency zero to half the sampling frequency, whatever is used of it.
    pub(crate) fn of(
        &self,
        values: impl Iterator<Item = f64>,
    ) -> Result<Vec<Complex<f64>>, ReconstructError> {
        let scale = 1.0 / (self.samples as f64).sqrt();
        let mut input: Vec<f64> = values.collect();
        let mut output = self.forward.make_output_vec();
        match self.forward.process(&mut input, &mut output) {
            Ok(()) => Ok(output.into_iter().map(|value| value * scale).collect()),
            Err(error) => Err(ReconstructError::Step {
                step: "Fourier transform",
                message: error.to_string(),
            }),
        }
    }

    /// z = exp(2 pi j k / N) of the frequencies that are used, exact at 0 and at half the sampling frequency.
    pub(crate) fn z(&self) -> Vec<Complex<f64>> {
        let root = |&k: &usize| {
            if 2 * k == self.samples {
                Complex::new(-1.0, 0.0)
            } else {
                Complex::from_polar(1.0, TAU * k as f64 / self.samples as f64)
            }
        };
        self.kept.iter().map(root).collect()
    }

    /// How many real numbers a signal has there: 2 inside, 1 at frequency zero and at half the sampling frequency.
    pub(crate) fn weight(&self) -> Vec<f64> {
        let numbers = |&k: &usize| if k == 0 || 2 * k == self.samples { 1.0 } else { 2.0 };
        self.kept.iter().map(numbers).collect()
    }

    /// The transform of sqrt(12) (i - (N - 1)/2) / N, a ramp without mean and of about unit variance.
    pub(crate) fn ramp(&self) -> Vec<Complex<f64>> {
        let scale = Complex::from((12.0 / self.samples as f64).sqrt());
        let at = |(&k, z): (&usize, Complex<f64>)| {
            if k == 0 { Complex::ZERO } else { scale / (z.conj() - 1.0) }
        };
        self.kept.iter().zip(self.z()).map(at).collect()
    }
}
