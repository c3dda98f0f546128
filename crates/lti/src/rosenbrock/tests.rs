//! Tests of `rosenbrock.rs`.

use nalgebra::dmatrix;

use super::*;
use crate::Continuous;

#[test]
fn scaling_is_exact_and_keeps_the_feedthrough_in_step() {
    let system = StateSpace::<Continuous>::new(
        dmatrix![0.0, 1.0; -81.0, -0.25],
        dmatrix![0.0; 1.0],
        dmatrix![3.0, 1.0],
        dmatrix![0.125],
    )
    .expect("a system");
    let scaled = Rosenbrock::scaled(&system);
    // det [A - x I, B; C, D] at x, up to a constant: compare two points.
    let determinant = |x: f64| {
        let mut p = DMatrix::zeros(3, 3);
        p.view_mut((0, 0), (2, 2)).copy_from(&(system.a() - DMatrix::identity(2, 2) * x));
        p.view_mut((0, 2), (2, 1)).copy_from(system.b());
        p.view_mut((2, 0), (1, 2)).copy_from(system.c());
        p.view_mut((2, 2), (1, 1)).copy_from(system.d());
        p.determinant()
    };
    let of_scaled = |x: f64| {
        let mut p = scaled.matrix.clone();
        for i in 0..2 {
            p[(i, i)] -= x / scaled.time_scale;
        }
        p.determinant()
    };
    let ratio = determinant(0.7) / of_scaled(0.7);
    assert!((determinant(-5.0) / of_scaled(-5.0) / ratio - 1.0).abs() < 1e-13);
}

#[test]
fn rank_decisions_are_reported() {
    // Feedthrough of 1e-9: kept by default, dropped with a tolerance of 1e-6.
    let system =
        StateSpace::<Continuous>::new(dmatrix![-1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![1e-9])
            .expect("a system");
    let scaled = Rosenbrock::scaled(&system);
    let exact = scaled.reduce(None).expect("reduces");
    assert_eq!((exact.pencil_a.nrows(), exact.normal_rank), (1, 1));
    assert!(exact.smallest_kept < 1e-8 && exact.largest_dropped == 0.0);
    let coarse = scaled.reduce(Some(1e-6)).expect("reduces");
    assert_eq!((coarse.pencil_a.nrows(), coarse.normal_rank), (0, 1));
    assert!(coarse.largest_dropped > 1e-10 && coarse.largest_dropped < 1e-8);
}
