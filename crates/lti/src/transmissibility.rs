//! Transmissibilities: how one output follows from another without knowledge of what excites both.

use nalgebra::{DMatrix, Scalar};
use poly::{Mroots, MrootsOptions, Poly, Rational, Ring, mroots};

use crate::resolvent::{characteristic_polynomial, check_vectors, numerator_given_delta};
use crate::state_space::check_square;
use crate::{LtiError, StateSpace, TimeDomain};

/// The transmissibility operator from the output y_i to the output y_o: y_o = T y_i, T = Gamma_o / Gamma_i.
///
/// Numerator and denominator are the numerators of the transfer functions from the excitation to y_o and y_i;
/// common factors are kept. Its denominator is never the zero polynomial. The variable is p = d/dt in continuous
/// time, the shift q in discrete time. It depends on the direction b in which the excitation drives the system.
///
/// Source: paper eq. (9).
///
/// # Example
///
/// ```
/// use lti::Transmissibility;
/// use nalgebra::dmatrix;
/// use poly::Poly;
/// // From position to velocity of a double integrator: T = p, whatever the force was.
/// let t = Transmissibility::new(&dmatrix![0, 1; 0, 0], &[0, 1], (&[1, 0], &0), (&[0, 1], &0))?;
/// assert_eq!(t.numerator(), &Poly::indeterminate());
/// assert_eq!(t.denominator(), &Poly::one());
/// # Ok::<(), lti::LtiError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Transmissibility<T: Ring = f64> {
    numerator: Poly<T>,
    denominator: Poly<T>,
}

/// Which channels of a system make a transmissibility; all count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Channels {
    /// The input u through which the unknown excitation comes.
    pub excitation: usize,
    /// The output y_i = c_i x + d_i u that plays the input. Source: paper eq. (3).
    pub from_output: usize,
    /// The output y_o = c_o x + d_o u that is to follow from it. Source: paper eq. (4).
    pub to_output: usize,
}

impl<T: Ring> Transmissibility<T> {
    /// The transmissibility with the given numerator Gamma_o and denominator Gamma_i.
    ///
    /// # Errors
    ///
    /// [`LtiError::ZeroDenominator`] if Gamma_i is the zero polynomial.
    pub fn from_polynomials(numerator: Poly<T>, denominator: Poly<T>) -> Result<Self, LtiError> {
        if denominator.is_zero() {
            return Err(LtiError::ZeroDenominator { largest: 0.0, rounding_level: 0.0 });
        }
        Ok(Self { numerator, denominator })
    }

    /// The numerator Gamma_o.
    #[must_use]
    pub fn numerator(&self) -> &Poly<T> {
        &self.numerator
    }

    /// The denominator Gamma_i.
    #[must_use]
    pub fn denominator(&self) -> &Poly<T> {
        &self.denominator
    }

    /// T = Gamma_o / Gamma_i as a rational function, common factors kept.
    ///
    /// Source: paper eq. (10).
    #[must_use]
    pub fn to_rational(&self) -> Rational<T> {
        // The constructors have checked the denominator, so the alternative is never taken.
        Rational::new(self.numerator.clone(), self.denominator.clone())
            .unwrap_or_else(|_| Rational::from_poly(self.numerator.clone()))
    }
}

impl<T: Ring + Scalar> Transmissibility<T> {
    /// The transmissibility of the system (A, b) from the output `from` = (c_i, d_i) to the output
    /// `to` = (c_o, d_o), exact over exact rings.
    ///
    /// A is n x n; b, c_i, c_o hold n entries. For `f64` use [`Transmissibility::between`].
    ///
    /// # Errors
    ///
    /// [`LtiError::NotSquare`], [`LtiError::Shape`], [`LtiError::ZeroDenominator`].
    pub fn new(
        a: &DMatrix<T>,
        b: &[T],
        from: (&[T], &T),
        to: (&[T], &T),
    ) -> Result<Self, LtiError> {
        check_square("A", a)?;
        check_vectors(a.nrows(), b, from.0)?;
        check_vectors(a.nrows(), b, to.0)?;
        let delta = characteristic_polynomial(a)?;
        Self::from_polynomials(
            numerator_given_delta(a, &delta, b, to.0, to.1),
            numerator_given_delta(a, &delta, b, from.0, from.1),
        )
    }
}

