//! The modes that a reconstruction is to find.

use num_complex::Complex;

use crate::TaskError;

/// A number for each mode: spiral, roll, Dutch roll.
pub(crate) type PerMode = [f64; 3];

/// The modes in the order of all triples.
pub(crate) const MODES: [&str; 3] = ["spiral", "roll", "Dutch roll"];

/// The eigenvalues that a reconstruction is to find, in 1/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrueModes {
    pub(crate) spiral: Complex<f64>,
    pub(crate) roll: Complex<f64>,
    /// The one with positive imaginary part.
    pub(crate) dutch_roll: Complex<f64>,
}

impl TrueModes {
    /// Spiral, roll, Dutch roll.
    pub(crate) fn list(&self) -> [Complex<f64>; 3] {
        [self.spiral, self.roll, self.dutch_roll]
    }
}

/// Of the two real eigenvalues the roll mode is the faster one.
pub(crate) fn told_apart(poles: &[Complex<f64>]) -> Result<TrueModes, TaskError> {
    let mut real: Vec<_> = poles.iter().filter(|s| s.im.abs() <= 0.0).copied().collect();
    real.sort_by(|x, y| x.re.total_cmp(&y.re));
    let upper: Vec<_> = poles.iter().filter(|s| s.im > 0.0).copied().collect();
    match (real.as_slice(), upper.as_slice()) {
        ([roll, spiral], [dutch_roll]) => {
            Ok(TrueModes { spiral: *spiral, roll: *roll, dutch_roll: *dutch_roll })
        }
        _ => Err(TaskError::Computation {
            part: "modes",
            message: format!("not two real eigenvalues and one pair: {poles:?}"),
        }),
    }
}

#[cfg(test)]
mod tests;
