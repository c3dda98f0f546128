//! The poles of a system: the eigenvalues of A.

use num_complex::Complex;

use crate::eigen::{eigenpairs, eigenvalues};
use crate::{LtiError, StateSpace, TimeDomain};

/// A pole and how far it can be trusted.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Pole {
    /// The eigenvalue of A: in rad/s in continuous time, in the z plane in discrete time.
    pub value: Complex<f64>,
    /// |v| |w| / |w^H v|, v and w the right and left eigenvectors: to first order a change E of A moves the pole
    /// by at most `condition * ||E||_2`. 1 at best; infinite for a defective eigenvalue and beyond about 1e307.
    pub condition: f64,
    /// |w|^T |A| |v| / |w^H v|: relative changes of the entries of A by at most eps move the pole by at most
    /// `entrywise_condition * eps`, to first order. It doesn't depend on the units of the states
    /// (Higham & Higham 1998).
    pub entrywise_condition: f64,
}

impl<T: TimeDomain> StateSpace<T> {
    /// The poles: the eigenvalues of A with their multiplicities, sorted by real part, then by modulus of the
    /// imaginary part, positive imaginary part first. Conjugate pairs are exactly conjugate, real poles exactly real.
    ///
    /// Modes that the inputs don't reach or the outputs don't show are included. A pole of multiplicity k with a
    /// single eigenvector comes out as k poles about u^(1/k) apart; its condition says so.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotConverged`] if the eigenvalue iteration fails; [`LtiError::Overflow`] if a pole is larger
    /// than the largest finite number.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::{DMatrix, dmatrix};
    /// use num_complex::Complex;
    /// let rotation = StateSpace::<Continuous>::new(
    ///     dmatrix![0.0, 2.0; -2.0, 0.0], DMatrix::zeros(2, 0), DMatrix::zeros(0, 2), DMatrix::zeros(0, 0))?;
    /// assert_eq!(rotation.poles()?, [Complex::new(0.0, 2.0), Complex::new(0.0, -2.0)]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn poles(&self) -> Result<Vec<Complex<f64>>, LtiError> {
        eigenvalues(self.a())
    }

    /// The [`poles`](Self::poles), in the same order, with their condition numbers.
    ///
    /// # Errors
    ///
    /// As [`poles`](Self::poles).
    pub fn poles_with_condition(&self) -> Result<Vec<Pole>, LtiError> {
        let pole = |pair: crate::eigen::Eigenpair| Pole {
            value: pair.value,
            condition: pair.condition,
            entrywise_condition: pair.entrywise_condition,
        };
        Ok(eigenpairs(self.a())?.into_iter().map(pole).collect())
    }
}

#[cfg(test)]
mod tests;
