use super::*;

#[test]
fn what_is_learnt_is_the_missing_curvature() {
    // A quadratic of which the Gram matrix misses a part: the secant condition holds after each update.
    let gram = DMatrix::from_diagonal(&DVector::from_column_slice(&[2.0, 1.0]));
    let curvature = DMatrix::from_row_slice(2, 2, &[3.0, 0.5, 0.5, 0.7]);
    let mut missed = DMatrix::zeros(2, 2);
    for step in [[1.0, 0.2], [-0.3, 1.0]] {
        let step = DVector::from_column_slice(&step);
        let change = &curvature * &step;
        learn(&mut missed, &change, &gram, &step);
        let explained = (&gram + &missed) * &step;
        assert!((explained - change).norm() < 1e-14);
    }
    let error = (&gram + &missed - &curvature).norm();
    assert!(error < 0.5 * (&gram - &curvature).norm(), "{error}");
}
