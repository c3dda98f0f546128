//! A stretch of two signals without gaps.

use crate::{FitError, error::Signal};

/// Uniformly sampled pseudo input and pseudo output over one stretch of time without gaps.
///
/// Several segments of one transmissibility make one fit: equations never reach across a boundary.
///
/// # Example
///
/// ```
/// use cfi_ident::Segment;
///
/// let segment = Segment::new(&[1.0, 2.0, 4.0], &[0.0, 1.0, 2.0])?;
/// assert_eq!(segment.samples(), 3);
/// assert!(Segment::new(&[1.0, f64::NAN], &[0.0, 1.0]).is_err());
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment<'a> {
    input: &'a [f64],
    output: &'a [f64],
}

impl<'a> Segment<'a> {
    /// Checks the two signals and binds them.
    ///
    /// # Errors
    ///
    /// [`FitError::UnequalLengths`], [`FitError::NotFinite`].
    pub fn new(input: &'a [f64], output: &'a [f64]) -> Result<Self, FitError> {
        if input.len() != output.len() {
            return Err(FitError::UnequalLengths { input: input.len(), output: output.len() });
        }
        check_finite(input, Signal::Input)?;
        check_finite(output, Signal::Output)?;
        Ok(Self { input, output })
    }

    /// The pseudo input `y_i`.
    pub fn input(&self) -> &'a [f64] {
        self.input
    }

    /// The pseudo output `y_o`.
    pub fn output(&self) -> &'a [f64] {
        self.output
    }

    /// Number of samples.
    pub fn samples(&self) -> usize {
        self.input.len()
    }

    /// Samples `from .. to` as a segment of their own.
    #[cfg(feature = "regularized")]
    pub(crate) fn part(&self, from: usize, to: usize) -> Segment<'a> {
        Segment { input: &self.input[from..to], output: &self.output[from..to] }
    }
}

/// Refuses NaN and infinities.
pub(crate) fn check_finite(values: &[f64], signal: Signal) -> Result<(), FitError> {
    // An exponent of all ones carries into the sign. Blocks without one are passed over by a loop that vectorises.
    const EXPONENT: u64 = f64::INFINITY.to_bits();
    const LOWEST: u64 = f64::MIN_POSITIVE.to_bits();
    let carried = |x: &f64| (x.to_bits() & EXPONENT) + LOWEST;
    for (block, values) in values.chunks(BLOCK).enumerate() {
        if values.iter().fold(0, |all, x| all | carried(x)) >> 63 == 0 {
            continue;
        }
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            let value = values[index];
            return Err(FitError::NotFinite { signal, index: block * BLOCK + index, value });
        }
    }
    Ok(())
}

/// Samples that are checked at once.
const BLOCK: usize = 1024;

#[cfg(test)]
mod tests;
