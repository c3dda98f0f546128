//! Tests of `scaling.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::dmatrix;

use super::*;

#[test]
fn exponents() {
    for (x, wanted) in
        [(1.0, 0), (-1.5, 0), (2.0, 1), (0.3, -2), (1e300, 996), (0.0, 0), (f64::NAN, 0)]
    {
        assert_eq!(exponent(x), wanted, "{x}");
    }
    assert_eq!(power_of_two(-3), 0.125);
    assert!(power_of_two(5000).is_finite() && power_of_two(-5000) > 0.0);
}

#[test]
fn balancing_undoes_powers_of_two_exactly() {
    let a = dmatrix![1.0, -0.7, 0.4; 0.3, -1.2, 0.9; -0.8, 0.6, 1.1];
    let units = [2.0_f64.powi(30), 1.0, 2.0_f64.powi(-25)];
    let odd = DMatrix::from_fn(3, 3, |i, j| a[(i, j)] * units[j] / units[i]);
    let Balanced { matrix, diagonal, scale } = balance(&(&odd * 2.0_f64.powi(300)));
    let back = DMatrix::from_fn(3, 3, |i, j| matrix[(i, j)] * scale * diagonal[i] / diagonal[j]);
    assert_eq!(back, odd * 2.0_f64.powi(300));
    assert!(matrix.amax() < 4.0 && matrix.amin() > 0.01, "{matrix}");
}

#[test]
fn balancing_leaves_what_it_cannot_help() {
    for a in [
        DMatrix::zeros(3, 3),
        dmatrix![0.0, 1.0; 0.0, 0.0],
        DMatrix::identity(2, 2),
        DMatrix::zeros(0, 0),
    ] {
        let Balanced { matrix, diagonal, scale } = balance(&a);
        assert_eq!(matrix, a);
        assert!(diagonal.iter().all(|&x| x == 1.0) && scale == 1.0);
    }
}

#[test]
fn one_norm_is_the_largest_column_sum() {
    assert_eq!(norm_1(&dmatrix![1.0, -5.0; -3.0, 2.0]), 7.0);
    assert_eq!(norm_1(&DMatrix::zeros(0, 0)), 0.0);
}
