//! Two excitations of one system: the two transmissibilities between the same outputs, and the four polynomials
//! behind them.

use nalgebra::{DMatrix, Scalar};
use poly::{Poly, Ring};

use crate::resolvent::{characteristic_polynomial, check_vectors, numerator_given_delta};
use crate::state_space::check_square;
use crate::{LtiError, StateSpace, TimeDomain, Transmissibility};

/// The numerators for two excitation directions b_1 and b_2, between the same two outputs.
///
/// With delta = det(pI - A) the characteristic polynomial.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ExcitationPair<T: Ring = f64> {
    /// Gamma_i,1 = c_i adj(pI - A) b_1 + d_i delta. Source: paper eq. (12).
    pub gamma_i1: Poly<T>,
    /// Gamma_o,1 = c_o adj(pI - A) b_1 + d_o delta. Source: paper eq. (13).
    pub gamma_o1: Poly<T>,
    /// Gamma_i,2 = c_i adj(pI - A) b_2 + d_i delta. Source: paper eq. (14).
    pub gamma_i2: Poly<T>,
    /// Gamma_o,2 = c_o adj(pI - A) b_2 + d_o delta. Source: paper eq. (15).
    pub gamma_o2: Poly<T>,
}

/// Which channels of a system make a pair; all count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PairChannels {
    /// The input that excites in the first record, and the one in the second.
    pub excitations: [usize; 2],
    /// The output y_i that plays the input.
    pub from_output: usize,
    /// The output y_o that is to follow from it.
    pub to_output: usize,
}

impl<T: Ring + Scalar> ExcitationPair<T> {
    /// The four numerators for the excitation directions `b = [b_1, b_2]` between the outputs
    /// `from` = (c_i, d_i) and `to` = (c_o, d_o), exact over exact rings.
    ///
    /// As in the paper, d_i and d_o are common to both directions. For `f64` use [`ExcitationPair::between`].
    ///
    /// # Errors
    ///
    /// [`LtiError::NotSquare`] or [`LtiError::Shape`].
    ///
    /// # Example
    ///
    /// Example 4.1 of the paper; its printed Gamma_o,1 and Gamma_i,2 are exchanged.
    /// ```
    /// use lti::ExcitationPair;
    /// use nalgebra::dmatrix;
    /// use poly::Poly;
    /// let a = dmatrix![1, 1, 1; 0, 2, -1; 0, 1, 1];
    /// let pair = ExcitationPair::new(
    ///     &a, [&[0, 1, 0], &[0, 1, -1]], (&[1, 2, -1], &0), (&[-1, 3, -2], &0))?;
    /// assert_eq!(pair.gamma_i1, Poly::from_descending(&[2, -4, 3]));
    /// assert_eq!(pair.gamma_o1, Poly::from_descending(&[3, -9, 5]));
    /// assert_eq!(pair.gamma_i2, Poly::from_descending(&[3, -6, 6]));
    /// assert_eq!(pair.gamma_o2, Poly::from_descending(&[5, -11, 3]));
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn new(
        a: &DMatrix<T>,
        b: [&[T]; 2],
        from: (&[T], &T),
        to: (&[T], &T),
    ) -> Result<Self, LtiError> {
        check_square("A", a)?;
        for column in b {
            check_vectors(a.nrows(), column, from.0)?;
            check_vectors(a.nrows(), column, to.0)?;
        }
        let delta = characteristic_polynomial(a)?;
        let gamma =
            |column: &[T], (c, d): (&[T], &T)| numerator_given_delta(a, &delta, column, c, d);
        Ok(Self {
            gamma_i1: gamma(b[0], from),
            gamma_o1: gamma(b[0], to),
            gamma_i2: gamma(b[1], from),
            gamma_o2: gamma(b[1], to),
        })
    }
}

impl ExcitationPair<f64> {
    /// The four numerators between two outputs of a system, excited through one input and then another.
    /// The feedthroughs are those of each input.
    ///
    /// # Errors
    ///
    /// [`LtiError::NoSuchChannel`] or [`LtiError::Overflow`].
    pub fn between<D: TimeDomain>(
        system: &StateSpace<D>,
        channels: PairChannels,
    ) -> Result<Self, LtiError> {
        let outputs = [channels.from_output, channels.to_output];
        let mut numerators =
            system.subsystem(&outputs, &channels.excitations)?.resolvent_numerators()?.numerators;
        let mut take = |i: usize, j: usize| core::mem::replace(&mut numerators[i][j], Poly::zero());
        Ok(Self {
            gamma_i1: take(0, 0),
            gamma_o1: take(1, 0),
            gamma_i2: take(0, 1),
            gamma_o2: take(1, 1),
        })
    }
}

impl<T: Ring> ExcitationPair<T> {
    /// The two transmissibilities T_1 = Gamma_o,1 / Gamma_i,1 and T_2 = Gamma_o,2 / Gamma_i,2.
    ///
    /// Source: paper eq. (11).
    ///
    /// # Errors
    ///
    /// [`LtiError::ZeroDenominator`] if a denominator is the zero polynomial.
    pub fn transmissibilities(&self) -> Result<[Transmissibility<T>; 2], LtiError> {
        Ok([
            Transmissibility::from_polynomials(self.gamma_o1.clone(), self.gamma_i1.clone())?,
            Transmissibility::from_polynomials(self.gamma_o2.clone(), self.gamma_i2.clone())?,
        ])
    }
}

#[cfg(test)]
mod tests;
