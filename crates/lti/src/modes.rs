//! Modes: what each eigenvalue means in time.

use core::f64::consts::{LN_2, TAU};

use nalgebra::DVector;
use num_complex::Complex;

use crate::eigen::{Eigenpair, eigenpairs};
use crate::{Continuous, Discrete, LtiError, SamplePeriod, StateSpace, z_to_s};

/// How a mode moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ModeKind {
    /// One real eigenvalue: it decays, stays or grows without changing sign.
    Real,
    /// A complex pair, or a negative real z (which alternates at half the sample rate).
    Oscillatory,
    /// A discrete eigenvalue z = 0: gone after finitely many samples. Its `eigenvalue` is -infinity.
    Deadbeat,
}

/// A mode: a real eigenvalue, or a complex pair counted once by its member with positive imaginary part.
///
/// With s = sigma + j omega in rad/s: natural frequency |s|, damping ratio -sigma/|s|, period 2 pi/omega,
/// time constant -1/sigma, time to half or double ln 2/|sigma|.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// s in rad/s, imaginary part >= 0. For a discrete system log(z)/T.
    pub eigenvalue: Complex<f64>,
    /// z, for the modes of a discrete system.
    pub discrete_eigenvalue: Option<Complex<f64>>,
    /// Real, oscillatory or deadbeat.
    pub kind: ModeKind,
    /// |s|, in rad/s.
    pub natural_frequency_rad_s: f64,
    /// -re(s)/|s|: 1 for a real stable mode, -1 for a real unstable one, 0 for s = 0.
    pub damping_ratio: f64,
    /// 2 pi / im(s) in s, for oscillatory modes.
    pub period_s: Option<f64>,
    /// -1/s in s, for real modes: negative if the mode grows, infinite for s = 0. 0 for a deadbeat mode.
    pub time_constant_s: Option<f64>,
    /// ln 2 / |re(s)| in s: the time in which the amplitude halves (re(s) < 0) or doubles (re(s) > 0); infinite
    /// if it does neither.
    pub time_to_half_or_double_s: f64,
    /// The right eigenvector v, A v = lambda v: unit length, its largest component real and positive.
    /// `None` where only the eigenvalue is known.
    pub eigenvector: Option<DVector<Complex<f64>>>,
    /// The left eigenvector w, w^H A = lambda w^H, scaled so that w^H v = 1: w^H x is how much of the mode a
    /// state x holds. Of unit length if the eigenvalue is defective, where w^H v = 0.
    pub left_eigenvector: Option<DVector<Complex<f64>>>,
    /// The condition number of the eigenvalue of A (of z, for a discrete system): |v| |w| / |w^H v|.
    pub condition: Option<f64>,
}

impl Mode {
    /// The mode of a continuous-time eigenvalue s in rad/s. Either member of a complex pair may be given.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotFiniteArgument`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::Mode;
    /// use num_complex::Complex;
    /// let mode = Mode::from_eigenvalue(Complex::new(-3.0, 4.0))?;
    /// assert_eq!((mode.natural_frequency_rad_s, mode.damping_ratio), (5.0, 0.6));
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn from_eigenvalue(s: Complex<f64>) -> Result<Self, LtiError> {
        for value in [s.re, s.im] {
            if !value.is_finite() {
                return Err(LtiError::NotFiniteArgument { quantity: "the eigenvalue", value });
            }
        }
        Ok(Self::checked(Complex::new(s.re, s.im.abs())))
    }

