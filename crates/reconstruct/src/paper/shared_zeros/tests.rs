use proptest::prelude::*;

use super::*;

fn list(real: &[f64], pairs: &[(f64, f64)]) -> Vec<Zero> {
    let pairs = pairs.iter().flat_map(|&(re, im)| [Complex::new(re, im), Complex::new(re, -im)]);
    real.iter().map(|&re| Complex::new(re, 0.0)).chain(pairs).map(Zero::exact).collect()
}

#[test]
fn keeps_what_all_share_and_nothing_else() {
    let a = list(&[0.5, 0.2, 1.0], &[(0.9, 0.1)]);
    let b = list(&[0.5, -0.7, 1.5], &[(0.9, 0.1)]);
    let c = list(&[0.5, 0.2, -0.3], &[(0.9, 0.1)]);
    let shared = shared_zeros(&[a, b, c], 1e-6).unwrap();
    let expected = [Complex::new(0.9, 0.1), Complex::new(0.9, -0.1), Complex::new(0.5, 0.0)];
    assert_eq!(shared.zeros.len(), 3);
    for (value, expected) in shared.values().iter().zip(expected) {
        assert!((value - expected).norm() < 1e-12, "{value} for {expected}");
    }
    assert_eq!(shared.zeros[0].value, shared.zeros[1].value.conj());
    assert!(shared.closest_refused.is_some());
}

#[test]
fn tolerance_decides_and_the_refusal_is_told() {
    let (a, b) = (list(&[0.5, 0.8], &[]), list(&[0.5001, 0.8], &[]));
    let narrow = shared_zeros(&[a.clone(), b.clone()], 1e-5).unwrap();
    assert_eq!(narrow.zeros.len(), 1);
    assert!((narrow.closest_refused.unwrap() - 1e-4).abs() < 1e-9);
    assert_eq!(shared_zeros(&[a, b], 1e-3).unwrap().zeros.len(), 2);
}

#[test]
fn double_zeros_count_twice() {
    let a = list(&[0.5, 0.5, 0.9], &[]);
    let both = shared_zeros(&[a.clone(), list(&[0.5, 0.5, -0.2], &[])], 1e-6).unwrap();
    let once = shared_zeros(&[a, list(&[0.5, 0.3, -0.2], &[])], 1e-6).unwrap();
    assert_eq!((both.zeros.len(), once.zeros.len()), (2, 1));
}

#[test]
fn a_well_conditioned_member_outweighs_a_poor_one() {
    let (mut poor, good) = (list(&[1.0], &[]), list(&[1.0 + 2e-6], &[]));
    poor[0].condition = 100.0;
    let shared = shared_zeros(&[poor, good], 1e-5).unwrap();
    // The poor one counts 1e-4 of the good one: the mean is off by 2e-10.
    assert!((shared.zeros[0].value.re - (1.0 + 2e-6 - 2e-10)).abs() < 1e-13);
}

#[test]
fn nothing_is_shared_with_nothing() {
    assert_eq!(shared_zeros(&[], 1e-6).unwrap().zeros.len(), 0);
    assert_eq!(shared_zeros(&[list(&[0.5], &[]), Vec::new()], 1e-6).unwrap().zeros.len(), 0);
    let undefined = shared_zeros(&[list(&[f64::NAN], &[]), list(&[0.5], &[])], 1e-6);
    assert_eq!(undefined, Err(ReconstructError::ZeroNotFinite { difference: 0, index: 0 }));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            shared_zeros(&[], tolerance),
            Err(ReconstructError::InvalidTolerance { .. })
        ));
    }
}

proptest! {
    #[test]
    fn planted_zeros_are_found_whatever_the_order(
        common in prop::collection::vec(-0.9f64..0.9, 1..4),
        first in 2.0f64..3.0,
        second in -3.0f64..-2.0,
    ) {
        let with = |own: f64| list(&common.iter().copied().chain([own]).collect::<Vec<_>>(), &[]);
        let (a, b) = (with(first), with(second));
        // Neighbours closer than this are told apart only by luck in double precision.
        prop_assume!(common.iter().enumerate().all(|(i, x)| common[..i].iter().all(|y| (x - y).abs() > 1e-2)));
        let forth = shared_zeros(&[a.clone(), b.clone()], 1e-6).unwrap();
        let back = shared_zeros(&[b, a], 1e-6).unwrap();
        prop_assert_eq!(forth.zeros.len(), common.len());
        prop_assert_eq!(back.zeros.len(), common.len());
        for (x, y) in forth.values().iter().zip(back.values()) {
            prop_assert!((x - y).norm() < 1e-12);
        }
    }
}
