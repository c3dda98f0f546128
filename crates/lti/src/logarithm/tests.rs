//! Tests of `logarithm.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use core::f64::consts::PI;

use nalgebra::dmatrix;

use super::*;

fn check(a: &DMatrix<f64>, wanted: &DMatrix<f64>, limit: f64) {
    let got = logarithm(a).expect("a logarithm");
    let error = (&got.value - wanted).amax() / wanted.amax().max(f64::MIN_POSITIVE);
    assert!(error <= limit, "log({a}) = {}, not {wanted}: {error:e}", got.value);
}

#[test]
fn closed_forms() {
    check(&DMatrix::identity(3, 3), &DMatrix::zeros(3, 3), 0.0);
    for x in [1e-12_f64, 0.3, 0.999_999, 1.0 + 1e-10, 7.0, 1e150] {
        check(&dmatrix![x], &dmatrix![x.ln()], 1e-15);
    }
    for angle in [1e-8_f64, 0.4, 2.0, PI - 1e-6] {
        let (s, c) = angle.sin_cos();
        // The rounding of sin and cos moves the angle, and the modulus away from 1, by 1e-16.
        check(&dmatrix![c, s; -s, c], &dmatrix![0.0, angle; -angle, 0.0], 1e-15 + 2e-16 / angle);
    }
    // [a b; 0 d]: b (ln a - ln d)/(a - d), and b/a where they agree.
    check(&dmatrix![2.0, 5.0; 0.0, 2.0], &dmatrix![2.0_f64.ln(), 2.5; 0.0, 2.0_f64.ln()], 1e-15);
    let (x, y) = (1.0_f64.exp(), 2.0_f64.exp());
    check(&dmatrix![x, y - x; 0.0, y], &dmatrix![1.0, 1.0; 0.0, 2.0], 1e-15);
}

#[test]
fn nearly_equal_eigenvalues() {
    // ln(1 + e) / e = 1 - e/2 + ..: the entry beside the diagonal for eigenvalues 1 and 1 + e.
    for e in [1e-14_f64, 1e-9, 1e-4] {
        let got = logarithm(&dmatrix![1.0, 1.0; 0.0, 1.0 + e]).expect("a logarithm").value;
        let gap = (1.0 + e) - 1.0;
        assert!((got[(0, 1)] - gap.ln_1p() / gap).abs() < 1e-15, "{e}: {}", got[(0, 1)]);
    }
    // A full matrix with a defective eigenvalue 1, not triangular: unipotent, so the series ends.
    let n = dmatrix![1.0, 1.0, 0.0; -1.0, -1.0, 0.0; 2.0, 3.0, 0.0];
    let square = &n * &n;
    assert_eq!((&square * &n).amax(), 0.0);
    check(&(DMatrix::identity(3, 3) + &n), &(&n - square * 0.5), 1e-14);
}

#[test]
fn exponential_undoes_it() {
    for a in [
        dmatrix![0.5, 0.4, 0.1; 0.3, 0.9, -0.2; 0.0, 0.7, 1.4],
        dmatrix![1e-6, 0.3, 0.0; 0.0, 0.4, 2.0; 0.0, -1.0, 0.5],
        dmatrix![3.0, 1e5; 0.0, 0.01],
    ] {
        let log = logarithm(&a).expect("a logarithm");
        assert!(log.residual < 1e-14, "{:e}", log.residual);
    }
}

#[test]
fn no_real_logarithm() {
    let check = |a: DMatrix<f64>, wanted: f64| match logarithm(&a) {
        Err(LtiError::NoRealLogarithm { eigenvalue }) => {
            assert!((eigenvalue.re - wanted).abs() < 1e-14 && eigenvalue.im == 0.0, "{eigenvalue}");
        }
        other => panic!("{other:?}"),
    };
    check(dmatrix![-0.5], -0.5);
    check(dmatrix![1.0, 2.0; 0.0, 0.0], 0.0);
    check(dmatrix![1.0, 1.0; 1.0, 1.0], 0.0);
    check(dmatrix![0.0, 1.0; 1.0, 0.0], -1.0);
    assert!(matches!(logarithm(&DMatrix::zeros(2, 3)), Err(LtiError::NotSquare { .. })));
    assert!(matches!(logarithm(&dmatrix![f64::INFINITY]), Err(LtiError::NotFinite { .. })));
    assert_eq!(logarithm(&DMatrix::zeros(0, 0)).expect("empty").value.nrows(), 0);
}
