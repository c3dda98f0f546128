//! Angles that jump by a turn, as a heading does at north.

use std::f64::consts::TAU;

/// A jump is so near to a turn, as a part of it ..
const JUMP: f64 = 0.15;

/// .. and other steps are no longer than this part of it.
const STEP: f64 = 0.15;

/// Fewer samples than this say too little.
const FEWEST: usize = 20;

/// The turn at which a channel wraps, in its unit after conversion: 2 pi where that is radians,
/// 2 pi or 360 where no unit is stated.
pub(crate) fn turn(values: &[f64], si: Option<&str>) -> Option<f64> {
    let candidates: &[f64] = match si {
        Some("rad") => &[TAU],
        None => &[TAU, 360.0],
        Some(_) => return None,
    };
    candidates.iter().copied().find(|turn| wraps(values, *turn))
}

/// Whether all values lie within a turn, and all steps are either small or nearly a turn.
fn wraps(values: &[f64], turn: f64) -> bool {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut before, mut jumps) = (f64::NAN, 0_usize);
    for &value in values.iter().filter(|value| !value.is_nan()) {
        (low, high) = (low.min(value), high.max(value));
        let step = (value - before).abs();
        if (step - turn).abs() <= JUMP * turn {
            jumps += 1;
        } else if step > STEP * turn {
            return false;
        }
        before = value;
    }
    values.len() >= FEWEST && jumps > 0 && high - low <= 1.01 * turn
}

/// Has values go on beyond the turn.
pub(crate) fn unwrap(values: &mut [f64], turn: f64) {
    let (mut before, mut turns) = (f64::NAN, 0.0);
    for value in values.iter_mut().filter(|value| !value.is_nan()) {
        let step = *value - before;
        if step.abs() > turn / 2.0 {
            turns -= step.signum();
        }
        before = *value;
        *value += turns * turn;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heading_goes_on_beyond_north() {
        for (turn_at, si, low, middle) in
            [(TAU, Some("rad"), 0.0, 0.9), (TAU, None, -TAU / 2.0, 1.4), (360.0, None, 0.0, 0.9)]
        {
            let smooth: Vec<f64> =
                (0..400).map(|k| turn_at * (middle + 0.4 * (f64::from(k) / 30.0).sin())).collect();
            let mut wrapped: Vec<f64> =
                smooth.iter().map(|x| (x - low).rem_euclid(turn_at) + low).collect();
            wrapped[77] = f64::NAN;
            let turn = turn(&wrapped, si).expect("it wraps");
            assert!((turn - turn_at).abs() <= 0.0);
            unwrap(&mut wrapped, turn);
            let offset = wrapped[0] - smooth[0];
            assert!((offset / turn - (offset / turn).round()).abs() < 1e-12);
            for (k, (found, wanted)) in wrapped.iter().zip(&smooth).enumerate() {
                assert!(k == 77 || (found - wanted - offset).abs() < 1e-9 * turn_at, "{k}");
            }
        }
    }

    #[test]
    fn other_jumps_are_left_alone() {
        let smooth: Vec<f64> = (0..400).map(|k| 3.0 * (f64::from(k) / 30.0).sin()).collect();
        assert_eq!(turn(&smooth, Some("rad")), None);
        let mut spike = smooth.clone();
        spike[50] = 100.0;
        assert_eq!(turn(&spike, None), None);
        // A speed does not wrap.
        let steps: Vec<f64> = (0..400).map(|k| f64::from(k % 360)).collect();
        assert_eq!(turn(&steps, Some("m/s")), None);
        assert!(turn(&steps, None).is_some());
        assert_eq!(turn(&[], None), None);
    }
}
