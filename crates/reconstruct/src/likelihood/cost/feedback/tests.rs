use super::*;
use crate::likelihood::fixtures::{Normal, system};
use num_complex::Complex;

#[test]
fn moves_poles_inside_the_unit_circle() {
    let eigenvalues = [Complex::new(1.0, 0.0), Complex::new(0.6, 0.8), Complex::new(1.1, 0.0)];
    let model = system(&eigenvalues, 2, 1, &mut Normal::new(1));
    let gain = feedback(&model.a, &model.b[0]);
    let closed = &model.a + &model.b[0] * gain.transpose();
    let largest = closed.complex_eigenvalues().iter().map(|z| z.norm()).fold(0.0, f64::max);
    assert!(largest < 0.95, "{largest}");
}

#[test]
fn a_scalar_by_hand() {
    // a = 2, b = 1: X = 4 X / (1 + X) + 1, X = 2 + sqrt 5; k = -2 X / (1 + X), a + k = 2 / (3 + sqrt 5).
    let gain = feedback(&DMatrix::from_element(1, 1, 2.0), &DVector::from_element(1, 1.0));
    assert!((2.0 + gain[0] - 2.0 / (3.0 + 5.0_f64.sqrt())).abs() < 1e-12);
}

#[test]
fn what_cannot_be_moved_is_left() {
    // The unstable state is out of reach; no direction at all.
    let a = DMatrix::from_diagonal(&DVector::from_column_slice(&[0.5, 2.0]));
    let none = feedback(&a, &DVector::from_column_slice(&[1.0, 0.0]));
    assert!(none.norm() == 0.0 && feedback(&a, &DVector::zeros(2)).norm() == 0.0);
}
