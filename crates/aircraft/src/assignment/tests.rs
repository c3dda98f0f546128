use num_complex::Complex;

use super::{Candidate, by_shape};
use crate::ModeShape;
use crate::mode_name::{ModeName, WhyUnnamed};

use ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral, Unnamed};

const LEFT_OVER: ModeName = Unnamed(WhyUnnamed::BetterClaim);

/// A pair with this slip fraction.
fn pair(frequency_rad_s: f64, slip_fraction: f64) -> Candidate {
    // r + lambda beta = (1 - s) / s times lambda beta.
    let eigenvalue = Complex::new(-0.1, (frequency_rad_s.powi(2) - 0.01).sqrt());
    let yaw_rate = eigenvalue * ((1.0 - slip_fraction) / slip_fraction - 1.0);
    candidate(eigenvalue, Complex::new(1.0, 0.0), eigenvalue, yaw_rate)
}

/// A real mode with bank angle 1.
fn real(rate: f64, sideslip: f64, yaw_rate: f64) -> Candidate {
    let complex = |value: f64| Complex::new(value, 0.0);
    candidate(complex(rate), complex(sideslip), complex(rate), complex(yaw_rate))
}

fn candidate(
    eigenvalue: Complex<f64>,
    sideslip: Complex<f64>,
    roll_rate: Complex<f64>,
    yaw_rate: Complex<f64>,
) -> Candidate {
    let character = ModeShape::from_sensors(sideslip, roll_rate, yaw_rate).character(eigenvalue);
    Candidate { eigenvalue, oscillatory: eigenvalue.im > 0.0, character }
}

fn check(modes: &[Candidate], expected: &[ModeName]) {
    let names: Vec<ModeName> = by_shape(modes).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, expected, "{modes:?}");
}

/// Turns at g/U0 = 0.05 rad/s, as all three do without sideslip.
const TURN: f64 = 0.05;

#[test]
fn roll_and_spiral_differ_by_speed() {
    let dutch_roll = pair(1.5, 0.9);
    check(
        &[dutch_roll, real(-0.01, 0.0, TURN), real(-1.0, 0.0, TURN)],
        &[DutchRoll, Spiral, RollSubsidence],
    );
    // The spiral of a damped aircraft rolls more than it yaws, and may come close.
    check(
        &[real(-0.55, 0.01, TURN), dutch_roll, real(-0.45, 0.01, TURN)],
        &[RollSubsidence, DutchRoll, Spiral],
    );
    // Only shapes that contradict strongly turn them round: p/r of 200 against 0.06.
    check(
        &[dutch_roll, real(-0.5, 0.0, 0.0025), real(-0.6, 0.0, 10.0)],
        &[DutchRoll, RollSubsidence, Spiral],
    );
    check(
        &[dutch_roll, real(-0.5, 0.0, TURN), real(-0.6, 0.0, 1.0)],
        &[DutchRoll, Spiral, RollSubsidence],
    );
}

#[test]
fn what_the_rudder_moves_by_itself_is_left_over() {
    let (dutch_roll, roll, spiral) =
        (pair(1.8, 0.9), real(-1.14, 0.0, TURN), real(-0.0075, 0.003, TURN));
    for washout in [real(-0.6, 0.07, -0.05), real(-0.6, 0.5, -0.4), real(-3.0, 0.5, 1.4)] {
        check(
            &[washout, dutch_roll, spiral, roll],
            &[LEFT_OVER, DutchRoll, Spiral, RollSubsidence],
        );
    }
}

#[test]
fn four_states_get_all_names_and_more_do_not() {
    // Little fits a roll subsidence here; among four states it is the one that is left.
    let (dutch_roll, spiral, odd) = (pair(1.5, 0.9), real(-0.01, 0.0, TURN), real(-1.0, 0.6, 0.5));
    check(&[dutch_roll, spiral, odd], &[DutchRoll, Spiral, RollSubsidence]);
    check(&[dutch_roll, spiral, odd, odd], &[DutchRoll, Spiral, LEFT_OVER, LEFT_OVER]);
}

#[test]
fn a_second_pair_is_the_coupled_roll_spiral_only_in_their_place() {
    let (fast, slow) = (pair(1.7, 0.9), pair(0.3, 0.1));
    check(&[slow, fast], &[CoupledRollSpiral, DutchRoll]);
    check(&[pair(1.7, 0.6), pair(1.5, 0.7)], &[CoupledRollSpiral, DutchRoll]);
    let (roll, spiral) = (real(-1.0, 0.0, TURN), real(-0.01, 0.0, TURN));
    check(&[slow, fast, roll, spiral], &[LEFT_OVER, DutchRoll, RollSubsidence, Spiral]);
    check(&[slow, fast, spiral], &[LEFT_OVER, DutchRoll, Spiral]);
    // A mode that is neither roll nor spiral does not keep the two from having merged.
    let washout = real(-0.5, 2.0, -1.5);
    check(&[slow, fast, washout], &[CoupledRollSpiral, DutchRoll, LEFT_OVER]);
}

#[test]
fn the_dutch_roll_has_real_roots_only_where_there_is_no_pair() {
    let (away, back) = (real(1.2, 3.0, -3.5), real(-1.5, 3.0, 4.4));
    let (roll, spiral) = (real(-2.0, 0.0, TURN), real(-0.05, 0.0, TURN));
    check(
        &[spiral, away, roll, back],
        &[Spiral, DutchRollRealRoot, RollSubsidence, DutchRollRealRoot],
    );
    let names = by_shape(&[away, pair(1.5, 0.9), back, roll, spiral]);
    assert!(names.iter().all(|(name, _)| *name != DutchRollRealRoot), "{names:?}");
    assert_eq!(names[1].0, DutchRoll);
    // One root is half a Dutch roll.
    check(&[away], &[LEFT_OVER]);
}

#[test]
fn a_heading_integrator_and_a_drifting_gyro_are_no_spiral() {
    let airframe = [pair(1.5, 0.9), real(-0.01, 0.0, TURN), real(-1.0, 0.0, TURN)];
    let (zero, one) = (Complex::new(0.0, 0.0), Complex::new(1.0, 0.0));
    // Heading alone moves; what the other sensors read is rounding or noise.
    let heading = candidate(Complex::new(-1e-7, 0.0), one * 1e-9, one * 2e-9, one * -3e-9);
    let drift = candidate(Complex::new(-0.002, 0.0), zero, one, zero);
    for extra in [heading, drift] {
        let [a, b, c] = airframe;
        check(&[extra, a, b, c], &[LEFT_OVER, DutchRoll, Spiral, RollSubsidence]);
    }
    let still = candidate(zero, zero, zero, zero);
    check(&[still], &[Unnamed(WhyUnnamed::NoLateralMotion)]);
}
