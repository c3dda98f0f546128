use lti::SamplePeriod;

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, system};
use crate::likelihood::inference::uncertainty::modes;
use crate::likelihood::{Mode, identify};

/// Roots of x^2 - 2 m x + (m^2 - q) by the companion matrix, whose entries are known to within `deviation`.
fn companion(mean: f64, square: f64, deviation: f64) -> Vec<Mode> {
    let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, square - mean * mean, 2.0 * mean]);
    let mut covariance = DMatrix::zeros(4, 4);
    // By columns: the lower row has the entries 1 and 3.
    covariance[(1, 1)] = deviation * deviation;
    modes(&a, SamplePeriod::new(1.0).unwrap(), &covariance, ModelBias::default()).unwrap()
}

#[test]
fn a_pair_by_hand() {
    // z = 0.5 +- 0.01: the product is off by 4e-4, so that z1 z2 = e^(s1 + s2) gives 2 m, and q is off by 4e-4 in z.
    let found = companion(0.5, 1e-4, 4e-4);
    let double = found[0].near_double.unwrap();
    let (upper, lower) = (0.51_f64.ln(), 0.49_f64.ln());
    assert!((double.mean.value.re - 0.5 * (upper + lower)).abs() < 1e-12);
    let expected = 0.5 * 4e-4 / (0.51 * 0.49);
    assert!((double.mean.real_standard_error() - expected).abs() < 1e-3 * expected);
    // dq = 4e-4 in z, over z^2 in s.
    let square = double.half_difference_squared;
    assert!((square.value.re - (0.5 * (upper - lower)).powi(2)).abs() < 1e-12);
    assert!((square.real_standard_error() - 4e-4 / 0.25).abs() < 1e-2 * 4e-4 / 0.25);
    // Two standard errors down it is a pair, whose imaginary part is sqrt(1.96 sd - q).
    let imaginary = (NORMAL_95 * square.real_standard_error() - square.value.re).sqrt();
    let found = found[0].continuous.imaginary_standard_error() * NORMAL_95;
    assert!((found - imaginary).abs() < 1e-2 * imaginary, "{found} {imaginary}");
}

#[test]
fn what_is_well_apart_is_left_alone() {
    for (square, deviation) in [(1e-2, 1e-3), (-1e-2, 1e-3)] {
        let found = companion(0.5, square, deviation);
        assert!(found.iter().all(|mode| mode.near_double.is_none()));
    }
}

/// For planted pairs that nearly coincide: the part of fits in which both eigenvalues are within two standard errors; where they are called nearly double, the part in which m is, that in which q is; and
/// the part that is called so.
fn coverage(pairs: &[[Complex<f64>; 2]], seeds: std::ops::Range<u64>) -> ([f64; 3], f64) {
    let (mut inside, mut count, mut flagged) = ([0.0; 3], 0.0, 0.0);
    for &[first, second] in pairs {
        for seed in seeds.clone() {
            let mut normal = Normal::new(seed);
            let z = [first, second].map(|s| (s * 0.1).exp());
            let roots =
                if first.im > 0.0 && second == first.conj() { vec![z[0]] } else { z.to_vec() };
            let planted = system(&roots, 3, 2, &mut normal);
            let disturbance = Disturbance { noise: 0.03, ..QUIET };
            let flights = fly(&planted, &[1000, 1000], &disturbance, &mut normal);
            let fit = identify(&flights.records, &[planted], &given(&flights.levels)).unwrap();
            count += 1.0;
            let near = |estimate: &ComplexEstimate, truth: Complex<f64>| {
                let off = estimate.value - truth;
                let (re, im) =
                    (estimate.real_standard_error(), estimate.imaginary_standard_error());
                f64::from(off.re.abs() <= 2.0 * re && off.im.abs() <= 2.0 * im + 1e-9)
            };
            if let Some(double) = fit.modes.iter().find_map(|mode| mode.near_double) {
                flagged += 1.0;
                inside[1] += near(&double.mean, (first + second) * 0.5);
                inside[2] +=
                    near(&double.half_difference_squared, ((first - second) * 0.5).powi(2));
            }
            // Each true eigenvalue is close to a fitted one or to its conjugate.
            let all = fit.modes.iter().flat_map(|mode| {
                let own = mode.continuous;
                [own, ComplexEstimate { value: own.value.conj(), ..own }]
            });
            let all: Vec<ComplexEstimate> = all.collect();
            let distance =
                |estimate: &ComplexEstimate, truth: Complex<f64>| (estimate.value - truth).norm();
            let is_inside = |truth: &Complex<f64>| {
                let nearest =
                    all.iter().min_by(|a, b| distance(a, *truth).total_cmp(&distance(b, *truth)));
                nearest.is_some_and(|estimate| near(estimate, *truth) > 0.0)
            };
            inside[0] += f64::from([first, second].iter().all(is_inside));
        }
    }
    ([inside[0] / count, inside[1] / flagged, inside[2] / flagged], flagged / count)
}

#[test]
fn standard_errors_of_nearly_double_eigenvalues_hold() {
    let real =
        |mean: f64, half: f64| [Complex::new(mean + half, 0.0), Complex::new(mean - half, 0.0)];
    let conjugate = |mean: f64, half: f64| [Complex::new(mean, half), Complex::new(mean, -half)];
    let oscillators = |half: f64| [Complex::new(-0.3, 3.0 + half), Complex::new(-0.3, 3.0 - half)];
    for pairs in [
        [real(-1.0, 0.0), real(-1.0, 0.05), real(-1.0, 0.1)],
        [conjugate(-1.0, 0.05), conjugate(-1.0, 0.1), conjugate(-1.0, 0.15)],
        [oscillators(0.0), oscillators(0.02), oscillators(0.05)],
    ] {
        let (inside, flagged) = coverage(&pairs, 0..SEEDS);
        assert!(inside.iter().all(|part| *part >= 0.85), "{:?}: {inside:?} {flagged}", pairs[0]);
        assert!(flagged > 0.5, "{:?}: {flagged}", pairs[0]);
    }
}

/// With 50 seeds 95, 95 and 95 % of the pairs are within two standard errors, 89 to 97 % of the means, 97 to 99 % of the squares.
const SEEDS: u64 = 20;
