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
    assert_eq!(invertible_power_of_two(-3), 0.125);
    assert!(invertible_power_of_two(5000).is_finite() && invertible_power_of_two(-5000) > 0.0);
}

#[test]
fn mantissas_and_exponents_over_the_whole_range() {
    for (x, wanted) in [
        (f64::MAX, 1023),
        (-f64::MIN_POSITIVE, -1022),
        (f64::MIN_POSITIVE / 4.0, -1024),
        (5e-324, -1074),
        (1.0_f64.next_down(), -1),
        (2.0_f64.powi(1000).next_down(), 999),
    ] {
        let (mantissa, power) = split(x).expect("a finite number that isn't 0");
        assert!((1.0..2.0).contains(&mantissa.abs()) && mantissa.signum() == x.signum(), "{x:e}");
        assert_eq!((power, times_power_of_two(mantissa, power)), (wanted, x), "{x:e}");
    }
}

#[test]
fn balancing_before_scaling_loses_no_entry() {
    for a in [
        dmatrix![0.0, 1e300; 1e-300, 0.0],
        dmatrix![1.0, 1e308; 1e-308, 2.0],
        dmatrix![0.0, 1e308; 1.0, 0.0],
        // D spans 2^3000 here.
        dmatrix![0.0, 1e300, 0.0, 0.0; 0.0, 0.0, 1e300, 0.0; 0.0, 0.0, 0.0, 1e300; 1e-300, 0.0, 0.0, 0.0],
    ] {
        let WidelyBalanced { matrix, diagonal, scale } = balance_widely(&a);
        let n = a.nrows();
        let back = DMatrix::from_fn(n, n, |i, j| {
            times_power_of_two(matrix[(i, j)], scale + diagonal[i] - diagonal[j])
        });
        assert_eq!(back, a);
        for (x, y) in matrix.iter().zip(&a) {
            assert_eq!(*x == 0.0, *y == 0.0);
            assert!(*y == 0.0 || (0.01..2.0).contains(x), "{matrix}");
        }
    }
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
