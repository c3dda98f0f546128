//! From a sampled system back to the continuous-time one that a zero-order hold would have given.

use nalgebra::DMatrix;

use crate::logarithm::{Logarithm, logarithm};
use crate::scaling::{exponent, invertible_power_of_two, norm_1};
use crate::{Continuous, Discrete, LtiError, StateSpace};

/// A continuous-time system, and how well its zero-order hold gives the sampled one back.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct InverseZoh {
    /// The continuous-time system.
    pub system: StateSpace<Continuous>,
    /// The larger of ||zoh(A) - Ad|| / ||Ad|| and ||zoh(B) - Bd|| / ||Bd|| (1-norms).
    pub residual: f64,
    /// Square roots taken by the logarithm; many of them mean a system far from the identity.
    pub square_roots: usize,
}

impl StateSpace<Discrete> {
    /// The continuous-time system whose zero-order hold is this one.
    ///
    /// `[A B; 0 0] = log([Ad Bd; 0 I]) / T` with the principal logarithm, so every pole ends in the strip
    /// |im| < pi/T: what happened faster than half the sample rate is folded into it. C and D are unchanged.
    ///
    /// # Errors
    ///
    /// [`LtiError::NoRealLogarithm`] where Ad has a negative eigenvalue or one that is zero within rounding:
    /// no real continuous-time system of the same order gives such samples.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Discrete, SamplePeriod, StateSpace};
    /// use nalgebra::dmatrix;
    /// // The sampled double integrator again.
    /// let sampled = StateSpace::<Discrete>::new(
    ///     dmatrix![1.0, 0.5; 0.0, 1.0], dmatrix![0.125; 0.5], dmatrix![1.0, 0.0], dmatrix![0.0],
    ///     SamplePeriod::new(0.5)?)?;
    /// let system = sampled.inverse_zoh()?;
    /// assert!((system.a() - dmatrix![0.0, 1.0; 0.0, 0.0]).amax() < 1e-15);
    /// assert!((system.b() - dmatrix![0.0; 1.0]).amax() < 1e-15);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn inverse_zoh(&self) -> Result<StateSpace<Continuous>, LtiError> {
        Ok(self.inverse_zoh_with_residual()?.system)
    }

    /// [`inverse_zoh`](Self::inverse_zoh) with the residual of the way back.
    ///
    /// # Errors
    ///
    /// As [`inverse_zoh`](Self::inverse_zoh).
    pub fn inverse_zoh_with_residual(&self) -> Result<InverseZoh, LtiError> {
        let (n, m) = self.b().shape();
        let Logarithm { value: exponent_matrix, square_roots, .. } = logarithm(self.a())?;
        // Columns of Bd at the size of log(Ad), as in the forward direction: B is linear in Bd.
        let size = if n == 0 { 1.0 } else { norm_1(&exponent_matrix) };
        let size = if size == 0.0 { 1.0 } else { size };
        let mut block = DMatrix::identity(n + m, n + m);
        block.view_mut((0, 0), (n, n)).copy_from(self.a());
        let mut column_scale = Vec::with_capacity(m);
        for j in 0..m {
            let column = self.b().column(j);
            let scale = invertible_power_of_two(exponent(column.amax()) - exponent(size));
            block.view_mut((0, n + j), (n, 1)).copy_from(&(column / scale));
            column_scale.push(scale);
        }
        let mut b = logarithm(&block)?.value.view((0, n), (n, m)).into_owned();
        for (j, scale) in column_scale.iter().enumerate() {
            b.column_mut(j).scale_mut(*scale);
        }
        let period = self.period();
        let a = exponent_matrix / period.seconds();
        let b = b / period.seconds();
        if a.iter().chain(b.iter()).any(|x| !x.is_finite()) {
            return Err(LtiError::Overflow {
                operation: "the logarithm divided by the sample period",
            });
        }
        let system = StateSpace::<Continuous>::new(a, b, self.c().clone(), self.d().clone())?;
        let back = system.zoh(period)?;
        let residual = relative(back.a(), self.a()).max(relative(back.b(), self.b()));
        Ok(InverseZoh { system, residual, square_roots })
    }
}

/// ||x - y|| / ||y||, zero where both vanish.
fn relative(x: &DMatrix<f64>, y: &DMatrix<f64>) -> f64 {
    let difference = norm_1(&(x - y));
    if difference == 0.0 { 0.0 } else { difference / norm_1(y) }
}

#[cfg(test)]
mod tests;
