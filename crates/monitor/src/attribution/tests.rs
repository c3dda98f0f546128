//! Which transmissibility an alarm that only all of them together raise is laid to.

use super::*;
use crate::Test;

/// Two transmissibilities: the first is farther off in its level, the second in its spread.
fn window(level: f64, spread: f64) -> Window {
    Window {
        stretch: 0,
        first: 0,
        known_at: 49,
        tests: [level, spread].map(|statistic| Test { statistic, limit: 10.0 }),
        deviations: vec![[-3.0, 0.5], [1.0, -2.5]],
        means: vec![0.0; 2],
    }
}

#[test]
fn the_alarming_test_says_which_is_farthest() {
    assert_eq!(farthest_of_alarm(&window(11.0, 9.0)), 0);
    assert_eq!(farthest_of_alarm(&window(9.0, 11.0)), 1);
    // Both alarm: the one that exceeds its limit by more.
    assert_eq!(farthest_of_alarm(&window(11.0, 12.0)), 1);
    assert_eq!(farthest(&window(9.0, 11.0), TestKind::Level), 0);
}
