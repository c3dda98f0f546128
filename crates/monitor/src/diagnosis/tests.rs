use super::*;
use crate::Test;

fn window(level: f64, spread: f64) -> Window {
    let test = |off: f64| Test { statistic: off * off, limit: 12.0 };
    Window {
        stretch: 0,
        first: 0,
        known_at: 0,
        tests: [test(level), test(spread)],
        deviations: vec![[level, spread]],
        means: vec![level],
    }
}

#[test]
fn a_jump_and_a_drift_are_told_apart() {
    let noise = |k: usize| (k * k * 7 % 5) as f64 / 5.0 - 0.4;
    let jump: Vec<Window> =
        (0..40).map(|k| window(noise(k) + if k < 20 { 0.0 } else { 6.0 }, 0.0)).collect();
    let drift: Vec<Window> =
        (0..40).map(|k| window(noise(k) + k.saturating_sub(20) as f64 * 0.5, 0.0)).collect();
    assert_eq!(level_change(&jump, 20, 0), Change::Bias);
    assert_eq!(level_change(&drift, 24, 0), Change::Drift);
}

#[test]
fn the_spread_has_two_sides() {
    let of = |windows: &[Window]| spread_change(&windows.iter().collect::<Vec<_>>());
    assert_eq!(of(&[window(0.0, 9.0), window(0.0, 8.0), window(5.0, 0.0)]), Some(Change::Noise));
    assert_eq!(of(&[window(0.0, -9.0)]), Some(Change::Quiet));
    // The edge of a jump.
    let quiet = || window(0.0, 1.0);
    let edge = [window(5.0, 9.0), quiet(), quiet(), quiet(), quiet()];
    assert_eq!(of(&edge), None);
    assert_eq!(of(&[window(5.0, 0.0), window(0.0, 9.0)]), None);
}
