use super::*;
use crate::study::disturbance::case::{Case, Excitation};
use crate::study::disturbance::flights::Simulator;
use crate::study::verdict::eigenvalue_errors;

#[test]
fn in_still_air_it_is_nearly_exact() {
    let simulator = Simulator::new().unwrap();
    for excitation in Excitation::ALL {
        let flight = simulator.fly(&Case { excitation, gust_percent: 0, seed: 1 }).unwrap();
        let found = eigenvalues(&flight, simulator.truth().period).unwrap();
        let errors = eigenvalue_errors(&found, &simulator.modes()).unwrap();
        assert!(errors[0] < 0.01 && errors[1] < 0.03 && errors[2] < 0.01, "{errors:?}");
    }
}

#[test]
fn markov_parameters_of_one_lag_are_powers() {
    let a = DMatrix::from_diagonal_element(3, 3, 0.5);
    let b = DMatrix::from_element(3, 2, 2.0);
    let found = markov_parameters(&[(a, b)]);
    for (k, h) in found.iter().enumerate() {
        let expected = 2.0 * 0.5_f64.powi(i32::try_from(k).unwrap());
        assert!(h.iter().all(|entry| (entry - expected).abs() < 1e-15));
    }
}
