use super::*;
use crate::subspace::tests::{generator, normal};
use nalgebra::dmatrix;

/// A covariance, its root, and a noise covariance with two sensors and three block rows.
fn example() -> (DMatrix<f64>, DMatrix<f64>, Whitening) {
    let mut rng = generator(4);
    let root = normal(&mut rng, 9, 6);
    let noise = normal(&mut rng, 20, 6);
    let lower = (noise.transpose() * noise).cholesky().unwrap().unpack();
    (root.transpose() * &root, root, Whitening::Factor { lower, deviations: vec![2.0, 0.5] })
}

#[test]
fn covariance_and_triangle_give_the_same_spectrum() {
    let (covariance, root, factor) = example();
    for whitening in [Whitening::Levels(vec![0.1, 3.0]), factor] {
        for rows in [4, 6] {
            let a = whitening.spectrum(&Source::Covariance(covariance.clone()), rows).unwrap();
            let b = whitening.spectrum(&Source::Triangle(root.clone()), rows).unwrap();
            for (a, b) in a.values.iter().zip(&b.values) {
                assert!((a - b).abs() < 1e-12 * a.abs().max(1.0), "{a} {b}");
            }
            let values = whitening.values(&Source::Triangle(root.clone()), rows).unwrap();
            assert!((values[0] - b.values[0]).abs() < 1e-13 * values[rows - 1]);
            // Up to sign.
            assert!((a.vectors.column(0).dot(&b.vectors.column(0)).abs() - 1.0).abs() < 1e-10);
        }
    }
}

#[test]
fn noise_whitens_to_the_identity() {
    let (_, _, whitening) = example();
    let Whitening::Factor { lower, .. } = &whitening else { unreachable!() };
    let noise = lower * lower.transpose();
    for value in whitening.values(&Source::Covariance(noise), 6).unwrap() {
        assert!((value - 1.0).abs() < 1e-11, "{value}");
    }
    let levels = Whitening::Levels(vec![0.1, 3.0]);
    let noise = DMatrix::from_fn(4, 4, |i, k| if i == k { [0.01, 9.0][i % 2] } else { 0.0 });
    for value in levels.values(&Source::Covariance(noise), 4).unwrap() {
        assert!((value - 1.0).abs() < 1e-14);
    }
    assert_eq!(levels.deviations(), [0.1, 3.0]);
}

#[test]
fn what_annihilates_in_one_coordinates_does_in_the_other() {
    let (_, _, whitening) = example();
    // A direction, and what is orthogonal to it in whitened coordinates.
    let direction = dmatrix![1.0; -2.0; 0.3; 0.7; 5.0; 0.1];
    let whitened = whitening.whitened(direction.clone());
    let mut rng = generator(5);
    let other = normal(&mut rng, 6, 1);
    let orthogonal = &other - &whitened * (whitened.dot(&other) / whitened.norm_squared());
    let annihilator = whitening.annihilators(orthogonal);
    assert!(annihilator.dot(&direction).abs() < 1e-12 * annihilator.norm() * direction.norm());
    assert!(annihilator.dot(&direction.map(f64::abs)).abs() > 1e-3);
}
