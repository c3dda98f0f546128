use super::*;
use nalgebra::dmatrix;

/// Observability matrix and impulse response matrix of L = 8 block rows of a system with two states and three sensors.
fn example(b: &DVector<f64>, d: &DVector<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    let (a, c) = (dmatrix![0.9, 0.2; -0.3, 0.7], dmatrix![1.0, 0.0; 2.0, -1.0; 0.5, 3.0]);
    let mut powers = vec![c];
    for i in 1..8 {
        powers.push(&powers[i - 1] * &a);
    }
    let o = DMatrix::from_fn(24, 2, |i, k| powers[i / 3][(i % 3, k)]);
    let response = |lag: usize| if lag == 0 { d.clone() } else { &powers[lag - 1] * b };
    let t =
        DMatrix::from_fn(24, 8, |i, k| if i / 3 < k { 0.0 } else { response(i / 3 - k)[i % 3] });
    (o, t)
}

/// The orthogonal complement of both.
fn annihilators(o: &DMatrix<f64>, t: &DMatrix<f64>) -> DMatrix<f64> {
    let sum = o * o.transpose() + t * t.transpose();
    let found = crate::subspace::dense::eigen(&sum).unwrap();
    let count = found.values.iter().filter(|value| **value < 1e-10).count();
    found.vectors.columns(0, count).into_owned()
}

#[test]
fn the_direction_is_found_up_to_length_and_sign() {
    for b in [[1.0, 2.0], [-3.0, 0.1], [0.0, 5.0]] {
        let b = DVector::from_row_slice(&b);
        let (o, t) = example(&b, &DVector::zeros(3));
        let found = input_direction(&annihilators(&o, &t), &o, 3, DirectPath::Absent).unwrap();
        assert!(((found.b.dot(&b) / b.norm()).abs() - 1.0).abs() < 1e-13, "{}", found.b);
        assert!((found.b.norm() - 1.0).abs() < 1e-14 && found.d.is_none());
        assert!(found.ambiguity < 1e-12);
    }
}

#[test]
fn the_direct_path_comes_on_the_scale_of_b() {
    let (b, d) = (nalgebra::dvector![1.0, 2.0], nalgebra::dvector![0.3, -4.0, 0.1]);
    let (o, t) = example(&b, &d);
    let found = input_direction(&annihilators(&o, &t), &o, 3, DirectPath::Present).unwrap();
    // b comes back as factor * b, and d with the same factor.
    let factor = found.b.dot(&b) / b.norm_squared();
    assert!((found.b - b * factor).norm() < 1e-12);
    assert!((found.d.unwrap() - d * factor).norm() < 1e-12);
}

#[test]
fn a_direction_that_nothing_determines_is_ambiguous() {
    let (o, _) = example(&DVector::zeros(2), &DVector::zeros(3));
    // These annihilate nothing in particular.
    let noise = DMatrix::from_fn(24, 6, |i, k| ((5 * i + 11 * k * k) as f64).sin());
    let found = input_direction(&noise, &o, 3, DirectPath::Absent).unwrap();
    assert!(found.ambiguity > 0.1 && found.ambiguity <= 1.0);
}
