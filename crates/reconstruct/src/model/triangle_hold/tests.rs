use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::{Normal, system};

/// A Dutch roll, a mode that decays quickly, an integrator.
const EIGENVALUES: [Complex<f64>; 3] =
    [Complex::new(0.9, 0.3), Complex::new(0.3, 0.0), Complex::new(1.0, 0.0)];

#[test]
fn the_matrix_has_the_eigenvalues_of_its_definition() {
    let exact = |z: Complex<f64>| {
        let off = z - 1.0;
        if off.norm() == 0.0 { Complex::new(0.5, 0.0) } else { (off - z.ln()) / (off * off) }
    };
    let a = system(&EIGENVALUES, 3, 2, &mut Normal::new(8)).a;
    let found = TriangleHold::new(&a).unwrap();
    let mut values: Vec<_> = found.k.complex_eigenvalues().iter().copied().collect();
    for z in [EIGENVALUES[0], EIGENVALUES[0].conj(), EIGENVALUES[1], EIGENVALUES[2]] {
        let distance = |k: &Complex<f64>| (k - exact(z)).norm();
        let (place, value) = values
            .iter()
            .copied()
            .enumerate()
            .min_by(|x, y| distance(&x.1).total_cmp(&distance(&y.1)))
            .unwrap();
        assert!(distance(&value) < 1e-9, "{z}: {value} for {}", exact(z));
        values.remove(place);
    }
}

#[test]
fn the_derivative_is_that_of_differences() {
    const STEP: f64 = 1e-6;
    let mut normal = Normal::new(9);
    let a = system(&EIGENVALUES, 3, 2, &mut normal).a;
    let (c, b) = (normal.vector(4).transpose(), normal.vector(4));
    let slope = TriangleHold::new(&a).unwrap().slope(&c, &b);
    for k in 0..16 {
        let at = |step: f64| {
            let mut moved = a.clone();
            moved[k] += step;
            (&c * TriangleHold::new(&moved).unwrap().k * &b)[0]
        };
        let difference = (at(STEP) - at(-STEP)) / (2.0 * STEP);
        assert!((slope[k] - difference).abs() < 1e-7 * (1.0 + difference.abs()), "{k}");
    }
}

#[test]
fn a_negative_eigenvalue_on_a_point_of_the_rule_has_none() {
    let (t, _) = gauss(POINTS)[3];
    let a = DMatrix::from_row_slice(2, 2, &[1.0 - 1.0 / t, 0.0, 0.0, 0.5]);
    assert!(TriangleHold::new(&a).is_none_or(|found| found.k.amax() > 1e10));
}
