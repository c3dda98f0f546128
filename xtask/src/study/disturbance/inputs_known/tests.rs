use super::*;
use crate::shared::matching::eigenvalue_errors;
use crate::study::disturbance::flights::Simulator;
use crate::study::disturbance::{Excitation, Kind};

#[test]
fn in_still_air_it_is_nearly_exact() {
    let simulator = Simulator::new().unwrap();
    for excitation in Excitation::ALL {
        let flight = simulator.fly(Kind { excitation, gust_percent: 0 }, 1).unwrap();
        let found = eigenvalues(&flight, simulator.aircraft.period()).unwrap();
        let errors = eigenvalue_errors(&found, &simulator.aircraft.modes).unwrap();
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
