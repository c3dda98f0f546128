use super::*;
use proptest::prelude::*;

#[test]
fn significant_digits() {
    let check = |value: f64, digits, expected: &str| {
        assert_eq!(format_significant(value, digits), expected, "{value:e} with {digits} digits");
    };
    check(0.0, 5, "0");
    check(-0.0, 5, "0");
    check(1.0, 3, "1.00");
    check(-1.0, 1, "-1");
    check(0.0001, 2, "0.00010");
    check(0.00009999, 4, "9.999e-5");
    check(0.000099999, 4, "0.0001000");
    check(0.999_96, 4, "1.000");
    check(999.96, 4, "1000");
    check(-99_950.0, 3, "-100000");
    check(123_456.0, 2, "120000");
    check(999_999.0, 2, "1.0e6");
    check(1_234_567.0, 4, "1.235e6");
    check(1_234_567.0, 9, "1234567.00");
    check(2.5e-150, 2, "2.5e-150");
    check(0.1, 0, "0.1");
    check(0.1, 99, "0.10000000000000001");
    check(f64::NAN, 3, "nan");
    check(f64::INFINITY, 3, "inf");
    check(f64::NEG_INFINITY, 3, "-inf");
    check(f64::MIN_POSITIVE, 3, "2.23e-308");
}

#[test]
fn complex_numbers_and_pairs() {
    assert_eq!(format_complex(0.0, 1.0, 2), "0 + j1.0");
    assert_eq!(format_complex(0.0, -0.0, 2), "0");
    assert_eq!(format_complex(1.0, f64::NAN, 2), "1.0 + jnan");
    assert_eq!(format_conjugate_pair(0.97879, 0.16718, 4), "0.9788 ± j0.1672");
    assert_eq!(format_conjugate_pair(0.5, 0.0, 1), "0.5");
}

proptest! {
    /// What is printed is the number to half a unit of the last digit asked for.
    #[test]
    fn printed_numbers_are_near(mantissa in -9.99..9.99f64, exponent in -200..200i32, digits in 1..=17usize) {
        let value = mantissa * 10f64.powi(exponent);
        let text = format_significant(value, digits);
        let read: f64 = text.parse().unwrap();
        let last = 10f64.powi(1 - i32::try_from(digits).unwrap());
        prop_assert!((read - value).abs() <= 0.5001 * last * value.abs() * 10.0, "{text} for {value:e}");
        let shown = text.trim_start_matches(['-', '0', '.']).split('e').next().unwrap().chars().filter(char::is_ascii_digit).count();
        prop_assert!(value == 0.0 || shown >= digits, "{text} shows {shown} of {digits} digits");
    }
}
