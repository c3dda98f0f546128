use super::*;

#[test]
fn exponents_bracket_the_magnitude() {
    for (value, expected) in [
        (1.0, 0),
        (-1.5, 0),
        (1.99, 0),
        (2.0, 1),
        (0.75, -1),
        (1e300, 996),
        (f64::MAX, 1023),
        (-f64::MIN_POSITIVE, -1022),
        (5e-324, -1022),
        (f64::INFINITY, 1024),
    ] {
        assert_eq!(exponent(value), expected, "{value}");
    }
}

#[test]
fn powers_end_where_doubles_end() {
    for (power, expected) in [
        (0, 1.0),
        (-1022, f64::MIN_POSITIVE),
        (-1074, 5e-324),
        (-1076, 0.0),
        (1024, f64::INFINITY),
        (i32::MIN, 0.0),
    ] {
        assert_eq!(power_of_two(power), expected, "{power}");
    }
    for power in -1074..1023 {
        assert_eq!(power_of_two(power), 0.5 * power_of_two(power + 1), "{power}");
    }
}

#[test]
fn products_reach_from_one_end_of_the_range_to_the_other() {
    assert_eq!(times_power_of_two(3.0 * 2.0_f64.powi(-1000), 2000), 3.0 * 2.0_f64.powi(1000));
    assert_eq!(times_power_of_two(5e-324, 2097), 2.0_f64.powi(1023));
    assert_eq!(times_power_of_two(-1.0, i32::MAX), f64::NEG_INFINITY);
    assert_eq!(times_power_of_two(1.0, i32::MIN), 0.0);
    assert_eq!(times_power_of_two(0.0, i32::MAX), 0.0);
}
