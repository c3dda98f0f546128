use super::*;

#[test]
fn doubles_are_integers_times_powers_of_two() {
    for x in [1.0, -0.1, 3e300, f64::MIN_POSITIVE, 5e-324, -1.5e-310, 2.0_f64.powi(60) + 256.0] {
        let (mantissa, exponent) = parts(x).unwrap();
        let half = exponent / 2;
        let rebuilt = mantissa as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half);
        assert_eq!(rebuilt.to_bits(), x.to_bits(), "{x}");
    }
    assert_eq!(parts(0.0), None);
}

#[test]
fn a_small_problem_by_hand() {
    // Normal equations [2 1; 1 2] b = [1; 2]: b = (0, 1).
    let solution = least_squares(&[&[1.0, 1.0, 0.0], &[0.0, 1.0, 1.0]], &[0.0, 1.0, 1.0]).unwrap();
    assert_eq!(solution, [0.0, 1.0]);
    // With the target (1, 0, 0): [2 1; 1 2] b = [1; 0], b = (2/3, -1/3).
    let solution = least_squares(&[&[1.0, 1.0, 0.0], &[0.0, 1.0, 1.0]], &[1.0, 0.0, 0.0]).unwrap();
    assert_eq!(solution, [2.0 / 3.0, -1.0 / 3.0]);
}

#[test]
fn nearly_dependent_columns_do_no_harm() {
    // x_2 = x_1 + e with e = (2^-50, 0, -2^-50): t = 3 x_1 + 5 e = -2 x_1 + 5 x_2, and condition
    // about 2^51.
    let e = 2.0_f64.powi(-50);
    let (first, second) = ([1.0, 1.0, 1.0], [1.0 + e, 1.0, 1.0 - e]);
    let target = [3.0 + 5.0 * e, 3.0, 3.0 - 5.0 * e];
    // Is the target representable? Otherwise the problem would be another one.
    assert_eq!([target[0] - 3.0, 3.0 - target[2]].map(f64::to_bits), [(5.0 * e).to_bits(); 2]);
    let solution = least_squares(&[&first, &second], &target).unwrap();
    assert_eq!(solution, [-2.0, 5.0]);
}

#[test]
fn scales_do_not_matter() {
    let solution = least_squares(&[&[1e-200, 2e-200]], &[3e-200, 6e-200]).unwrap();
    assert!((solution[0] - 3.0).abs() < 1e-14);
}

#[test]
fn what_has_no_solution_is_none() {
    assert_eq!(least_squares(&[&[1.0, 2.0], &[2.0, 4.0]], &[1.0, 1.0]), None);
    assert_eq!(least_squares(&[&[1.0, f64::NAN]], &[1.0, 1.0]), None);
    assert_eq!(least_squares(&[&[0.0, 0.0]], &[1.0, 1.0]), None);
}
