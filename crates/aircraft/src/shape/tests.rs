use num_complex::Complex;

use super::ModeShape;

fn real(value: f64) -> Complex<f64> {
    Complex::new(value, 0.0)
}

#[test]
fn a_yaw_about_a_straight_path_is_all_slip() {
    // Heading psi = -beta, so that r = -lambda beta.
    let eigenvalue = Complex::new(-0.1, 2.0);
    let shape = ModeShape::from_sensors(real(1.0), real(0.0), -eigenvalue);
    let character = shape.character(eigenvalue).unwrap();
    assert_eq!(character.slip_fraction, 1.0);
    assert_eq!(character.roll_fraction, 0.0);
    assert_eq!(character.bank_to_sideslip, Some(0.0));
}

#[test]
fn a_turn_without_slip_is_none_and_rates_compare_by_size() {
    let shape = ModeShape::from_sensors(real(0.0), Complex::new(0.0, 3.0), real(-1.0));
    let character = shape.character(real(-0.5)).unwrap();
    assert_eq!((character.slip_fraction, character.roll_fraction), (0.0, 0.75));
    assert_eq!(character.bank_to_sideslip, None);
}

#[test]
fn the_bank_angle_is_taken_or_follows_from_the_roll_rate() {
    let eigenvalue = Complex::new(0.0, 2.0);
    let sensors = ModeShape::from_sensors(real(0.5), real(3.0), real(1.0));
    assert_eq!(sensors.bank_to_sideslip(eigenvalue), Some(3.0));
    let state = ModeShape::from_state([real(0.5), real(3.0), real(1.0), real(4.0)]);
    assert_eq!(state.bank_to_sideslip(eigenvalue), Some(8.0));
    assert_eq!(sensors.bank_to_sideslip(real(0.0)), None);
}

#[test]
fn a_steady_bank_is_motion_but_a_zero_vector_is_not() {
    let zero = real(0.0);
    let bank = ModeShape::from_state([zero, zero, zero, real(1.0)]).character(zero).unwrap();
    assert_eq!((bank.slip_fraction, bank.roll_fraction), (0.0, 0.0));
    assert!(ModeShape::from_sensors(zero, zero, zero).character(real(-1.0)).is_none());
}
