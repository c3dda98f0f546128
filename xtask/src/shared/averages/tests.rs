use super::*;

#[test]
fn middle_and_bins() {
    assert!((median(&[3.0, 1.0, 2.0]) - 2.0).abs() < 1e-15);
    assert!((median(&[4.0, 1.0, 2.0, 3.0]) - 2.5).abs() < 1e-15);
    assert!(median(&[]).is_nan());
    let bins = histogram(&[-9.0, -0.5, 0.0, 0.5, 9.0], (-1.0, 1.0), 2);
    assert_eq!(bins, [(-1.0, 0.0, 0.4), (0.0, 1.0, 0.6)]);
}

#[test]
fn a_quantile_is_one_of_the_values() {
    let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
    for (part, expected) in [(0.05, 5.0), (0.5, 50.0), (0.95, 95.0), (1.0, 100.0)] {
        assert!((quantile(&values, part) - expected).abs() < 1e-15);
    }
    assert!(quantile(&[], 0.5).is_nan());
}
