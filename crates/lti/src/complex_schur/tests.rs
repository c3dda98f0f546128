//! Tests of `complex_schur.rs`.

use super::*;

/// The backward error and the loss of orthogonality, in units of n u.
fn check(a: &DMatrix<f64>) -> f64 {
    let n = a.nrows();
    let ComplexSchur { q, t } = complex_schur(a).unwrap_or_else(|e| panic!("{e} {a}"));
    let complex = a.map(|x| Complex::new(x, 0.0));
    let backward = (&q * &t * q.adjoint() - complex).norm() / a.norm().max(f64::MIN_POSITIVE);
    let orthogonality = (q.adjoint() * &q - CMatrix::identity(n, n)).norm();
    backward.max(orthogonality) / (n as f64 * f64::EPSILON)
}

#[test]
fn pseudorandom_matrices_of_every_small_order() {
    let mut state = 12345_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for n in 1..=14 {
        for _ in 0..40 {
            let error = check(&DMatrix::from_fn(n, n, |_, _| next()));
            assert!(error < 5.0, "order {n}: {error} n u");
        }
    }
}

#[test]
fn hard_cases() {
    // A cyclic permutation (all shifts alike), a Jordan block turned around, a zero matrix, tiny and huge entries.
    let cyclic = DMatrix::from_fn(6, 6, |i, j| if (i + 1) % 6 == j { 1.0 } else { 0.0 });
    let jordan = DMatrix::from_fn(5, 5, |i, j| if i == j || i == j + 1 { 1.0 } else { 0.0 });
    for a in [cyclic.clone(), jordan, &cyclic * 1e-150, &cyclic * 1e150] {
        let error = check(&a);
        assert!(error < 5.0, "{error} n u for {a}");
    }
    assert_eq!(complex_schur(&DMatrix::zeros(3, 3)).expect("zero").t, CMatrix::zeros(3, 3));
    assert_eq!(complex_schur(&DMatrix::zeros(0, 0)).expect("empty").t.nrows(), 0);
}
