//! The motion of a system that noise drives in continuous time, as sensors sample it.

use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::{DMatrix, DVector};

use crate::{FlightError, Stream, normal};

/// Steps of the simulation between two samples; in each of them the noise is held.
pub const SUBSTEPS: usize = 20;
/// Samples that are simulated at once, so that memory does not grow with the length of a flight.
const BLOCK: usize = 500;

/// A system with one input, which noise drives that changes [`SUBSTEPS`] times between two samples.
///
/// # Example
///
/// ```
/// use flight::{ContinuousNoise, Stream};
/// use lti::{Continuous, SamplePeriod, StateSpace};
/// use nalgebra::dmatrix;
///
/// let lag = StateSpace::<Continuous>::new(dmatrix![-1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])?;
/// let motion = ContinuousNoise::new(&lag, SamplePeriod::new(0.1)?)?;
/// let y = motion.sampled(50, 200, &mut Stream::new(7, 0))?;
/// assert_eq!(y.shape(), (1, 200));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct ContinuousNoise {
    fine: StateSpace<Discrete>,
}

impl ContinuousNoise {
    /// Samples the system for steps of the simulation.
    ///
    /// # Errors
    ///
    /// [`FlightError::NoSuchInput`] unless the system has one input, [`FlightError::System`].
    pub fn new(system: &StateSpace<Continuous>, period: SamplePeriod) -> Result<Self, FlightError> {
        let fault = |error| FlightError::system(&error);
        if system.inputs() != 1 {
            let (order, inputs) = (system.order(), system.inputs());
            return Err(FlightError::NoSuchInput { order, inputs, input: 0 });
        }
        let step = SamplePeriod::new(period.seconds() / SUBSTEPS as f64).map_err(fault)?;
        Ok(Self { fine: system.zoh(step).map_err(fault)? })
    }

    /// The system for steps of the simulation.
    #[must_use]
    pub fn fine(&self) -> &StateSpace<Discrete> {
        &self.fine
    }

    /// The outputs at `samples` samples, one row each, after `run_in` samples from rest that are thrown away. The noise has unit variance.
    ///
    /// # Errors
    ///
    /// [`FlightError::System`] if the motion leaves the range of numbers.
    pub fn sampled(
        &self,
        run_in: usize,
        samples: usize,
        random: &mut Stream,
    ) -> Result<DMatrix<f64>, FlightError> {
        let mut found = DMatrix::zeros(self.fine.outputs(), samples);
        let mut state = DVector::zeros(self.fine.order());
        let mut first = 0;
        while first < run_in + samples {
            let block = BLOCK.min(run_in + samples - first);
            let input = normal(1, block * SUBSTEPS, random);
            let motion = self
                .fine
                .simulate(&input, Some(&state))
                .map_err(|error| FlightError::system(&error))?;
            for k in first.max(run_in)..first + block {
                let column = motion.outputs.column((k - first) * SUBSTEPS);
                found.set_column(k - run_in, &column);
            }
            state.copy_from(&motion.states.column(block * SUBSTEPS));
            first += block;
        }
        Ok(found)
    }
}

#[cfg(test)]
mod tests;
