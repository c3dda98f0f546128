//! Tests of `eigen.rs`.

use nalgebra::dmatrix;
use proptest::prelude::*;

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

#[test]
fn entries_from_one_end_of_the_range_to_the_other() {
    let real = |values: &[f64]| values.iter().map(|&x| c(x, 0.0)).collect::<Vec<_>>();
    check(&dmatrix![0.0, 1e300; 1e-300, 0.0], &real(&[-1.0, 1.0]), 4e-16);
    // 1 and 2 coupled by 1e308 * 1e-308 = 1: (3 -+ sqrt 5)/2.
    let wanted = [(3.0 - 5.0_f64.sqrt()) / 2.0, (3.0 + 5.0_f64.sqrt()) / 2.0];
    check(&dmatrix![1.0, 1e308; 1e-308, 2.0], &real(&wanted), 1e-15);
    check(&dmatrix![0.0, 1e308; 1.0, 0.0], &real(&[-1e154, 1e154]), 4e-16);
    check(&dmatrix![0.0, 1e308; -1.0, 0.0], &[c(0.0, 1e154), c(0.0, -1e154)], 4e-16);
    check(&dmatrix![0.0, 5e-324; 5e-324, 0.0], &real(&[-5e-324, 5e-324]), 0.0);
    // A cycle of weights 1e300, 1e300, 1e300, 1e-300: the fourth roots of 1e600.
    let cycle = dmatrix![
        0.0, 1e300, 0.0, 0.0;
        0.0, 0.0, 1e300, 0.0;
        0.0, 0.0, 0.0, 1e300;
        1e-300, 0.0, 0.0, 0.0];
    let long = DMatrix::from_fn(20, 20, |i, j| match (i, j) {
        (19, 0) => 1e-300,
        _ if j == i + 1 => 1e300,
        _ => 0.0,
    });
    for value in eigenvalues(&long).expect("eigenvalues") {
        // 19 weights of 1e300 and one of 1e-300: modulus 10^(300 * 18 / 20).
        assert!((value.norm() / 1e270 - 1.0).abs() < 1e-12, "{value}");
    }
    check(&cycle, &[c(-1e150, 0.0), c(0.0, 1e150), c(0.0, -1e150), c(1e150, 0.0)], 1e-14);
}

#[test]
fn vectors_of_widely_spread_matrices() {
    // v = (1, 1e-300) and w = (1, 1e300)/2 for the eigenvalue 1, the second sign changed for -1.
    for pair in eigenpairs(&dmatrix![0.0, 1e300; 1e-300, 0.0]).expect("eigenpairs") {
        let sign = pair.value.re.signum();
        let close = |x: Complex<f64>, y: f64| (x / y - 1.0).norm() < 1e-14;
        assert!(close(pair.right[0], 1.0) && close(pair.right[1], sign * 1e-300), "{pair:?}");
        assert!(close(pair.left[0], 0.5) && close(pair.left[1], sign * 0.5e300), "{pair:?}");
        assert!((pair.condition / 0.5e300 - 1.0).abs() < 1e-14, "{pair:?}");
        assert!((pair.entrywise_condition - 1.0).abs() < 1e-14, "{pair:?}");
    }
}

#[test]
fn eigenvalues_beyond_the_range_are_an_error() {
    let m = f64::MAX;
    // 2 MAX and 0, in either arrangement, and -5 MAX.
    for a in [dmatrix![m, m; m, m], dmatrix![m, -m; -m, m], DMatrix::from_element(5, 5, -m)] {
        let got = eigenvalues(&a);
        assert!(matches!(got, Err(LtiError::Overflow { .. })), "{got:?}");
    }
    check(
        &dmatrix![0.5 * m, 0.5 * m; -0.5 * m, 0.5 * m],
        &[c(0.5 * m, 0.5 * m), c(0.5 * m, -0.5 * m)],
        1e-15,
    );
}

/// A number of either sign with its decimal exponent spread evenly over most of the range.
fn any_size() -> impl Strategy<Value = f64> {
    (-300.0..300.0_f64, any::<bool>()).prop_map(|(power, negative)| {
        if negative { -10.0_f64.powf(power) } else { 10.0_f64.powf(power) }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn values_are_finite_or_an_error(
        a in (1..7_usize).prop_flat_map(|n| prop::collection::vec(any_size(), n * n)
            .prop_map(move |entries| DMatrix::from_vec(n, n, entries)))
    ) {
        if let Ok(pairs) = eigenpairs(&a) {
            prop_assert_eq!(pairs.len(), a.nrows());
            for pair in pairs {
                prop_assert!(pair.value.is_finite());
                prop_assert!(pair.right.iter().chain(pair.left.iter()).all(|x| x.is_finite()));
                prop_assert!(!pair.condition.is_nan() && !pair.entrywise_condition.is_nan());
            }
        }
    }

    #[test]
    fn two_by_two_as_in_closed_form(entries in prop::collection::vec(any_size(), 4)) {
        let [a, b, c, d] = entries[..] else { unreachable!("four entries were drawn") };
        // Everything over the size s: lambda = m -+ sqrt(h^2 + b c), the product of b and c by its square root.
        let product = b.abs().sqrt() * c.abs().sqrt();
        let s = a.abs().max(d.abs()).max(product);
        let (m, h) = ((a / s + d / s) / 2.0, (a / s - d / s) / 2.0);
        let root = Complex::new(h * h + b.signum() * c.signum() * (product / s).powi(2), 0.0).sqrt();
        let got = eigenvalues(&DMatrix::from_row_slice(2, 2, &entries)).expect("eigenvalues");
        for wanted in [m - root, m + root] {
            let error = got.iter().map(|z| (z / s - wanted).norm()).fold(f64::INFINITY, f64::min);
            prop_assert!(error < 1e-12, "{wanted} is not in {got:?} / {s:e}");
        }
    }

    #[test]
    fn units_of_the_states_do_not_matter(
        entries in prop::collection::vec(-1.0..1.0_f64, 9),
        units in prop::collection::vec(-500..500_i32, 3),
    ) {
        let a = DMatrix::from_vec(3, 3, entries);
        let odd = DMatrix::from_fn(3, 3, |i, j| times_power_of_two(a[(i, j)], units[j] - units[i]));
        // Eigenvalues next to a double one may be ordered otherwise: compared only where they are well conditioned.
        let plain = eigenpairs(&a).expect("eigenpairs");
        let got = eigenvalues(&odd).expect("eigenvalues");
        for pair in plain.iter().filter(|pair| pair.condition < 100.0) {
            let nearest = got.iter().map(|z| (z - pair.value).norm()).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest < 1e-12, "{:?} is not in {got:?}", pair.value);
        }
    }
}
