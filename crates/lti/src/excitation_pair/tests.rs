//! Tests of `excitation_pair.rs`.

use nalgebra::dmatrix;

use super::*;

#[test]
fn feedthrough_comes_with_delta() {
    // A = 0 (1 x 1): Gamma = c b + d p.
    let pair =
        ExcitationPair::new(&dmatrix![0], [&[2], &[3]], (&[5], &7), (&[1], &0)).expect("fits");
    assert_eq!(pair.gamma_i1, Poly::new(vec![10, 7]));
    assert_eq!(pair.gamma_i2, Poly::new(vec![15, 7]));
    assert_eq!(pair.gamma_o1, Poly::new(vec![2]));
    assert_eq!(pair.gamma_o2, Poly::new(vec![3]));
}

#[test]
fn bad_input() {
    let a = dmatrix![1, 0; 0, 2];
    let good: &[i64] = &[1, 1];
    assert!(ExcitationPair::new(&a, [good, &[1]], (good, &0), (good, &0)).is_err());
    assert!(ExcitationPair::new(&a, [good, good], (&[1], &0), (good, &0)).is_err());
    assert!(ExcitationPair::new(&a, [good, good], (good, &0), (&[1], &0)).is_err());
    assert!(
        ExcitationPair::new(&DMatrix::zeros(2, 1), [good, good], (good, &0), (good, &0)).is_err()
    );
    let silent =
        ExcitationPair::new(&a, [good, &[0, 0]], (good, &0), (good, &0)).expect("polynomials");
    assert!(matches!(silent.transmissibilities(), Err(LtiError::ZeroDenominator { .. })));
}
