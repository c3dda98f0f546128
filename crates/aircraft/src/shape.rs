//! What a lateral mode looks like in the sensors.

use num_complex::Complex;

/// Components of an eigenvector, up to a common complex factor.
///
/// The states of the model or the readings of sensors do alike: sideslip in rad, rates in rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeShape {
    /// Sideslip angle.
    #[doc(alias = "beta")]
    pub sideslip: Complex<f64>,
    /// Roll rate.
    #[doc(alias = "p")]
    pub roll_rate: Complex<f64>,
    /// Yaw rate.
    #[doc(alias = "r")]
    pub yaw_rate: Complex<f64>,
    /// Bank angle, where it is known; without it, `phi = p / lambda`.
    #[doc(alias = "phi")]
    pub bank_angle: Option<Complex<f64>>,
}

/// What tells the lateral modes apart, from eigenvalue and shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Character {
    /// `|lambda beta| / (|lambda beta| + |r + lambda beta|)`.
    pub(crate) slip_fraction: f64,
    /// `|p| / (|p| + |r|)`.
    pub(crate) roll_fraction: f64,
    /// `|phi| / |beta|`.
    pub(crate) bank_to_sideslip: Option<f64>,
    /// `|beta| / |phi|`, the bank angle being at least what the turn needs; infinite for sideslip alone.
    pub(crate) sideslip_to_bank: f64,
    /// `|r + lambda beta| / |phi|`, rad/s: about `g / U0` in a turn without slipping; infinite without bank.
    pub(crate) turn_to_bank: f64,
}

/// The turn rate per bank angle, `g / U0`, of an aircraft so slow (33 m/s) that most are below, rad/s.
///
/// From it follows the least bank angle that goes with a turn rate. That keeps `|beta| / |phi|` of a slow spiral
/// defined where `p` passes through zero: in a climb `phi' = p + r tan(theta)`, and `p / lambda` is not the bank angle.
const TURN_TO_BANK: f64 = 0.3;

impl ModeShape {
    /// The components of a state vector `[beta, p, r, phi]`.
    #[must_use]
    pub fn from_state([sideslip, roll_rate, yaw_rate, bank_angle]: [Complex<f64>; 4]) -> Self {
        Self { sideslip, roll_rate, yaw_rate, bank_angle: Some(bank_angle) }
    }

    /// The readings of a sideslip vane and two rate gyros.
    #[must_use]
    pub fn from_sensors(
        sideslip: Complex<f64>,
        roll_rate: Complex<f64>,
        yaw_rate: Complex<f64>,
    ) -> Self {
        Self { sideslip, roll_rate, yaw_rate, bank_angle: None }
    }

    /// `|phi| / |beta|`, a usual measure of the Dutch roll; `phi = p / lambda` where the bank angle is not known.
    ///
    /// `None` where it would be a division by zero.
    #[must_use]
    pub fn bank_to_sideslip(&self, eigenvalue: Complex<f64>) -> Option<f64> {
        let bank = self.bank_angle.unwrap_or(self.roll_rate / eigenvalue);
        Some(bank.norm() / self.sideslip.norm()).filter(|ratio| ratio.is_finite())
    }

    pub(crate) fn conj(&self) -> Self {
        Self {
            sideslip: self.sideslip.conj(),
            roll_rate: self.roll_rate.conj(),
            yaw_rate: self.yaw_rate.conj(),
            bank_angle: self.bank_angle.map(|value| value.conj()),
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        [self.sideslip, self.roll_rate, self.yaw_rate]
            .into_iter()
            .chain(self.bank_angle)
            .all(|value| value.re.is_finite() && value.im.is_finite())
    }

    /// `None` for a shape without any lateral motion.
    pub(crate) fn character(&self, eigenvalue: Complex<f64>) -> Option<Character> {
        let slip_rate = eigenvalue * self.sideslip;
        let path_rate = self.yaw_rate + slip_rate;
        let fraction = |part: f64, other: f64| if part > 0.0 { part / (part + other) } else { 0.0 };
        let moves = [self.sideslip, self.roll_rate, self.yaw_rate]
            .into_iter()
            .chain(self.bank_angle)
            .any(|value| value.norm() > 0.0);
        let ratio = |part: f64, of: f64| if part > 0.0 { part / of } else { 0.0 };
        let bank = self
            .bank_angle
            .map_or_else(|| ratio(self.roll_rate.norm(), eigenvalue.norm()), |bank| bank.norm());
        let turning = path_rate.norm();
        moves.then(|| Character {
            slip_fraction: fraction(slip_rate.norm(), turning),
            roll_fraction: fraction(self.roll_rate.norm(), self.yaw_rate.norm()),
            bank_to_sideslip: self.bank_to_sideslip(eigenvalue),
            sideslip_to_bank: ratio(self.sideslip.norm(), bank.max(turning / TURN_TO_BANK)),
            turn_to_bank: ratio(turning, bank),
        })
    }
}

#[cfg(test)]
mod tests;
