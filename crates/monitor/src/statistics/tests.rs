use super::*;

#[test]
fn limits_are_those_of_the_tables() {
    // F(1, 10) = 4.9646, F(3, 20) = 3.0984 at 5 %; F(2, 60) = 7.7678 at 0.1 %.
    for (p, n, probability, quantile) in
        [(1, 11, 0.05, 4.9646), (3, 23, 0.05, 3.0984), (2, 62, 0.001, 7.7678)]
    {
        let factor = p as f64 * (n - 1) as f64 / (n - p) as f64;
        let found = limit(p, n, probability);
        assert!((found / (factor * quantile) - 1.0).abs() < 1e-4, "{p} {n}: {found}");
    }
    // With many observations a square of one component: 1e-9 is 6.1094 deviations to either side.
    assert!((limit(1, 10_000_000, 1e-9).sqrt() - 6.1094).abs() < 1e-3);
}

#[test]
fn distances_allow_for_the_covariance() {
    let sample: Vec<DVector<f64>> =
        [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]].map(|x| x.to_vec().into()).into();
    let healthy = Healthy::of(&sample).unwrap();
    // S = 4/3 I; the mean of four adds a quarter to the variance.
    let off: DVector<f64> = vec![2.0, 0.0].into();
    assert!((healthy.distance(&off) - 3.0 / 1.25).abs() < 1e-12);
    assert!((healthy.scaled(&off)[0] - (3.0_f64 / 1.25).sqrt()).abs() < 1e-12);
    let still: DVector<f64> = vec![1.0, 2.0].into();
    let still = Healthy::of(&[still.clone(), still.clone(), still]);
    assert!(matches!(still, Err(MonitorError::Degenerate)));
}

#[test]
fn binomial_tails() {
    assert!((at_least(1, 10, 0.01) - (1.0 - 0.99_f64.powi(10))).abs() < 1e-12);
    assert!((at_least(3, 3, 0.5) - 0.125).abs() < 1e-12);
    assert!((at_least(0, 5, 0.1) - 1.0).abs() < 1e-12);
    assert!(at_least(4, 3, 0.5).abs() < 1e-12);
}
