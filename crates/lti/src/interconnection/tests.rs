//! Tests of `interconnection.rs`: every connection against the same operation on frequency responses.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::dmatrix;
use num_complex::Complex;

use super::*;
use crate::{Continuous, Discrete, SamplePeriod};

type Response = DMatrix<Complex<f64>>;

fn two_by_two() -> StateSpace<Continuous> {
    StateSpace::<Continuous>::new(
        dmatrix![-1.0, 2.0; 0.5, -3.0],
        dmatrix![1.0, 0.0; 0.3, -1.0],
        dmatrix![1.0, 1.0; 0.0, 2.0],
        dmatrix![0.1, 0.0; 0.4, -0.2],
    )
    .expect("a system")
}

fn other() -> StateSpace<Continuous> {
    StateSpace::<Continuous>::new(
        dmatrix![-0.7],
        dmatrix![1.0, 4.0],
        dmatrix![2.0; -1.0],
        dmatrix![0.0, 0.5; 0.6, 0.0],
    )
    .expect("a system")
}

fn check(connected: &StateSpace<Continuous>, wanted: impl Fn(&Response, &Response) -> Response) {
    for omega in [0.0, 0.3, 2.0, 50.0] {
        let at =
            |s: &StateSpace<Continuous>| s.frequency_response(&[omega]).expect("no pole").remove(0);
        let difference = at(connected) - wanted(&at(&two_by_two()), &at(&other()));
        assert!(difference.norm() < 1e-14, "{omega}: {difference}");
    }
}

#[test]
fn connections() {
    let (g, h) = (two_by_two(), other());
    check(&g.series(&h).expect("fits"), |g, h| h * g);
    check(&g.parallel(&h).expect("fits"), |g, h| g + h);
    check(&g.difference(&h).expect("fits"), |g, h| g - h);
    check(&g.feedback(&h).expect("fits"), |g, h| {
        let identity = Response::identity(2, 2);
        (identity + g * h).try_inverse().expect("regular") * g
    });
    assert_eq!(g.series(&h).expect("fits").order(), 3);
}

#[test]
fn what_does_not_fit() {
    let g = two_by_two();
    let wide = g.subsystem(&[0], &[0, 1]).expect("a part");
    assert!(matches!(wide.series(&g), Err(LtiError::Shape { .. })));
    assert!(matches!(g.parallel(&wide), Err(LtiError::Shape { .. })));
    assert!(matches!(wide.feedback(&wide), Err(LtiError::Shape { .. })));
    let sampled = |t| g.zoh(SamplePeriod::new(t).expect("positive")).expect("samples");
    let error = sampled(0.1).series(&sampled(0.2)).expect_err("two periods");
    assert_eq!(error, LtiError::PeriodMismatch { left: 0.1, right: 0.2 });
    let same: Result<StateSpace<Discrete>, _> = sampled(0.1).parallel(&sampled(0.1));
    assert_eq!(same.expect("one period").period().seconds(), 0.1);
}

#[test]
fn loops_without_solution_and_overflow() {
    let gain = |k: f64| {
        StateSpace::<Continuous>::new(
            DMatrix::zeros(0, 0),
            DMatrix::zeros(0, 1),
            DMatrix::zeros(1, 0),
            dmatrix![k],
        )
        .expect("a gain")
    };
    assert_eq!(gain(1.0).feedback(&gain(-1.0)), Err(LtiError::AlgebraicLoop));
    assert_eq!(gain(1.0).feedback(&gain(1.0)).expect("a loop").d()[0], 0.5);
    assert!(matches!(gain(1e200).series(&gain(1e200)), Err(LtiError::Overflow { .. })));
}
