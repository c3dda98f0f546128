//! How numbers stand beside their deviations.

use super::with_deviation;

#[test]
fn two_digits_of_the_deviation() {
    let check = |value: f64, deviation: f64, expected: &str| {
        assert_eq!(with_deviation(value, deviation), expected.replace('-', "\u{2212}"));
    };
    check(1.692_345, 0.0012, "1.6923 ± 0.0012");
    check(-0.070_594, 0.000_53, "-0.07059 ± 0.00053");
    check(443.2, 1210.0, "443 ± 1210");
    check(1.0, 0.0999, "1.00 ± 0.10");
    check(2.5, 0.0, "2.5000");
    check(2.5, f64::INFINITY, "2.5000");
}
