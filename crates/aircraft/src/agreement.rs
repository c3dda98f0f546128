//! How well one mode agrees with one name, by its shape and by its speed.

use num_complex::Complex;

use crate::mode_name::ModeName;
use crate::shape::Character;

use ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral};

/// Sideslip per bank angle at which a real mode is halfway from rolling or turning to slipping.
///
/// Roll and spiral of the aircraft in `tests/data/lateral.json` have 0.08 and less, with a yaw damper up
/// to 0.2; what a rudder moves by itself (washout filter, actuator) has mostly more than 0.3.
const SIDESLIP_TO_BANK: f64 = 0.2;

/// Turn rate per bank angle, `g / U0`, below which no aircraft turns, rad/s: 3300 m/s.
///
/// A heading integrator and a drifting gyro come to nearly zero.
const TURN_TO_BANK: f64 = 0.003;

/// Usual ratio of roll rate constant to Dutch-roll frequency: the median of the aircraft in
/// `tests/data/lateral.json`, which have 0.3 to 5.
///
/// At `e` times and at a part in `e` of it, a mode is half as likely a roll subsidence.
const ROLL_SPEED: f64 = 0.8;

/// Speed relative to the Dutch roll at which a real mode is half as likely a spiral as a neutral one.
const SPIRAL_SPEED: f64 = 0.3;

/// How well the shape of a mode agrees with a name, 0 to 1; `None` where the name is for the other kind of eigenvalue.
pub(crate) fn of_shape(name: ModeName, oscillatory: bool, character: Character) -> Option<f64> {
    let Character { slip_fraction: slip, roll_fraction: roll, .. } = character;
    let banks = 1.0 / (1.0 + (character.sideslip_to_bank / SIDESLIP_TO_BANK).powi(2));
    let turns = match character.turn_to_bank {
        rate if rate.is_finite() => rate / (rate + TURN_TO_BANK),
        _ => 1.0,
    };
    match (name, oscillatory) {
        (DutchRoll, true) => Some(slip),
        (CoupledRollSpiral, true) => Some(1.0 - slip),
        (RollSubsidence, false) => Some(banks * roll),
        (Spiral, false) => Some(banks * turns),
        (DutchRollRealRoot, false) => Some((1.0 - banks) * slip),
        _ => None,
    }
}

/// How well the speed of a mode agrees with a name, 0 to 1, beside a Dutch roll of this frequency.
pub(crate) fn of_speed(name: ModeName, eigenvalue: Complex<f64>, frequency_rad_s: f64) -> f64 {
    let relative = eigenvalue.norm() / frequency_rad_s;
    match name {
        DutchRoll => eigenvalue.im.abs() / eigenvalue.norm(),
        RollSubsidence => 1.0 / (1.0 + (relative / ROLL_SPEED).ln().powi(2)),
        Spiral => 1.0 / (1.0 + relative / SPIRAL_SPEED),
        CoupledRollSpiral => 1.0 / (1.0 + relative.powi(2)),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests;
