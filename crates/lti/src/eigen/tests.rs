//! Tests of `eigen.rs`.

use nalgebra::dmatrix;

use super::*;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

fn check(a: &DMatrix<f64>, wanted: &[Complex<f64>], limit: f64) {
    let got = eigenvalues(a).expect("eigenvalues");
    assert_eq!(got.len(), wanted.len());
    for (x, y) in got.iter().zip(wanted) {
        assert!((x - y).norm() <= limit * y.norm(), "{got:?} is not {wanted:?}");
    }
}

#[test]
fn known_spectra() {
    check(&DMatrix::zeros(0, 0), &[], 0.0);
    check(&dmatrix![-3.0], &[c(-3.0, 0.0)], 0.0);
    check(&DMatrix::zeros(3, 3), &[c(0.0, 0.0); 3], 0.0);
    check(&DMatrix::identity(3, 3), &[c(1.0, 0.0); 3], 0.0);
    check(&dmatrix![1.0, 2.0; 3.0, 2.0], &[c(-1.0, 0.0), c(4.0, 0.0)], 0.0);
    check(&dmatrix![1.0, 1.0; -1.0, 1.0], &[c(1.0, 1.0), c(1.0, -1.0)], 1e-16);
    // The companion matrix of (x-1)(x-2)...(x-5).
    let companion = dmatrix![
        15.0, -85.0, 225.0, -274.0, 120.0;
        1.0, 0.0, 0.0, 0.0, 0.0;
        0.0, 1.0, 0.0, 0.0, 0.0;
        0.0, 0.0, 1.0, 0.0, 0.0;
        0.0, 0.0, 0.0, 1.0, 0.0];
    let wanted: Vec<_> = (1..=5).map(|k| c(f64::from(k), 0.0)).collect();
    check(&companion, &wanted, 0.0);
}

#[test]
fn small_eigenvalues_beside_large_ones() {
    // Exact eigenvalues -1 +- sqrt(1 - e): the small one is -e/2 - e^2/8.
    let e = 1e-12;
    let got = eigenvalues(&dmatrix![0.0, 1.0; -e, -2.0]).expect("eigenvalues");
    let small = -e / (1.0 + (1.0 - e).sqrt());
    assert!((got[1].re - small).abs() <= 3e-16 * small.abs(), "{:e} {small:e}", got[1].re);
}

#[test]
fn scales_and_units() {
    let a = dmatrix![0.0, 1.0, 0.3; -2.0, -0.1, 0.7; 0.2, 0.4, -0.9];
    let plain = eigenvalues(&a).expect("eigenvalues");
    for exponent in [-990, -500, 500, 990] {
        let scale = 2.0_f64.powi(exponent);
        let scaled = eigenvalues(&(&a * scale)).expect("eigenvalues");
        let back: Vec<_> = scaled.iter().map(|z| z / scale).collect();
        assert_eq!(back, plain, "2^{exponent}");
    }
    let units = [2.0_f64.powi(200), 1.0, 2.0_f64.powi(-200)];
    let odd = DMatrix::from_fn(3, 3, |i, j| a[(i, j)] * units[j] / units[i]);
    for (x, y) in eigenvalues(&odd).expect("eigenvalues").iter().zip(&plain) {
        assert!((x - y).norm() <= 3e-16 * y.norm());
    }
}

#[test]
fn pairs_are_exactly_conjugate_and_sorted() {
    let a = DMatrix::from_fn(7, 7, |i, j| ((3 * i + 5 * j * j + 1) as f64).sin());
    let got = eigenvalues(&a).expect("eigenvalues");
    for z in got.iter().filter(|z| z.im != 0.0) {
        assert!(got.contains(&z.conj()));
    }
    assert!(got.windows(2).all(|pair| compare(&pair[0], &pair[1]).is_le()));
    // The trace is the sum.
    let sum: Complex<f64> = got.iter().sum();
    assert!((sum.re - a.trace()).abs() < 1e-14 && sum.im == 0.0);
}

#[test]
fn condition_numbers() {
    // Normal matrices have condition 1.
    for pair in eigenpairs(&dmatrix![0.0, 1.0; -1.0, 0.0]).expect("eigenpairs") {
        assert!((pair.condition - 1.0).abs() < 1e-14);
    }
    // [1 t; 0 1+g]: |v||w|/|w^H v| = sqrt(1 + (t/g)^2) for both.
    let (t, g) = (3.0_f64, 0.01_f64);
    for pair in eigenpairs(&dmatrix![1.0, t; 0.0, 1.0 + g]).expect("eigenpairs") {
        let wanted = (1.0 + (t / g).powi(2)).sqrt();
        assert!((pair.condition / wanted - 1.0).abs() < 1e-10, "{} {wanted}", pair.condition);
        // Entry by entry a triangular matrix moves only its diagonal.
        assert!((pair.entrywise_condition / pair.value.re - 1.0).abs() < 1.1 * 3.0 / 0.01);
    }
    // A Jordan block is defective.
    let pairs = eigenpairs(&dmatrix![1.0, 1.0; 0.0, 1.0]).expect("eigenpairs");
    assert!(pairs.iter().all(|pair| pair.condition > 1e14));
}

#[test]
fn vectors_are_biorthogonal() {
    let a = DMatrix::from_fn(6, 6, |i, j| ((7 * i + 3 * j + i * j) as f64).cos());
    let pairs = eigenpairs(&a).expect("eigenpairs");
    for (i, x) in pairs.iter().enumerate() {
        for (j, y) in pairs.iter().enumerate() {
            let wanted = if i == j { 1.0 } else { 0.0 };
            assert!((x.left.dotc(&y.right) - wanted).norm() < 1e-12);
        }
        let (k, size) = largest(&x.right);
        assert!((x.right[k] - size).norm() < 1e-15, "the largest component is real and positive");
    }
}
