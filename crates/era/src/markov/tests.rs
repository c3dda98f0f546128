use nalgebra::DMatrix;

use super::NoncausalMarkov;
use crate::EraError;

#[test]
fn a_window_is_split_at_index_zero() {
    let window = NoncausalMarkov::from_window(&[30.0, 20.0, 10.0, 0.5, 1.0], 3).unwrap();
    assert_eq!(window, NoncausalMarkov::siso(&[10.0, 20.0, 30.0], &[0.5, 1.0]).unwrap());
    let causal = NoncausalMarkov::from_window(&[1.0], 0).unwrap();
    assert_eq!((causal.anticausal().len(), causal.causal().len()), (0, 1));
}

#[test]
fn a_window_without_index_zero_is_refused() {
    assert_eq!(NoncausalMarkov::from_window(&[1.0, 2.0], 2), Err(EraError::NoFeedthrough));
    assert_eq!(NoncausalMarkov::from_window(&[1.0, 2.0], 3), Err(EraError::NoFeedthrough));
    assert_eq!(NoncausalMarkov::from_window(&[], 0), Err(EraError::NoFeedthrough));
}

#[test]
fn the_index_of_a_bad_value_is_named() {
    assert_eq!(
        NoncausalMarkov::from_window(&[1.0, f64::NAN, 2.0, 3.0], 3),
        Err(EraError::NotFinite { index: -2 })
    );
    assert_eq!(
        NoncausalMarkov::siso(&[], &[1.0, f64::INFINITY]),
        Err(EraError::NotFinite { index: 1 })
    );
    let odd = NoncausalMarkov::new(vec![DMatrix::zeros(1, 2)], vec![DMatrix::zeros(2, 1)]);
    let expected = EraError::ShapeMismatch {
        index: -1,
        rows: 1,
        columns: 2,
        expected_rows: 2,
        expected_columns: 1,
    };
    assert_eq!(odd, Err(expected));
    let none = NoncausalMarkov::new(vec![], vec![DMatrix::zeros(0, 1)]);
    assert_eq!(none, Err(EraError::NoChannels { rows: 0, columns: 1 }));
}
