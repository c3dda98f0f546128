//! Tests of `simulation.rs`.

use nalgebra::{dmatrix, dvector};

use super::*;
use crate::SamplePeriod;

fn fibonacci() -> StateSpace<Discrete> {
    StateSpace::<Discrete>::new(
        dmatrix![1.0, 1.0; 1.0, 0.0],
        dmatrix![1.0; 0.0],
        dmatrix![1.0, 0.0; 0.0, 2.0],
        dmatrix![0.0; 3.0],
        SamplePeriod::new(1.0).expect("positive"),
    )
    .expect("a system")
}

#[test]
fn an_impulse_gives_the_markov_parameters() {
    let system = fibonacci();
    let mut input = DMatrix::zeros(1, 8);
    input[0] = 1.0;
    let response = system.simulate(&input, None).expect("fits");
    let first: Vec<f64> = response.outputs.row(0).iter().copied().collect();
    assert_eq!(first, [0.0, 1.0, 1.0, 2.0, 3.0, 5.0, 8.0, 13.0]);
    let second: Vec<f64> = response.outputs.row(1).iter().copied().collect();
    assert_eq!(second, [3.0, 0.0, 2.0, 2.0, 4.0, 6.0, 10.0, 16.0]);
    for (k, h) in system.markov_parameters(8).iter().enumerate() {
        assert_eq!((h[0], h[1]), (first[k], second[k]));
    }
    assert_eq!(response.states.shape(), (2, 9));
    assert_eq!(response.states.column(8), dvector![21.0, 13.0]);
}

#[test]
fn free_response() {
    let response =
        fibonacci().simulate(&DMatrix::zeros(1, 4), Some(&dvector![2.0, 1.0])).expect("fits");
    assert_eq!(response.outputs, dmatrix![2.0, 3.0, 5.0, 8.0; 2.0, 4.0, 6.0, 10.0]);
}

#[test]
fn limits() {
    let system = fibonacci();
    assert_eq!(system.markov_parameters(0).len(), 0);
    assert_eq!(system.markov_parameters(1), [dmatrix![0.0; 3.0]]);
    let none = system.simulate(&DMatrix::zeros(1, 0), None).expect("no samples");
    assert_eq!((none.outputs.shape(), none.states.shape()), ((2, 0), (2, 1)));
    let check = |result: Result<Simulation, LtiError>, wanted: &str| {
        assert_eq!(result.expect_err(wanted).to_string(), wanted);
    };
    check(system.simulate(&DMatrix::zeros(2, 5), None), "the input is 2 x 5; 1 x 5 is needed");
    check(
        system.simulate(&dmatrix![1.0, f64::NAN], None),
        "the input[0, 1] is NaN; finite entries are needed",
    );
    check(
        system.simulate(&dmatrix![1.0], Some(&dvector![1.0])),
        "the initial state is 1 x 1; 2 x 1 is needed",
    );
    check(
        system.simulate(&dmatrix![1.0], Some(&dvector![1.0, f64::INFINITY])),
        "the initial state[1, 0] is inf; finite entries are needed",
    );
}

#[test]
fn a_pure_gain() {
    let gain = StateSpace::<Discrete>::new(
        DMatrix::zeros(0, 0),
        DMatrix::zeros(0, 1),
        DMatrix::zeros(1, 0),
        dmatrix![3.0],
        SamplePeriod::new(1.0).expect("positive"),
    )
    .expect("a system");
    assert_eq!(gain.simulate(&dmatrix![1.0, 2.0], None).expect("fits").outputs, dmatrix![3.0, 6.0]);
    assert_eq!(gain.markov_parameters(3), [dmatrix![3.0], dmatrix![0.0], dmatrix![0.0]]);
}
