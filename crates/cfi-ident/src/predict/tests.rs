use super::*;
use crate::{ConstantTerm, Orders, Structure};

/// l = 2, r = 1, d = 2: y_o(k+2) = 0.5 y_o(k+1) [- 0.25 y_o(k)] + 3 y_i(k+2) + 5 y_i(k+1) + 7 y_i(k) + 11 y_i(k-1).
fn model(constant_term: ConstantTerm) -> CfiModel {
    let structure = Structure::new(Orders::new(2, 1, 2).unwrap(), constant_term);
    let c: &[f64] = match constant_term {
        ConstantTerm::Omitted => &[-0.5],
        ConstantTerm::Included => &[0.25, -0.5],
    };
    CfiModel::new(structure, c, &[3.0, 5.0, 7.0, 11.0]).unwrap()
}

#[test]
fn one_equation_by_hand() {
    // N = 4 leaves one equation, k = 1, y_o(3).
    let (input, output) = ([1.0, 10.0, 100.0, 1000.0], [8.0, 4.0, 2.0, 9.0]);
    let forced = 3.0 * 1000.0 + 5.0 * 100.0 + 7.0 * 10.0 + 11.0;
    let check = |constant_term, expected: f64| {
        let model = model(constant_term);
        for prediction in [Prediction::OneStep, Prediction::Simulated] {
            let predicted = model.predict(&input, &output, prediction).unwrap();
            assert_eq!((predicted.first, predicted.values), (3, vec![expected]));
        }
        assert_eq!(model.residuals(&input, &output).unwrap().values, [9.0 - expected]);
    };
    check(ConstantTerm::Omitted, forced + 0.5 * 2.0);
    check(ConstantTerm::Included, forced + 0.5 * 2.0 - 0.25 * 4.0);
}

#[test]
fn simulation_feeds_on_itself_and_one_step_does_not() {
    let input: Vec<f64> = (0..12).map(|k| f64::from(k * k % 5)).collect();
    let output = vec![1.0; 12];
    let model = model(ConstantTerm::Included);
    let one = model.predict(&input, &output, Prediction::OneStep).unwrap();
    let free = model.predict(&input, &output, Prediction::Simulated).unwrap();
    assert_eq!((one.values.len(), free.values.len(), one.first), (9, 9, 3));
    let h =
        |k: usize| 3.0 * input[k + 2] + 5.0 * input[k + 1] + 7.0 * input[k] + 11.0 * input[k - 1];
    let (mut before, mut last) = (1.0, 1.0);
    for n in 0..9 {
        assert!((one.values[n] - (h(n + 1) + 0.5 - 0.25)).abs() < 1e-13);
        (before, last) = (last, h(n + 1) + 0.5 * last - 0.25 * before);
        assert!((free.values[n] - last).abs() < 1e-12);
    }
}

#[test]
fn bad_records_are_refused() {
    let model = model(ConstantTerm::Omitted);
    let predict = |i: &[f64], o: &[f64]| model.predict(i, o, Prediction::OneStep);
    assert!(matches!(
        predict(&[1.0; 3], &[1.0; 3]),
        Err(FitError::TooShort { samples: 3, needed: 4, .. })
    ));
    assert!(matches!(predict(&[], &[]), Err(FitError::TooShort { .. })));
    assert!(matches!(predict(&[1.0; 4], &[1.0; 5]), Err(FitError::UnequalLengths { .. })));
    assert!(matches!(
        predict(&[1.0; 4], &[f64::INFINITY; 4]),
        Err(FitError::NotFinite { index: 0, .. })
    ));
    assert!(matches!(
        model.pseudo_output(&[1.0; 9], &[]),
        Err(FitError::CoefficientCount { needed: 1, .. })
    ));
}

#[test]
fn divergence_is_an_error_and_not_an_infinity() {
    let structure = Structure::new(Orders::new(1, 0, 0).unwrap(), ConstantTerm::Included);
    let unstable = CfiModel::new(structure, &[-10.0], &[1.0]).unwrap();
    assert!(matches!(unstable.pseudo_output(&[1.0; 400], &[1.0]), Err(FitError::Overflow { .. })));
}
