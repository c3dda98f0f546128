use super::*;
use nalgebra::{DMatrix, dmatrix};

#[test]
fn the_strength_of_a_direction_is_what_nothing_else_explains() {
    // Variances 9 and 1 along the axes: 9 and 1 there, and less than the mean between.
    let spectrum = Eigen { values: vec![1.0, 9.0], vectors: dmatrix![0.0, 1.0; 1.0, 0.0] };
    let strength = |re: DMatrix<f64>, im: DMatrix<f64>| capon(&spectrum, [&re, &im]);
    let none = DMatrix::zeros(2, 1);
    assert!((strength(dmatrix![1.0; 0.0], none.clone()) - 9.0).abs() < 1e-14);
    assert!((strength(dmatrix![0.0; 1.0], none.clone()) - 1.0).abs() < 1e-14);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert!((strength(dmatrix![half; half], none) - 1.8).abs() < 1e-14);
    assert!((strength(dmatrix![half; 0.0], dmatrix![0.0; half]) - 1.8).abs() < 1e-14);
}

#[test]
fn a_vanishing_variance_is_no_division_by_zero() {
    let spectrum = Eigen { values: vec![-1e-20, 1.0], vectors: DMatrix::identity(2, 2) };
    let strength = capon(&spectrum, [&dmatrix![1.0; 0.0], &DMatrix::zeros(2, 1)]);
    assert!((0.0..1e-10).contains(&strength), "{strength:e}");
}
