//! Tests of `inverse_zoh.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::dmatrix;

use super::*;
use crate::SamplePeriod;

fn sampled(a: DMatrix<f64>, b: DMatrix<f64>) -> StateSpace<Discrete> {
    let (n, m) = b.shape();
    let period = SamplePeriod::new(0.1).expect("positive");
    StateSpace::<Discrete>::new(a, b, DMatrix::identity(n, n), DMatrix::zeros(n, m), period)
        .expect("a system")
}

#[test]
fn first_order() {
    // Ad = e^-0.2, Bd = 3 (1 - e^-0.2)/2.
    let ad = (-0.2_f64).exp();
    let back = sampled(dmatrix![ad], dmatrix![-1.5 * (-0.2_f64).exp_m1()])
        .inverse_zoh()
        .expect("a logarithm");
    assert!((back.a()[0] + 2.0).abs() < 1e-14 && (back.b()[0] - 3.0).abs() < 1e-14);
}

#[test]
fn sizes_of_b_do_not_matter() {
    let a = dmatrix![0.9, 0.1; -0.3, 0.8];
    let one = sampled(a.clone(), dmatrix![1.0; 2.0]).inverse_zoh().expect("a logarithm");
    for size in [1e-200, 1e-8, 1e9, 1e200] {
        let scaled = sampled(a.clone(), dmatrix![1.0; 2.0] * size)
            .inverse_zoh_with_residual()
            .expect("a logarithm");
        let error = (scaled.system.b() / size - one.b()).amax() / one.b().amax();
        assert!(error < 1e-14 && scaled.residual < 1e-14, "{size:e}: {error:e}");
        assert_eq!(scaled.system.a(), one.a());
    }
}

#[test]
fn what_has_no_real_logarithm() {
    for a in [dmatrix![-0.5], dmatrix![0.0]] {
        let error = sampled(a, dmatrix![1.0]).inverse_zoh().expect_err("no real logarithm");
        assert!(error.to_string().contains("negative real axis"), "{error}");
    }
}

#[test]
fn empty_parts() {
    for (n, m) in [(0, 0), (0, 2), (2, 0)] {
        let back = sampled(DMatrix::identity(n, n), DMatrix::zeros(n, m))
            .inverse_zoh_with_residual()
            .expect("trivial");
        assert_eq!(back.system.a(), &DMatrix::zeros(n, n));
        assert_eq!(back.residual, 0.0);
    }
}
