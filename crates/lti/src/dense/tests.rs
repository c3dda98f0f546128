//! Tests of `dense.rs`.

use nalgebra::dmatrix;

use super::*;

#[test]
fn qz_at_every_small_size_with_both_kinds_of_vectors() {
    let mut state = 99_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for n in 0..=9 {
        for _ in 0..50 {
            let a = DMatrix::from_fn(n, n, |_, _| next());
            let b = DMatrix::from_fn(n, n, |_, _| next());
            let (ac, bc) = (a.map(|x| Complex::new(x, 0.0)), b.map(|x| Complex::new(x, 0.0)));
            let pairs = generalized_eigenpairs(&a, &b).expect("converges");
            let count: usize =
                pairs.iter().map(|pair| if pair.value.im == 0.0 { 1 } else { 2 }).sum();
            assert_eq!(count, n);
            for GeneralizedEigenpair { value, right, left } in pairs {
                assert!(value.im >= 0.0);
                let size = a.norm() + value.norm() * b.norm();
                let pencil = &ac - &bc * value;
                assert!((&pencil * &right).norm() / (size * right.norm()) < 1e-14);
                assert!((pencil.adjoint() * &left).norm() / (size * left.norm()) < 1e-14);
            }
        }
    }
}

#[test]
fn svd_of_empty_and_wide_matrices() {
    let Svd { u, s, v } = svd(&DMatrix::zeros(0, 3)).expect("empty");
    assert_eq!((u.shape(), s.len(), v.shape()), ((0, 0), 0, (3, 3)));
    let Svd { s, v, .. } = svd(&dmatrix![3.0, 0.0, 4.0]).expect("converges");
    assert!((s[0] - 5.0).abs() < 1e-15 && v.shape() == (3, 3));
}
