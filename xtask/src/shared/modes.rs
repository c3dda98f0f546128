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
    /// Of the two real poles the roll mode is the faster one.
    pub(crate) fn told_apart(poles: &[Complex<f64>]) -> Result<Self, TaskError> {
        let mut real: Vec<_> = poles.iter().filter(|s| s.im.abs() <= 0.0).copied().collect();
        real.sort_by(|x, y| x.re.total_cmp(&y.re));
        let upper: Vec<_> = poles.iter().filter(|s| s.im > 0.0).copied().collect();
        match (real.as_slice(), upper.as_slice()) {
            ([roll, spiral], [dutch_roll]) => {
                Ok(Self { spiral: *spiral, roll: *roll, dutch_roll: *dutch_roll })
            }
            _ => Err(TaskError::Computation {
                part: "modes",
                message: format!("not two real eigenvalues and one pair: {poles:?}"),
            }),
        }
    }

    /// Spiral, roll, Dutch roll.
    pub(crate) fn list(&self) -> [Complex<f64>; 3] {
        [self.spiral, self.roll, self.dutch_roll]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::paper_aircraft::PaperAircraft;

    #[test]
    fn modes_are_told_apart() {
        let modes = PaperAircraft::new().unwrap().modes;
        assert!((modes.spiral.re + 0.0016).abs() < 1e-4);
        assert!((modes.roll.re + 0.5456).abs() < 1e-4);
        assert!((modes.dutch_roll - Complex::new(-0.0706, 1.6917)).norm() < 1e-4);
        assert!(TrueModes::told_apart(&[Complex::new(1.0, 0.0)]).is_err());
    }
}
