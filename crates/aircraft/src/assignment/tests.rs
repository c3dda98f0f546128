use super::{COMPLETE_SETS, by_shape, permutations};
use crate::mode_name::ModeName;
use crate::shape::Character;

use ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral};

fn character(slip_fraction: f64, roll_fraction: f64) -> Option<Character> {
    Some(Character { slip_fraction, roll_fraction, bank_to_sideslip: None })
}

fn check(modes: &[(bool, f64, f64)], expected: &[ModeName]) {
    let oscillatory: Vec<bool> = modes.iter().map(|mode| mode.0).collect();
    let characters: Vec<Option<Character>> =
        modes.iter().map(|mode| character(mode.1, mode.2)).collect();
    let names: Vec<ModeName> =
        by_shape(&oscillatory, &characters).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, expected, "{modes:?}");
}

#[test]
fn a_complete_set_is_named_as_a_whole() {
    check(
        &[(true, 0.9, 0.5), (false, 0.0, 0.9), (false, 0.0, 0.1)],
        &[DutchRoll, RollSubsidence, Spiral],
    );
    // Both real ones roll more than they turn; the one that rolls more is the roll subsidence.
    check(
        &[(false, 0.1, 0.7), (false, 0.1, 0.8), (true, 0.9, 0.5)],
        &[Spiral, RollSubsidence, DutchRoll],
    );
    // A pair that slips a little less than half is a Dutch roll if the others roll and turn.
    check(
        &[(true, 0.45, 0.5), (false, 0.0, 0.9), (false, 0.0, 0.1)],
        &[DutchRoll, RollSubsidence, Spiral],
    );
    check(
        &[(true, 0.1, 0.5), (false, 0.9, 0.5), (false, 0.8, 0.5)],
        &[CoupledRollSpiral, DutchRollRealRoot, DutchRollRealRoot],
    );
    check(&[(true, 0.6, 0.5), (true, 0.7, 0.5)], &[CoupledRollSpiral, DutchRoll]);
    check(
        &[(false, 0.1, 0.1), (false, 0.9, 0.1), (false, 0.1, 0.9), (false, 0.9, 0.9)],
        &[Spiral, DutchRollRealRoot, RollSubsidence, DutchRollRealRoot],
    );
}

#[test]
fn all_orders_are_tried() {
    assert_eq!(permutations(&[]), vec![Vec::<ModeName>::new()]);
    assert_eq!(
        permutations(COMPLETE_SETS[2]),
        vec![vec![DutchRoll, CoupledRollSpiral], vec![CoupledRollSpiral, DutchRoll]]
    );
    assert_eq!(permutations(COMPLETE_SETS[3]).len(), 24);
}
