use super::*;

#[test]
fn powers_are_found() {
    for power in [-1.0, 0.0, 0.5, 1.0, 2.0] {
        let points: Vec<_> =
            [1e1, 1e2, 3e2, 1e5].iter().map(|x: &f64| (*x, 7e-9 * x.powf(power))).collect();
        assert!((log_log_slope(&points).unwrap() - power).abs() < 1e-12, "{power}");
    }
}

#[test]
fn scatter_is_averaged() {
    // log10 y = 0, 2, 1 over log10 x = 0, 1, 2: by hand the slope is 1/2.
    let slope = log_log_slope(&[(1.0, 1.0), (10.0, 100.0), (100.0, 10.0)]).unwrap();
    assert!((slope - 0.5).abs() < 1e-14);
}

#[test]
fn there_is_no_slope_without_two_places() {
    for points in [
        &[][..],
        &[(1.0, 1.0)],
        &[(2.0, 1.0), (2.0, 3.0)],
        &[(1.0, 1.0), (2.0, 0.0)],
        &[(-1.0, 1.0), (2.0, 1.0)],
        &[(1.0, f64::NAN), (2.0, 1.0)],
    ] {
        assert_eq!(log_log_slope(points), None, "{points:?}");
    }
}
