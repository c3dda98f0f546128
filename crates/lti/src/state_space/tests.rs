//! Tests of `state_space.rs`.

use nalgebra::dmatrix;

use super::*;

fn zeros(rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::zeros(rows, columns)
}

#[test]
fn shapes_that_do_not_fit() {
    let check = |a: DMatrix<f64>, b, c, d, wanted: &str| {
        let error = StateSpace::<Continuous>::new(a, b, c, d).expect_err(wanted);
        assert_eq!(error.to_string(), wanted);
    };
    check(
        zeros(2, 3),
        zeros(2, 1),
        zeros(1, 2),
        zeros(1, 1),
        "A is 2 x 3; a square matrix is needed",
    );
    check(zeros(2, 2), zeros(3, 1), zeros(1, 2), zeros(1, 1), "B is 3 x 1; 2 x 1 is needed");
    check(zeros(2, 2), zeros(2, 1), zeros(1, 3), zeros(1, 1), "C is 1 x 3; 1 x 2 is needed");
    check(zeros(2, 2), zeros(2, 1), zeros(1, 2), zeros(2, 1), "D is 2 x 1; 1 x 1 is needed");
    let nan = dmatrix![0.0, 0.0; f64::NAN, 0.0];
    check(nan, zeros(2, 1), zeros(1, 2), zeros(1, 1), "A[1, 0] is NaN; finite entries are needed");
    let infinite = dmatrix![f64::INFINITY];
    check(
        zeros(2, 2),
        zeros(2, 1),
        zeros(1, 2),
        infinite,
        "D[0, 0] is inf; finite entries are needed",
    );
}

#[test]
fn empty_parts_are_systems() {
    for (n, m, p) in [(0, 0, 0), (0, 2, 3), (2, 0, 1), (2, 1, 0)] {
        let system =
            StateSpace::<Continuous>::new(zeros(n, n), zeros(n, m), zeros(p, n), zeros(p, m))
                .expect("fits");
        assert_eq!((system.order(), system.inputs(), system.outputs()), (n, m, p));
    }
}

#[test]
fn parts() {
    let system = StateSpace::<Continuous>::new(
        dmatrix![-1.0],
        dmatrix![1.0, 2.0],
        dmatrix![3.0; 4.0],
        dmatrix![5.0, 6.0; 7.0, 8.0],
    )
    .expect("a system");
    let swapped = system.subsystem(&[1, 0, 1], &[1]).expect("in range");
    assert_eq!(swapped.c(), &dmatrix![4.0; 3.0; 4.0]);
    assert_eq!(swapped.b(), &dmatrix![2.0]);
    assert_eq!(swapped.d(), &dmatrix![8.0; 6.0; 8.0]);
    assert_eq!(system.subsystem(&[], &[]).expect("empty").outputs(), 0);
    let error = system.subsystem(&[2], &[0]).expect_err("out of range");
    assert_eq!(error.to_string(), "output 2 was asked for; the system has 2, counted from 0");
    assert!(system.subsystem(&[0], &[9]).is_err());
}