    /// The mode of a discrete-time eigenvalue z.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotFiniteArgument`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Mode, ModeKind, SamplePeriod};
    /// use num_complex::Complex;
    /// let mode = Mode::from_discrete_eigenvalue(Complex::new(0.5, 0.0), SamplePeriod::new(3.0)?)?;
    /// assert_eq!(mode.kind, ModeKind::Real);
    /// assert!((mode.time_to_half_or_double_s - 3.0).abs() < 1e-15);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn from_discrete_eigenvalue(
        z: Complex<f64>,
        period: SamplePeriod,
    ) -> Result<Self, LtiError> {
        let z = Complex::new(z.re, z.im.abs());
        let mut mode = match z_to_s(z, period) {
            Ok(s) => Self::checked(s),
            Err(LtiError::ZeroHasNoLogarithm) => Self::deadbeat(),
            Err(error) => return Err(error),
        };
        mode.discrete_eigenvalue = Some(z);
        Ok(mode)
    }

    fn checked(s: Complex<f64>) -> Self {
        let oscillatory = s.im > 0.0;
        let natural_frequency_rad_s = s.re.hypot(s.im);
        let damping_ratio =
            if natural_frequency_rad_s == 0.0 { 0.0 } else { -s.re / natural_frequency_rad_s };
        Self {
            eigenvalue: s,
            discrete_eigenvalue: None,
            kind: if oscillatory { ModeKind::Oscillatory } else { ModeKind::Real },
            natural_frequency_rad_s,
            damping_ratio,
            period_s: oscillatory.then(|| TAU / s.im),
            time_constant_s: (!oscillatory)
                .then(|| if s.re == 0.0 { f64::INFINITY } else { -1.0 / s.re }),
            time_to_half_or_double_s: LN_2 / s.re.abs(),
            eigenvector: None,
            left_eigenvector: None,
            condition: None,
        }
    }

    fn deadbeat() -> Self {
        Self {
            eigenvalue: Complex::new(f64::NEG_INFINITY, 0.0),
            discrete_eigenvalue: None,
            kind: ModeKind::Deadbeat,
            natural_frequency_rad_s: f64::INFINITY,
            damping_ratio: 1.0,
            period_s: None,
            time_constant_s: Some(0.0),
            time_to_half_or_double_s: 0.0,
            eigenvector: None,
            left_eigenvector: None,
            condition: None,
        }
    }

    fn with_vectors(mut self, pair: Eigenpair) -> Self {
        self.eigenvector = Some(pair.right);
        self.left_eigenvector = Some(pair.left);
        self.condition = Some(pair.condition);
        self
    }
}

impl StateSpace<Continuous> {
    /// The modes, sorted by the real part of the eigenvalue and then by its imaginary part, ascending: the
    /// fastest decay first.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotConverged`] if the eigenvalue iteration fails; [`LtiError::Overflow`] if an eigenvalue is
    /// larger than the largest finite number.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, ModeKind, StateSpace};
    /// use nalgebra::{DMatrix, dmatrix};
    /// let a = dmatrix![-0.5, 0.0, 0.0; 0.0, 0.0, 2.0; 0.0, -2.0, 0.0];
    /// let system = StateSpace::<Continuous>::new(
    ///     a, DMatrix::zeros(3, 0), DMatrix::zeros(0, 3), DMatrix::zeros(0, 0))?;
    /// let modes = system.modes()?;
    /// assert_eq!(modes.len(), 2);
    /// assert_eq!(modes[0].time_constant_s, Some(2.0));
    /// assert_eq!(modes[1].kind, ModeKind::Oscillatory);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn modes(&self) -> Result<Vec<Mode>, LtiError> {
        let pairs = eigenpairs(self.a())?.into_iter().filter(|pair| pair.value.im >= 0.0);
        pairs.map(|pair| Ok(Mode::from_eigenvalue(pair.value)?.with_vectors(pair))).collect()
    }
}

impl StateSpace<Discrete> {
    /// The modes in continuous time, s = log(z)/T, sorted by the real and then the imaginary part of s.
    /// Eigenvectors and condition numbers are those of the discrete A.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotConverged`] if the eigenvalue iteration fails; [`LtiError::Overflow`] if an eigenvalue is
    /// larger than the largest finite number.
    pub fn modes(&self) -> Result<Vec<Mode>, LtiError> {
        let mut modes = Vec::new();
        for pair in eigenpairs(self.a())? {
            if pair.value.im >= 0.0 {
                modes.push(
                    Mode::from_discrete_eigenvalue(pair.value, self.period())?.with_vectors(pair),
                );
            }
        }
        modes.sort_by(|x, y| crate::eigen::compare(&x.eigenvalue, &y.eigenvalue));
        Ok(modes)
    }
}

#[cfg(test)]
mod tests;
