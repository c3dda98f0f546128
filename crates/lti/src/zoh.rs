//! The zero-order hold: what a sampled computer sees of a continuous-time system.

use nalgebra::DMatrix;

use crate::exponential::{exponential, exponential_parts};
use crate::scaling::{exponent, invertible_power_of_two, norm_1};
use crate::{Continuous, Discrete, LtiError, SamplePeriod, StateSpace};

impl StateSpace<Continuous> {
    /// The discrete-time system whose input is held constant between samples.
    ///
    /// `Ad = exp(A T)`, `Bd = (integral over 0..T of exp(A t) dt) B`, C and D unchanged. Both come from one
    /// exponential of the block matrix `[A B; 0 0] T` (Van Loan 1978), so A may be singular. Each column of B
    /// is first scaled by a power of two to the size of A, because Bd is linear in it; a large B then neither
    /// costs squarings nor accuracy.
    ///
    /// # Errors
    ///
    /// [`LtiError::Overflow`] if exp(A T) is too large.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, SamplePeriod, StateSpace};
    /// use nalgebra::dmatrix;
    /// // A double integrator: Ad = [1 T; 0 1], Bd = [T^2/2; T].
    /// let system = StateSpace::<Continuous>::new(
    ///     dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0], dmatrix![1.0, 0.0], dmatrix![0.0])?;
    /// let sampled = system.zoh(SamplePeriod::new(0.5)?)?;
    /// assert_eq!(sampled.a(), &dmatrix![1.0, 0.5; 0.0, 1.0]);
    /// assert_eq!(sampled.b(), &dmatrix![0.125; 0.5]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn zoh(&self, period: SamplePeriod) -> Result<StateSpace<Discrete>, LtiError> {
        let (n, m) = self.b().shape();
        let overflow = LtiError::Overflow { operation: "A times the sample period" };
        let exponent_matrix = self.a() * period.seconds();
        if exponent_matrix.iter().any(|x| !x.is_finite()) {
            return Err(overflow);
        }
        let ad = exponential(&exponent_matrix)?;

        // Columns of B T at the size of A T (or 1 where A = 0).
        let size = if n == 0 { 1.0 } else { norm_1(&exponent_matrix) };
        let size = if size == 0.0 { 1.0 } else { size };
        let mut block = DMatrix::zeros(n + m, n + m);
        block.view_mut((0, 0), (n, n)).copy_from(&exponent_matrix);
        let mut column_scale = Vec::with_capacity(m);
        for j in 0..m {
            let column = self.b().column(j);
            let scale = invertible_power_of_two(exponent(column.amax()) - exponent(size));
            // Divide first: scale is about |B| / |A T|, so the product with T stays in range.
            block.view_mut((0, n + j), (n, 1)).copy_from(&(column / scale));
            column_scale.push(scale * period.seconds());
        }
        let parts = exponential_parts(&block)?;
        let mut bd = parts.minus_identity.view((0, n), (n, m)).into_owned();
        for (j, scale) in column_scale.iter().enumerate() {
            bd.column_mut(j).scale_mut(*scale);
        }
        if bd.iter().any(|x| !x.is_finite()) {
            return Err(LtiError::Overflow { operation: "the sampled input matrix" });
        }
        StateSpace::<Discrete>::new(ad, bd, self.c().clone(), self.d().clone(), period)
    }
}

#[cfg(test)]
mod tests;
