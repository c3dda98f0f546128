//! Simulation of sampled systems, and their Markov parameters.

use nalgebra::{DMatrix, DVector};

use crate::state_space::{check_finite, check_shape};
use crate::{Discrete, LtiError, StateSpace, TimeDomain};

/// The response of a sampled system.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Simulation {
    /// y(0) .. y(N-1): outputs x N, one column per sample.
    pub outputs: DMatrix<f64>,
    /// x(0) .. x(N): n x (N + 1), one column per sample; the last is the state after the last input.
    pub states: DMatrix<f64>,
}

impl StateSpace<Discrete> {
    /// The outputs and states for an input of N samples, one column per sample, from an initial state
    /// (zero if `None`).
    ///
    /// x(0) = x0, x(k+1) = A x(k) + B u(k), y(k) = C x(k) + D u(k). A diverging simulation is carried to the
    /// end; its values may become infinite.
    ///
    /// Source: paper eq. (2) (the initial state, which a transmissibility accounts for).
    ///
    /// # Errors
    ///
    /// [`LtiError::Shape`] or [`LtiError::NotFinite`] for an input or initial state that doesn't fit.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Discrete, SamplePeriod, StateSpace};
    /// use nalgebra::dmatrix;
    /// // y(k) = sum of the inputs before k, from x0 = 10.
    /// let sum = StateSpace::<Discrete>::new(
    ///     dmatrix![1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0], SamplePeriod::new(1.0)?)?;
    /// let response = sum.simulate(&dmatrix![1.0, 2.0, 3.0], Some(&nalgebra::dvector![10.0]))?;
    /// assert_eq!(response.outputs, dmatrix![10.0, 11.0, 13.0]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn simulate(
        &self,
        input: &DMatrix<f64>,
        initial: Option<&DVector<f64>>,
    ) -> Result<Simulation, LtiError> {
        let n = self.order();
        let samples = input.ncols();
        check_shape("the input", input, self.inputs(), samples)?;
        check_finite("the input", input)?;
        let mut states = DMatrix::zeros(n, samples + 1);
        if let Some(x0) = initial {
            if x0.len() != n {
                return Err(LtiError::Shape {
                    matrix: "the initial state",
                    rows: x0.len(),
                    columns: 1,
                    needed_rows: n,
                    needed_columns: 1,
                });
            }
            for (row, &value) in x0.iter().enumerate() {
                if !value.is_finite() {
                    return Err(LtiError::NotFinite {
                        matrix: "the initial state",
                        row,
                        column: 0,
                        value,
                    });
                }
            }
            states.set_column(0, x0);
        }
        let forced = self.b() * input;
        for k in 0..samples {
            let next = self.a() * states.column(k) + forced.column(k);
            states.set_column(k + 1, &next);
        }
        let outputs = self.c() * states.columns(0, samples) + self.d() * input;
        Ok(Simulation { outputs, states })
    }
}

impl<T: TimeDomain> StateSpace<T> {
    /// The first `count` Markov parameters: H_0 = D, H_k = C A^(k-1) B, each p x m.
    ///
    /// For a sampled system they are its impulse response. They may overflow to infinity where A has poles far
    /// outside the unit circle.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Discrete, SamplePeriod, StateSpace};
    /// use nalgebra::dmatrix;
    /// let system = StateSpace::<Discrete>::new(
    ///     dmatrix![0.5], dmatrix![4.0], dmatrix![1.0], dmatrix![7.0], SamplePeriod::new(1.0)?)?;
    /// let h: Vec<f64> = system.markov_parameters(4).iter().map(|h| h[0]).collect();
    /// assert_eq!(h, [7.0, 4.0, 2.0, 1.0]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    #[must_use]
    pub fn markov_parameters(&self, count: usize) -> Vec<DMatrix<f64>> {
        let mut parameters = Vec::with_capacity(count);
        if count > 0 {
            parameters.push(self.d().clone());
        }
        let mut state = self.b().clone();
        while parameters.len() < count {
            parameters.push(self.c() * &state);
            state = self.a() * state;
        }
        parameters
    }
}

#[cfg(test)]
mod tests;
