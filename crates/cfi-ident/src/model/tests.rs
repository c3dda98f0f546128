use super::*;
use crate::{ConstantTerm, Orders};

fn structure(l: usize, r: usize, d: usize, constant_term: ConstantTerm) -> Structure {
    Structure::new(Orders::new(l, r, d).unwrap(), constant_term)
}

#[test]
fn coefficients_land_at_their_powers() {
    let printed = structure(3, 1, 2, ConstantTerm::Omitted);
    let model = CfiModel::new(printed, &[0.1, 0.2], &[-20.0, -10.0, 1.0, 2.0]).unwrap();
    assert_eq!(model.denominator(), [0.0, 0.1, 0.2, 1.0]);
    assert_eq!(model.anticausal(), [-10.0, -20.0]);
    assert_eq!(model.causal(), [1.0, 2.0]);
    assert_eq!(model.markov_parameters(), [-20.0, -10.0, 1.0, 2.0]);
    assert_eq!(model.theta(), [0.1, 0.2, -20.0, -10.0, 1.0, 2.0]);
    let by_index: Vec<f64> = (-4..4).map(|i| model.markov_parameter(i)).collect();
    assert_eq!(by_index, [0.0, 0.0, -20.0, -10.0, 1.0, 2.0, 0.0, 0.0]);
    assert_eq!(CfiModel::from_theta(printed, &model.theta()).unwrap(), model);

    let full = structure(2, 0, 0, ConstantTerm::Included);
    assert_eq!(CfiModel::new(full, &[0.3, 0.4], &[1.0]).unwrap().denominator(), [0.3, 0.4, 1.0]);
}

#[test]
fn lowest_orders() {
    let gain = CfiModel::new(structure(0, 0, 0, ConstantTerm::Included), &[], &[3.0]).unwrap();
    assert_eq!((gain.denominator(), gain.theta()), (vec![1.0], vec![3.0]));
    // l = 1 as printed: D = q, no unknown.
    let delay = CfiModel::new(structure(1, 0, 0, ConstantTerm::Omitted), &[], &[3.0]).unwrap();
    assert_eq!(delay.denominator(), [0.0, 1.0]);
    assert_eq!(delay.response(Complex::new(0.0, 2.0)), Complex::new(0.0, -1.5));
}

#[test]
fn response_adds_both_directions_of_time() {
    // (2 z^2 + z + 5 + 7/z) / (z^2 + 3 z) at z = 2: (8 + 2 + 5 + 3.5) / 10.
    let model =
        CfiModel::new(structure(2, 1, 2, ConstantTerm::Omitted), &[3.0], &[2.0, 1.0, 5.0, 7.0])
            .unwrap();
    assert!((model.response(Complex::new(2.0, 0.0)) - Complex::new(1.85, 0.0)).norm() < 1e-15);
}

#[test]
fn wrong_coefficients_are_refused() {
    let s = structure(2, 1, 1, ConstantTerm::Omitted);
    assert_eq!(
        CfiModel::new(s, &[1.0, 2.0], &[0.0; 3]).unwrap_err(),
        FitError::CoefficientCount { what: "denominator coefficients", found: 2, needed: 1 }
    );
    assert!(CfiModel::new(s, &[1.0], &[0.0; 4]).is_err());
    assert!(CfiModel::from_theta(s, &[0.0; 5]).is_err());
    assert!(matches!(CfiModel::new(s, &[f64::NAN], &[0.0; 3]), Err(FitError::BadValue { .. })));
}
