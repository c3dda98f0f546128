use super::*;

#[test]
fn exponents_bracket_the_magnitude() {
    for (value, expected) in
        [(1.0, 0), (1.99, 0), (2.0, 1), (0.75, -1), (f64::MAX, 1023), (5e-324, -1022)]
    {
        assert_eq!(exponent(value), expected, "{value}");
    }
}

#[test]
fn powers_end_where_doubles_end() {
    for (power, expected) in
        [(0, 1.0), (-1074, 5e-324), (-1076, 0.0), (1024, f64::INFINITY), (i32::MIN, 0.0)]
    {
        assert_eq!(power_of_two(power), expected, "{power}");
    }
    assert_eq!(scaled(3.0 * 2.0_f64.powi(-1000), 2000), 3.0 * 2.0_f64.powi(1000));
    assert_eq!(scaled(0.0, i32::MAX), 0.0);
}
