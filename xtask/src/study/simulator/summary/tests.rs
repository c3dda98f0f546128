use super::*;
use crate::study::simulator::kind::{Aircraft, Motion};
use crate::study::simulator::one_run::JudgedMode;

/// A flight of an aircraft with |s| of 0.5, 2 and 4. Errors are those of the real part; the Dutch
/// roll states no standard error.
fn case(errors: PerMode, doubts: &[&str]) -> Case {
    let mode = |error: f64, standard_error| JudgedMode {
        error: error.abs(),
        real_error: error,
        standard_error,
    };
    let [spiral, roll, dutch_roll] = errors;
    with(Ok(Found {
        modes: [mode(spiral, Some(0.125)), mode(roll, Some(0.25)), mode(dutch_roll, None)],
        doubts: doubts.iter().map(|doubt| (*doubt).to_owned()).collect(),
        order: 4,
        model_error: None,
        band_rad_s: None,
    }))
}

fn with(result: Result<Found, String>) -> Case {
    let kind = Kind { motion: Motion::Clean, aircraft: Aircraft::Cub, recorded: false };
    Case { kind, outcome: Outcome { result }, sizes: [0.5, 2.0, 4.0] }
}

#[test]
fn the_spiral_stays_absolute() {
    for (found, expected) in
        case([-0.25, 1.0, -1.0], &[]).errors().into_iter().zip([0.25, 0.5, 0.25])
    {
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
    assert!(with(Err("too short".to_owned())).errors().iter().all(|error| error.is_infinite()));
}

#[test]
fn flights_are_summed_up() {
    let cases = [
        // A roll off by an eighth of |s| is wrong; nobody says so.
        case([0.125, -0.25, 0.0], &[]),
        // The spiral may be off by all its size.
        case([-0.5, 0.125, 0.25], &[]),
        case([0.0, 0.0, 1.0], &["poor-fit"]),
    ];
    let found = Summary::of(&cases);
    assert_eq!(found.flights, 3);
    assert_eq!((found.median, found.worst), ([0.125, 0.0625, 0.0625], [0.5, 0.125, 0.25]));
    // Scores are 1 and -1, -4 and 0.5, 0 and 0.
    assert_eq!((found.within, found.scores), (5, 6));
    assert_eq!((found.trusted, found.wrong, found.wrong_and_trusted), (2, 2, 1));
}

#[test]
fn a_flight_without_a_result_is_wrong_and_not_trusted() {
    let cases = [case([0.125, 0.5, 0.0], &[]), with(Err("too short".to_owned()))];
    let found = Summary::of(&cases);
    assert_eq!((found.trusted, found.wrong, found.wrong_and_trusted), (1, 2, 1));
    assert!(found.worst.iter().all(|error| error.is_infinite()));
    // Scores are 1 and 2, which is not within 2.
    assert_eq!((found.within, found.scores), (1, 2));
}
