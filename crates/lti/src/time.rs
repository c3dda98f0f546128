//! Continuous and discrete time, the sample period, and the map z = exp(s T) between their planes.

use num_complex::Complex;

use crate::LtiError;

/// The time between two samples, in seconds: positive and finite.
///
/// # Example
///
/// ```
/// use lti::SamplePeriod;
/// let period = SamplePeriod::new(0.1)?;
/// assert_eq!(period.seconds(), 0.1);
/// assert!(SamplePeriod::new(0.0).is_err());
/// # Ok::<(), lti::LtiError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct SamplePeriod {
    seconds: f64,
}

impl SamplePeriod {
    /// A sample period of so many seconds.
    ///
    /// # Errors
    ///
    /// [`LtiError::SamplePeriod`] unless `seconds` is positive and finite.
    pub fn new(seconds: f64) -> Result<Self, LtiError> {
        if seconds > 0.0 && seconds.is_finite() {
            Ok(Self { seconds })
        } else {
            Err(LtiError::SamplePeriod { seconds })
        }
    }

    /// The period in seconds.
    #[must_use]
    pub fn seconds(self) -> f64 {
        self.seconds
    }
}

mod sealed {
    use num_complex::Complex;

    use crate::LtiError;

    pub trait Sealed {
        fn check_same(&self, other: &Self) -> Result<(), LtiError>;
        fn on_axis(&self, frequency_rad_s: f64) -> Complex<f64>;
    }
}
pub(crate) use sealed::Sealed;

/// The time of a system: [`Continuous`] or [`Discrete`]. It is sealed: there are no others.
pub trait TimeDomain: Clone + core::fmt::Debug + PartialEq + Sealed {}

/// Continuous time: `dx/dt = A x + B u`. The variable of its polynomials is p = d/dt (or s).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Continuous;

/// Discrete time: `x(k+1) = A x(k) + B u(k)`. The variable of its polynomials is the shift q (or z).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Discrete {
    pub(crate) period: SamplePeriod,
}

impl Sealed for Continuous {
    fn check_same(&self, _other: &Self) -> Result<(), LtiError> {
        Ok(())
    }
    fn on_axis(&self, frequency_rad_s: f64) -> Complex<f64> {
        Complex::new(0.0, frequency_rad_s)
    }
}

impl Sealed for Discrete {
    fn check_same(&self, other: &Self) -> Result<(), LtiError> {
        if self == other {
            Ok(())
        } else {
            Err(LtiError::PeriodMismatch { left: self.period.seconds, right: other.period.seconds })
        }
    }
    fn on_axis(&self, frequency_rad_s: f64) -> Complex<f64> {
        Complex::from_polar(1.0, frequency_rad_s * self.period.seconds)
    }
}

impl TimeDomain for Continuous {}
impl TimeDomain for Discrete {}

/// Maps a point of the z plane to the s plane: `s = log(z) / T`, with the principal logarithm.
///
/// The result is in rad/s. Its imaginary part lies in (-pi/T, pi/T]; whatever happened faster than half
/// the sample rate is folded into that strip. Next to the unit circle the real part keeps its relative accuracy:
/// |z|^2 - 1 is formed without cancellation before its logarithm is taken.
///
/// # Errors
///
/// [`LtiError::ZeroHasNoLogarithm`] for z = 0, [`LtiError::NotFiniteArgument`] for infinite or NaN parts.
///
/// # Example
///
/// ```
/// use lti::{SamplePeriod, z_to_s};
/// use num_complex::Complex;
/// let s = z_to_s(Complex::new(0.5, 0.0), SamplePeriod::new(2.0)?)?;
/// assert_eq!(s, Complex::new(-0.5 * 2.0_f64.ln(), 0.0));
/// # Ok::<(), lti::LtiError>(())
/// ```
pub fn z_to_s(z: Complex<f64>, period: SamplePeriod) -> Result<Complex<f64>, LtiError> {
    check_finite("z", z)?;
    if z.re == 0.0 && z.im == 0.0 {
        return Err(LtiError::ZeroHasNoLogarithm);
    }
    // A negative zero as imaginary part would select -pi; the principal value is +pi.
    let angle =
        if z.im == 0.0 { if z.re < 0.0 { core::f64::consts::PI } else { 0.0 } } else { z.arg() };
    Ok(Complex::new(log_modulus(z), angle) / period.seconds)
}

/// Maps a point of the s plane (rad/s) to the z plane: `z = exp(s T)`.
///
/// # Errors
///
/// [`LtiError::NotFiniteArgument`] for infinite or NaN parts, [`LtiError::Overflow`] if |z| overflows.
///
/// # Example
///
/// ```
/// use lti::{SamplePeriod, s_to_z};
/// use num_complex::Complex;
/// let z = s_to_z(Complex::new(0.0, 0.0), SamplePeriod::new(0.1)?)?;
/// assert_eq!(z, Complex::new(1.0, 0.0));
/// # Ok::<(), lti::LtiError>(())
/// ```
pub fn s_to_z(s: Complex<f64>, period: SamplePeriod) -> Result<Complex<f64>, LtiError> {
    check_finite("s", s)?;
    let z = if s.im == 0.0 {
        Complex::new((s.re * period.seconds).exp(), s.im)
    } else {
        (s * period.seconds).exp()
    };
    if z.re.is_finite() && z.im.is_finite() {
        Ok(z)
    } else {
        Err(LtiError::Overflow { operation: "exp(s T)" })
    }
}

fn check_finite(quantity: &'static str, value: Complex<f64>) -> Result<(), LtiError> {
    for part in [value.re, value.im] {
        if !part.is_finite() {
            return Err(LtiError::NotFiniteArgument { quantity, value: part });
        }
    }
    Ok(())
}

/// ln|z| without cancellation near the unit circle: |z|^2 - 1 = (|x| - 1)(|x| + 1) + y^2 with |x| >= |y|.
pub(crate) fn log_modulus(z: Complex<f64>) -> f64 {
    let (x, y) =
        if z.re.abs() >= z.im.abs() { (z.re.abs(), z.im.abs()) } else { (z.im.abs(), z.re.abs()) };
    if y == 0.0 {
        return x.ln();
    }
    if (0.5..=2.0).contains(&x.hypot(y)) {
        // (x - 1) is exact for x in [1/2, 2]; the products are split exactly where their sum nearly cancels.
        let product = (x - 1.0) * (x + 1.0);
        let product_error = (x - 1.0).mul_add(x + 1.0, -product) + (x - 1.0) * one_plus_error(x);
        let square = y * y;
        let square_error = y.mul_add(y, -square);
        let sum = product + square;
        let back = sum - product;
        let sum_error = (product - (sum - back)) + (square - back);
        let excess = sum + (sum_error + product_error + square_error);
        return 0.5 * excess.ln_1p();
    }
    z.norm().ln()
}

/// The rounding error of x + 1, so that (x + 1) + error is exact.
fn one_plus_error(x: f64) -> f64 {
    let sum = x + 1.0;
    let back = sum - x;
    (x - (sum - back)) + (1.0 - back)
}

#[cfg(test)]
mod tests;
