use num_complex::Complex;

use super::{of_shape, of_speed};
use crate::ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral};
use crate::shape::Character;

const CHARACTER: Character = Character {
    slip_fraction: 0.25,
    roll_fraction: 0.8,
    bank_to_sideslip: None,
    sideslip_to_bank: 0.2,
    turn_to_bank: 0.009,
};

#[test]
fn shapes_agree_as_the_table_says() {
    // |beta / phi| = 0.2 makes b = 1/2; k / (k + 0.003) = 3/4.
    let of = |name, oscillatory| of_shape(name, oscillatory, CHARACTER);
    assert_eq!(of(DutchRoll, true), Some(0.25));
    assert_eq!(of(CoupledRollSpiral, true), Some(0.75));
    assert_eq!(of(RollSubsidence, false), Some(0.4));
    assert!((of(Spiral, false).unwrap() - 0.375).abs() < 1e-15);
    assert_eq!(of(DutchRollRealRoot, false), Some(0.125));
    for name in [DutchRoll, CoupledRollSpiral] {
        assert_eq!(of(name, false), None);
    }
    for name in [RollSubsidence, Spiral, DutchRollRealRoot] {
        assert_eq!(of(name, true), None);
    }
}

#[test]
fn sideslip_or_yaw_without_bank() {
    // |beta| / 0 and |r| / 0 are infinite: slipping alone is no spiral, turning alone may be one.
    let slipping = Character { sideslip_to_bank: f64::INFINITY, ..CHARACTER };
    assert_eq!(of_shape(Spiral, false, slipping), Some(0.0));
    let turning = Character { sideslip_to_bank: 0.0, turn_to_bank: f64::INFINITY, ..CHARACTER };
    assert_eq!(of_shape(Spiral, false, turning), Some(1.0));
}

#[test]
fn speeds_count_relative_to_the_dutch_roll() {
    let at = |name, rate: f64| of_speed(name, Complex::new(rate, 0.0), 2.0);
    assert_eq!(at(RollSubsidence, -1.6), 1.0);
    assert_eq!(at(RollSubsidence, 0.0), 0.0);
    for factor in [1.0_f64.exp(), (-1.0_f64).exp()] {
        assert!((at(RollSubsidence, -1.6 * factor) - 0.5).abs() < 1e-15);
    }
    assert_eq!((at(Spiral, 0.0), at(Spiral, 0.6)), (1.0, 0.5));
    assert_eq!(at(CoupledRollSpiral, -2.0), 0.5);
    // Of two pairs the one that oscillates more: the imaginary part over the modulus.
    assert_eq!(of_speed(DutchRoll, Complex::new(-3.0, 4.0), 5.0), 0.8);
}
