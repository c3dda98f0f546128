//! Tests of `exponential.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use core::f64::consts::PI;

use nalgebra::dmatrix;

use super::*;

fn check(a: &DMatrix<f64>, wanted: &DMatrix<f64>, limit: f64) {
    let got = exponential(a).expect("finite");
    let error = (&got - wanted).amax() / wanted.amax();
    assert!(error <= limit, "exp({a}) = {got}, not {wanted}: {error:e}");
}

#[test]
fn closed_forms() {
    check(&DMatrix::zeros(3, 3), &DMatrix::identity(3, 3), 0.0);
    assert_eq!(exponential(&DMatrix::zeros(0, 0)).expect("empty").shape(), (0, 0));
    for x in [1e-20_f64, -0.01, 0.3, -2.0, 5.0, -30.0, 300.0, -700.0] {
        check(&dmatrix![x], &dmatrix![x.exp()], 1e-15 * (1.0 + x.abs()));
    }
    for angle in [1e-9_f64, 0.1, 1.0, PI, 30.0] {
        let (s, c) = angle.sin_cos();
        check(&dmatrix![0.0, angle; -angle, 0.0], &dmatrix![c, s; -s, c], 2e-15 * (1.0 + angle));
    }
    // [a b; 0 d]: exp has b (e^a - e^d)/(a - d) beside the diagonal.
    let (e1, e2) = ((-1.0_f64).exp(), (-2.0_f64).exp());
    check(&dmatrix![-1.0, 1e6; 0.0, -2.0], &dmatrix![e1, 1e6 * (e1 - e2); 0.0, e2], 1e-15);
}

#[test]
fn every_degree_and_a_chain_of_integrators() {
    // The series of a nilpotent matrix ends: t^k / k! on the k-th diagonal.
    for t in [1e-3, 0.01, 0.2, 0.8, 2.0, 4.0, 17.0, 1e3] {
        let chain = DMatrix::from_fn(5, 5, |i, j| if j == i + 1 { t } else { 0.0 });
        let factorial = [1.0, 1.0, 2.0, 6.0, 24.0];
        let wanted = DMatrix::from_fn(5, 5, |i, j| {
            if j >= i {
                f64::powi(t, i32::try_from(j - i).expect("small")) / factorial[j - i]
            } else {
                0.0
            }
        });
        let got = exponential(&chain).expect("finite");
        for (x, y) in got.iter().zip(wanted.iter()) {
            assert!((x - y).abs() <= 4e-15 * y.abs(), "t = {t}: {x} {y}");
        }
    }
}

#[test]
fn stiff_and_extreme() {
    // The slow part keeps its digits beside a fast one, also close to the identity.
    let got = exponential(&dmatrix![-1e4, 0.0; 0.0, -1e-3]).expect("finite");
    assert!((got[(1, 1)] - (-1e-3_f64).exp()).abs() <= 2.3e-16, "{got}");
    assert!(got[(0, 0)].abs() < 1e-15);
    // Everything decayed: relative accuracy of what is left.
    let got = exponential(&dmatrix![-40.0, 1.0; 0.0, -41.0]).expect("finite");
    assert!((got[(0, 0)] / (-40.0_f64).exp() - 1.0).abs() < 1e-13);
    assert_eq!(exponential(&dmatrix![-1e150]).expect("decays"), dmatrix![0.0]);
    assert!(matches!(exponential(&dmatrix![1e150]), Err(LtiError::Overflow { .. })));
    assert!(matches!(
        exponential(&dmatrix![1e308, 1e308; 1e308, 1e308]),
        Err(LtiError::Overflow { .. })
    ));
    assert!(matches!(exponential(&dmatrix![f64::NAN]), Err(LtiError::NotFinite { .. })));
    assert!(matches!(exponential(&DMatrix::zeros(1, 2)), Err(LtiError::NotSquare { .. })));
    let tiny = exponential(&dmatrix![0.0, 1e-300; 0.0, 0.0]).expect("finite");
    assert_eq!(tiny[(0, 1)], 1e-300);
}

#[test]
fn odd_units_change_nothing() {
    let a = dmatrix![-0.7, 0.4, 0.1; 0.3, -1.2, 0.9; -0.8, 0.6, 0.2];
    let units = [2.0_f64.powi(40), 1.0, 2.0_f64.powi(-35)];
    let odd = DMatrix::from_fn(3, 3, |i, j| a[(i, j)] * units[j] / units[i]);
    let (plain, scaled) = (exponential(&a).expect("finite"), exponential(&odd).expect("finite"));
    for i in 0..3 {
        for j in 0..3 {
            let wanted = plain[(i, j)] * units[j] / units[i];
            assert!((scaled[(i, j)] - wanted).abs() <= 1e-14 * wanted.abs(), "{i} {j}");
        }
    }
}
