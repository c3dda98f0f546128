//! A real rational function as its zeros, poles and gain.

#[cfg(test)]
mod tests;

use crate::cancellation::cancel_lists;
use crate::mroots::order;
use crate::{Cancellation, Cancelled, MrootsOptions, Poly, PolyError, Rational, mroots};
use num_complex::Complex;

/// Values count as conjugate when they agree to this much of their modulus: half the digits of a float.
const CONJUGATE_TOLERANCE: f64 = 1e-8;

/// `gain (x - z_1) ... (x - z_m) / ((x - p_1) ... (x - p_n))` with real coefficients.
///
/// Zeros and poles are stored exactly real or in exactly conjugate pairs, by ascending real part, then modulus of the
/// imaginary part, positive imaginary part first. A gain of zero is the zero function.
///
/// # Example
/// ```
/// use poly::{Complex, ZeroPoleGain};
///
/// let c = |re: f64, im: f64| Complex::new(re, im);
/// let g = ZeroPoleGain::new(vec![c(3.0, 0.0)], vec![c(1.0, 2.0), c(1.0, -2.0)], 4.0)?;
/// let r = g.to_rational()?;
/// assert_eq!(r.numerator().descending(), [4.0, -12.0]);
/// assert_eq!(r.denominator().descending(), [1.0, -2.0, 5.0]);
/// # Ok::<(), poly::PolyError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ZeroPoleGain {
    zeros: Vec<Complex<f64>>,
    poles: Vec<Complex<f64>>,
    gain: f64,
}

impl ZeroPoleGain {
    /// From zeros, poles and gain.
    ///
    /// Conjugates may differ by 1e-8 of their modulus and are then averaged.
    ///
    /// # Errors
    /// [`PolyError::NonFiniteValue`] for NaN and infinities, [`PolyError::NotConjugateClosed`] if a conjugate is missing.
    pub fn new(
        zeros: Vec<Complex<f64>>,
        poles: Vec<Complex<f64>>,
        gain: f64,
    ) -> Result<Self, PolyError> {
        if !gain.is_finite() {
            let value = Complex::new(gain, 0.0);
            return Err(PolyError::NonFiniteValue { what: "gain", index: 0, value });
        }
        Ok(Self { zeros: conjugated(&zeros, "zero")?, poles: conjugated(&poles, "pole")?, gain })
    }

    /// From a rational function: the roots of its numerator and denominator.
    ///
    /// # Errors
    /// As [`mroots()`] for the denominator and, unless it is zero, the numerator.
    pub fn from_rational(
        rational: &Rational<f64>,
        options: &MrootsOptions,
    ) -> Result<Self, PolyError> {
        let poles = mroots(rational.denominator(), options)?.values();
        let (Some(&top), Some(&bottom)) =
            (rational.numerator().leading(), rational.denominator().leading())
        else {
            return Self::new(Vec::new(), poles, 0.0);
        };
        let zeros = mroots(rational.numerator(), options)?.values();
        Self::new(zeros, poles, top / bottom)
    }

    /// The zeros.
    pub fn zeros(&self) -> &[Complex<f64>] {
        &self.zeros
    }

    /// The poles.
    pub fn poles(&self) -> &[Complex<f64>] {
        &self.poles
    }

    /// The gain: the quotient of the leading coefficients.
    pub fn gain(&self) -> f64 {
        self.gain
    }

    /// The value at `x`; infinite or NaN at a pole. Factors are taken in turn, so that nothing overflows early.
    pub fn eval(&self, x: Complex<f64>) -> Complex<f64> {
        let mut value = Complex::new(self.gain, 0.0);
        for k in 0..self.zeros.len().max(self.poles.len()) {
            if let Some(zero) = self.zeros.get(k) {
                value *= x - zero;
            }
            if let Some(pole) = self.poles.get(k) {
                value /= x - pole;
            }
        }
        value
    }

    /// The product of two functions: zeros and poles joined, gains multiplied.
    ///
    /// # Errors
    /// [`PolyError::NonFiniteValue`] if the gain overflows.
    pub fn product(&self, other: &Self) -> Result<Self, PolyError> {
        Self::new(
            [&self.zeros[..], &other.zeros].concat(),
            [&self.poles[..], &other.poles].concat(),
            self.gain * other.gain,
        )
    }

    /// Numerator and denominator, expanded in doubled precision and rounded once; the denominator is monic.
    ///
    /// # Errors
    /// [`PolyError::Overflow`] if a coefficient leaves the range of floats.
    pub fn to_rational(&self) -> Result<Rational<f64>, PolyError> {
        let numerator = Poly::real_from_roots(&self.zeros)?.scale(&self.gain);
        if let Some(degree) = numerator.coefficients().iter().position(|c| !c.is_finite()) {
            return Err(PolyError::Overflow { degree });
        }
        Rational::new(numerator, Poly::real_from_roots(&self.poles)?)
    }

    /// The function without the zeros and poles that lie within a distance of each other.
    ///
    /// The closest pairs go first, a conjugate pair together with its conjugate.
    ///
    /// # Errors
    /// [`PolyError::InvalidTolerance`], [`PolyError::Overflow`].
    pub fn cancel(&self, options: &Cancellation) -> Result<Cancelled, PolyError> {
        let lists = cancel_lists(&self.zeros, &self.poles, options)?;
        let left = Self { zeros: lists.zeros, poles: lists.poles, gain: self.gain };
        Ok(Cancelled {
            rational: left.to_rational()?,
            pairs: lists.pairs,
            closest_left: lists.closest_left,
            zeros: left.zeros,
            poles: left.poles,
            gain: self.gain,
        })
    }
}

/// The list with exact conjugates, in order.
fn conjugated(values: &[Complex<f64>], what: &'static str) -> Result<Vec<Complex<f64>>, PolyError> {
    for (index, &value) in values.iter().enumerate() {
        if !(value.re.is_finite() && value.im.is_finite()) {
            return Err(PolyError::NonFiniteValue { what, index, value });
        }
    }
    let mut rest: Vec<Complex<f64>> = values.to_vec();
    let mut result = Vec::with_capacity(values.len());
    // From the largest imaginary part down, so that nearly real values are left to be taken as real.
    rest.sort_by(|a, b| a.im.abs().total_cmp(&b.im.abs()).then(a.im.total_cmp(&b.im)));
    while let Some(z) = rest.pop() {
        let close = |w: Complex<f64>| (w - z.conj()).norm() <= CONJUGATE_TOLERANCE * z.norm();
        if z.im == 0.0 {
            result.push(Complex::new(z.re, 0.0));
            continue;
        }
        let nearest = (0..rest.len())
            .filter(|&k| rest[k].im * z.im < 0.0 && close(rest[k]))
            .min_by(|&i, &j| (rest[i] - z.conj()).norm().total_cmp(&(rest[j] - z.conj()).norm()));
        if let Some(k) = nearest {
            let w = rest.remove(k);
            let mean = Complex::new(
                z.re + 0.5 * (w.re - z.re),
                z.im.abs() + 0.5 * (w.im.abs() - z.im.abs()),
            );
            result.push(mean);
            result.push(mean.conj());
        } else if z.im.abs() <= CONJUGATE_TOLERANCE * z.norm() {
            result.push(Complex::new(z.re, 0.0));
        } else {
            return Err(PolyError::NotConjugateClosed { value: z });
        }
    }
    result.sort_by(|&a, &b| order(a, b));
    Ok(result)
}
