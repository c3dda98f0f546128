use super::*;
use crate::subspace::tests::{generator, normal};

/// Spaces of three records in twelve dimensions: each annihilates all but two common directions and three of its own.
fn spaces(noise: f64) -> (DMatrix<f64>, Spaces) {
    let mut rng = generator(6);
    let common = normal(&mut rng, 12, 2);
    let annihilators = (0..3)
        .map(|_| {
            let own = normal(&mut rng, 12, 3);
            let all = DMatrix::from_fn(
                12,
                5,
                |i, k| if k < 2 { common[(i, k)] } else { own[(i, k - 2)] },
            );
            let covariance = &all * all.transpose() + normal(&mut rng, 12, 12).scale(noise);
            eigen(&(&covariance + covariance.transpose())).unwrap().vectors
        })
        .collect();
    (common, Spaces { annihilators, noise: 9, silent: vec![0; 3], orthonormal: true })
}

#[test]
fn common_directions_are_found_and_counted() {
    for noise in [0.0, 1e-4, 1e-2] {
        let (planted, spaces) = spaces(noise);
        let gaps = spaces.gaps(5).unwrap();
        assert_eq!(best(&gaps), 2, "{gaps:?}");
        let (found, evidence) = spaces.common(2).unwrap();
        assert_eq!((evidence.order, evidence.eigenvalues.len()), (2, 12));
        assert!((evidence.gap / gaps[1].1 - 1.0).abs() < 1e-6 || evidence.gap > 1e12);
        let outside = &planted - &found * found.tr_mul(&planted);
        assert!(outside.norm() < 1e-13 + 5.0 * noise, "{noise}: {:e}", outside.norm());
    }
}

#[test]
fn silent_directions_are_kept_whatever_the_order() {
    let (_, mut spaces) = spaces(0.0);
    assert_eq!(spaces.annihilators(1, 4).ncols(), 5);
    spaces.silent = vec![7, 7, 7];
    assert_eq!(spaces.annihilators(1, 4).ncols(), 7);
    // Seven directions each, for orders from two on: their gaps belong to the same eigenvalues.
    let gaps = spaces.gaps(5).unwrap();
    assert!(gaps[1].1 > 1e12 && gaps[2..].iter().all(|(_, gap)| *gap < 100.0), "{gaps:?}");
}

#[test]
fn the_best_order_is_the_largest_with_a_gap_of_its_own() {
    let check = |gaps: &[f64], expected: usize| {
        let gaps: Vec<_> = gaps.iter().enumerate().map(|(i, gap)| (i + 1, *gap)).collect();
        assert_eq!(best(&gaps), expected, "{gaps:?}");
    };
    check(&[2.0, 3.0, 700.0, 6e4, 1.1, 1.2], 4);
    check(&[3.5, 4.0, 17.0, 2900.0, 40.0, 42.0, 1.7], 4);
    // A slow mode behind a larger gap.
    check(&[1.0, 6.0, 170.0, 15.0, 2.5, 1.5], 4);
    check(&[1.0, 6.0, 170.0, 5.0, 2.5, 1.5], 3);
    check(&[1.2, 1e15, 30.0, 1.5], 2);
    check(&[1.2, 1.5, 1.1], 2);
    check(&[1.0], 1);
}

#[test]
fn the_angles_of_two_records_are_the_eigenvalues_of_the_sum() {
    for noise in [0.0, 1e-3] {
        let (_, mut spaces) = spaces(noise);
        spaces.annihilators.pop();
        let fast = spaces.gaps(4).unwrap();
        spaces.orthonormal = false;
        for ((order, fast), (_, slow)) in fast.iter().zip(spaces.gaps(4).unwrap()) {
            // Beyond 1e12 a gap is one between a number and rounding errors.
            let equal = (fast / slow - 1.0).abs() < 1e-6 || fast.min(slow) > 1e12;
            assert!(equal, "{noise} {order}: {fast} {slow}");
        }
    }
}