impl Transmissibility<f64> {
    /// The transmissibility between two outputs of a system, excited through one of its inputs.
    ///
    /// Coefficients are those of [`StateSpace::resolvent_numerators`]. Gamma_i counts as zero if every coefficient
    /// is at most n u times the sum of the absolute values of its terms, u = 2^-53: the rounding of the entries
    /// of A, b, c_i, d_i alone explains it.
    ///
    /// # Errors
    ///
    /// [`LtiError::NoSuchChannel`], [`LtiError::ZeroDenominator`], [`LtiError::Overflow`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Channels, Continuous, StateSpace, Transmissibility};
    /// use nalgebra::dmatrix;
    /// let system = StateSpace::<Continuous>::new(
    ///     dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0], dmatrix![1.0, 0.0; 0.0, 1.0], dmatrix![0.0; 0.0])?;
    /// let channels = Channels { excitation: 0, from_output: 0, to_output: 1 };
    /// let t = Transmissibility::between(&system, channels)?;
    /// assert_eq!(t.numerator().coefficients(), [0.0, 1.0]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn between<D: TimeDomain>(
        system: &StateSpace<D>,
        channels: Channels,
    ) -> Result<Self, LtiError> {
        let Channels { excitation, from_output, to_output } = channels;
        let part = system.subsystem(&[from_output, to_output], &[excitation])?;
        let found = part.numerators_with_rounding()?;
        let denominator = found.exact.numerators[0][0].clone();
        let levels = &found.levels[0][0];
        let above = |(k, x): (usize, &f64)| x.abs() > levels[k];
        if !denominator.coefficients().iter().enumerate().any(above) {
            let largest = denominator.coefficients().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let rounding_level = levels.iter().copied().fold(0.0, f64::max);
            return Err(LtiError::ZeroDenominator { largest, rounding_level });
        }
        Self::from_polynomials(found.exact.numerators[1][0].clone(), denominator)
    }

    /// The zeros: the roots of Gamma_o, which are the zeros of the transfer function from the excitation to y_o.
    ///
    /// # Errors
    ///
    /// [`LtiError::Polynomial`] if Gamma_o is zero or not finite.
    pub fn zeros(&self) -> Result<Mroots, LtiError> {
        roots("the zeros of a transmissibility", &self.numerator)
    }

    /// The poles: the roots of Gamma_i, which are the zeros of the transfer function from the excitation to y_i.
    /// The poles of the system are not among them.
    ///
    /// # Errors
    ///
    /// [`LtiError::Polynomial`] if Gamma_i is not finite.
    pub fn poles(&self) -> Result<Mroots, LtiError> {
        roots("the poles of a transmissibility", &self.denominator)
    }

    /// How far two sampled records are from obeying Gamma_i(q) y_o = Gamma_o(q) y_i: one value per sample k,
    /// r(k) = sum over j of gamma_i,j y_o(k+j) - gamma_o,j y_i(k+j), for k = 0 .. N-1-max(degrees).
    ///
    /// For records of the discrete-time system itself it is zero up to rounding, whatever the excitation and the
    /// initial state were. Empty if the records are shorter than the polynomials; the shorter record counts.
    ///
    /// Source: paper eq. (8).
    #[must_use]
    pub fn relation_residual(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let degree = self.numerator.degree().max(self.denominator.degree()).unwrap_or(0);
        let samples = from.len().min(to.len());
        let filtered = |p: &Poly<f64>, y: &[f64], k: usize| -> f64 {
            p.coefficients().iter().enumerate().map(|(j, c)| c * y[k + j]).sum()
        };
        (0..samples.saturating_sub(degree))
            .map(|k| filtered(&self.denominator, to, k) - filtered(&self.numerator, from, k))
            .collect()
    }
}

fn roots(operation: &'static str, p: &Poly<f64>) -> Result<Mroots, LtiError> {
    mroots(p, &MrootsOptions::default())
        .map_err(|source| LtiError::Polynomial { operation, source })
}

#[cfg(test)]
mod tests;
