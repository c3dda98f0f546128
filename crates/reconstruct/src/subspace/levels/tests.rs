use super::*;
use crate::subspace::tests::{generator, normal};

/// Covariances of a signal in three of twelve directions of stacked sensors, two of them, and noise of these levels.
fn sources(levels: [f64; 2]) -> Vec<(Source, f64)> {
    (0..2)
        .map(|seed| {
            let mut rng = generator(seed);
            let noise = normal(&mut rng, 12, 4000);
            let signal = normal(&mut rng, 12, 3) * normal(&mut rng, 3, 4000);
            let h =
                DMatrix::from_fn(12, 4000, |i, k| signal[(i, k)] + levels[i % 2] * noise[(i, k)]);
            (Source::Covariance(&h * h.transpose() / 4000.0), 4000.0)
        })
        .collect()
}

const WINDOW: Window = Window { block_rows: 6, signal: 3 };

#[test]
fn levels_are_found_whatever_their_ratio() {
    for levels in [[0.1, 0.1], [0.5, 0.001], [1e-4, 0.03]] {
        let found =
            estimate(&sources(levels).iter().collect::<Vec<_>>(), &[1.5, 1.5], WINDOW).unwrap();
        assert!(found.converged && !found.rounding, "{found:?}");
        for (found, level) in found.deviations.iter().zip(levels) {
            assert!((found / level - 1.0).abs() < 0.02, "{found} {level}");
        }
    }
}

#[test]
fn no_noise_is_called_rounding() {
    let sources = sources([0.0, 0.0]);
    let roots = sources.into_iter().map(|(source, weight)| {
        let Source::Covariance(matrix) = source else { unreachable!() };
        // The exact root of a matrix of rank three: its three eigenvectors.
        let found = crate::subspace::dense::eigen(&matrix).unwrap();
        let root = DMatrix::from_fn(12, 12, |i, k| {
            if i < 9 { 0.0 } else { found.values[i].sqrt() * found.vectors[(k, i)] }
        });
        (Source::Triangle(root), weight)
    });
    let roots: Vec<_> = roots.collect();
    let found = estimate(&roots.iter().collect::<Vec<_>>(), &[1.5, 3.0], WINDOW).unwrap();
    assert!(found.rounding, "{found:?}");
    assert!((found.deviations[1] / found.deviations[0] - 2.0).abs() < 1e-12);
}

#[test]
fn the_window_leaves_half_of_the_directions_to_the_noise() {
    for (sensors, order) in [(2, 1), (2, 10), (3, 4), (3, 10), (6, 10)] {
        let rows = window_rows(sensors, order, 1000);
        assert!(2 * ((sensors - 1) * rows - order) >= (sensors - 1) * rows, "{sensors} {order}");
        assert_eq!(window_rows(sensors, order, 5), 5);
    }
}

#[test]
fn free_motion_has_more_noise_directions() {
    assert_eq!(noise_directions(&[0.8, 0.9, 1.0, 1.2, 40.0, 1e6], 3), 5);
    assert_eq!(noise_directions(&[0.8, 0.9, 1.0, 2e3, 2e3, 1e6], 3), 3);
    assert_eq!(noise_directions(&[0.8, 0.9, 1.0, 4.0, 5.0, 90.0], 3), 3);
}
