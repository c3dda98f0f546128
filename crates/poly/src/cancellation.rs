//! Zeros and poles that nearly coincide, taken out of a real rational function.

#[cfg(test)]
mod tests;

use crate::mroots::check_tolerance;
use crate::{MrootsOptions, Poly, PolyError, Rational, mroots};
use num_complex::Complex;

/// When a zero and a pole cancel.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Cancellation {
    /// Largest distance between a zero and a pole that cancel. Default 1e-6, the distance that the paper uses.
    pub absolute: f64,
    /// The same relative to the larger of their moduli; the wider of the two counts. Default 0.
    pub relative: f64,
    /// How the zeros and poles of a [`Rational`] are found.
    pub roots: MrootsOptions,
}

impl Default for Cancellation {
    fn default() -> Self {
        Self { absolute: 1e-6, relative: 0.0, roots: MrootsOptions::default() }
    }
}

impl Cancellation {
    /// Cancels up to the given distance.
    pub fn within(absolute: f64) -> Self {
        Self { absolute, ..Self::default() }
    }
}

/// A zero and a pole and how far apart they are.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CancelledPair {
    /// The zero.
    pub zero: Complex<f64>,
    /// The pole.
    pub pole: Complex<f64>,
    /// Their distance.
    pub distance: f64,
}

/// What is left after cancelling, and what was cancelled.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Cancelled {
    /// The function that is left. Nothing cancelled: the function as it was given.
    pub rational: Rational<f64>,
    /// What was cancelled, closest first; of a conjugate pair both members, one after the other.
    pub pairs: Vec<CancelledPair>,
    /// The closest zero and pole that were left; `None` if there are no more zeros or no more poles.
    pub closest_left: Option<CancelledPair>,
    /// The zeros that are left.
    pub zeros: Vec<Complex<f64>>,
    /// The poles that are left.
    pub poles: Vec<Complex<f64>>,
    /// The quotient of the leading coefficients.
    pub gain: f64,
}

impl Rational<f64> {
    /// The function without the zeros and poles that lie within a distance of each other.
    ///
    /// The closest pairs go first, a conjugate pair together with its conjugate. The rest is expanded in doubled
    /// precision and rounded once; its denominator is monic.
    ///
    /// # Errors
    /// As [`mroots()`](crate::mroots()), [`PolyError::InvalidTolerance`], [`PolyError::NonFiniteValue`] if the gain overflows,
    /// [`PolyError::Overflow`] if a coefficient does.
    ///
    /// # Example
    /// ```
    /// use poly::{Cancellation, Poly, Rational};
    ///
    /// // 2 (x - 1)(x - 3) / ((x - 1.0000001)(x + 5))
    /// let numerator = Poly::from_roots(&[1.0, 3.0]).scale(&2.0);
    /// let r = Rational::new(numerator, Poly::from_roots(&[1.0000001, -5.0]))?;
    /// let cancelled = r.cancel(&Cancellation::default())?;
    /// assert_eq!(cancelled.pairs.len(), 1);
    /// assert!((cancelled.pairs[0].distance - 1e-7).abs() < 1e-15);
    /// assert!((cancelled.zeros[0].re - 3.0).abs() < 1e-14);
    /// assert_eq!(cancelled.rational.denominator().degree(), Some(1));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn cancel(&self, options: &Cancellation) -> Result<Cancelled, PolyError> {
        let poles = mroots(self.denominator(), &options.roots)?.values();
        let (zeros, gain) = match (self.numerator().leading(), self.denominator().leading()) {
            (Some(top), Some(bottom)) => {
                (mroots(self.numerator(), &options.roots)?.values(), top / bottom)
            }
            _ => (Vec::new(), 0.0),
        };
        let mut cancelled = cancelled(&zeros, &poles, gain, options)?;
        if cancelled.pairs.is_empty() {
            cancelled.rational = self.clone();
        }
        Ok(cancelled)
    }
}

/// `gain (x - z_1) .. (x - z_m) / ((x - p_1) .. (x - p_n))` without the zeros and poles that cancel.
fn cancelled(
    zeros: &[Complex<f64>],
    poles: &[Complex<f64>],
    gain: f64,
    options: &Cancellation,
) -> Result<Cancelled, PolyError> {
    if !gain.is_finite() {
        let value = Complex::new(gain, 0.0);
        return Err(PolyError::NonFiniteValue { what: "gain", index: 0, value });
    }
    let Left { zeros, poles, pairs, closest_left } = cancel_lists(zeros, poles, options)?;
    let numerator = Poly::real_from_roots(&zeros)?.scale(&gain);
    if let Some(degree) = numerator.coefficients().iter().position(|c| !c.is_finite()) {
        return Err(PolyError::Overflow { degree });
    }
    let rational = Rational::new(numerator, Poly::real_from_roots(&poles)?)?;
    Ok(Cancelled { rational, pairs, closest_left, zeros, poles, gain })
}

/// The lists that are left, and what was taken out of them.
struct Left {
    zeros: Vec<Complex<f64>>,
    poles: Vec<Complex<f64>>,
    pairs: Vec<CancelledPair>,
    closest_left: Option<CancelledPair>,
}

/// Takes out the closest pairs first. Both lists hold reals and exactly conjugate pairs, and so does the result:
/// a real value only cancels a real one, a pair only a pair.
fn cancel_lists(
    zeros: &[Complex<f64>],
    poles: &[Complex<f64>],
    options: &Cancellation,
) -> Result<Left, PolyError> {
    check_tolerance("absolute", options.absolute)?;
    check_tolerance("relative", options.relative)?;
    let (mut zeros, mut poles) = (zeros.to_vec(), poles.to_vec());
    let mut pairs = Vec::new();
    while let Some(pair) = closest(&zeros, &poles) {
        let CancelledPair { zero, pole, distance } = pair;
        let reach = options.absolute.max(options.relative * zero.norm().max(pole.norm()));
        if distance > reach {
            break;
        }
        remove(&mut zeros, zero);
        remove(&mut poles, pole);
        pairs.push(pair);
        if zero.im != 0.0 {
            remove(&mut zeros, zero.conj());
            remove(&mut poles, pole.conj());
            pairs.push(CancelledPair { zero: zero.conj(), pole: pole.conj(), distance });
        }
    }
    let closest_left = closest(&zeros, &poles);
    Ok(Left { zeros, poles, pairs, closest_left })
}

fn closest(zeros: &[Complex<f64>], poles: &[Complex<f64>]) -> Option<CancelledPair> {
    let mut best: Option<CancelledPair> = None;
    for &zero in zeros {
        for &pole in poles {
            let kind = |z: Complex<f64>| z.im.partial_cmp(&0.0);
            let distance = (zero - pole).norm();
            if kind(zero) == kind(pole) && best.is_none_or(|b| distance < b.distance) {
                best = Some(CancelledPair { zero, pole, distance });
            }
        }
    }
    best
}

fn remove(list: &mut Vec<Complex<f64>>, value: Complex<f64>) {
    if let Some(k) = list.iter().position(|&v| v == value) {
        list.remove(k);
    }
}
