//! Tests of the least-squares kernel against hand-made problems.

use super::{C, Factored};

fn real(columns: &[&[f64]]) -> Vec<Vec<C>> {
    columns.iter().map(|c| c.iter().map(|&x| C::new(x, 0.0)).collect()).collect()
}

#[test]
fn fits_a_line() {
    // Line through (0, 1), (1, 3), (2, 4), (3, 4): intercept 1.5, slope 1.
    let factored = Factored::new(real(&[&[1.0; 4], &[0.0, 1.0, 2.0, 3.0]])).unwrap();
    let solution = factored.solve(&real(&[&[1.0, 3.0, 4.0, 4.0]])[0]);
    assert!((solution[0] - 1.5).norm() < 1e-14);
    assert!((solution[1] - 1.0).norm() < 1e-14);
    assert!(solution.iter().all(|x| x.im == 0.0), "real data stay real");
}

#[test]
fn solves_a_complex_system() {
    let i = C::i();
    let columns = vec![vec![i, C::new(2.0, 0.0), i], vec![C::new(1.0, 1.0), -i, C::new(0.5, 0.0)]];
    let expected = [C::new(0.25, -3.0), C::new(1.5, 2.0)];
    let right: Vec<C> =
        (0..3).map(|k| columns[0][k] * expected[0] + columns[1][k] * expected[1]).collect();
    let solution = Factored::new(columns).unwrap().solve(&right);
    for (x, y) in solution.iter().zip(expected) {
        assert!((x - y).norm() < 1e-14);
    }
}

#[test]
fn smallest_singular_value_and_vector() {
    // [[3, 0], [4, 5]]: singular values sqrt 45 and sqrt 5, the smaller with vector (1, -1)/sqrt 2.
    let (value, vector) =
        Factored::new(real(&[&[3.0, 4.0], &[0.0, 5.0]])).unwrap().smallest_singular();
    assert!((value - 5f64.sqrt()).abs() < 1e-7);
    assert!((vector[0] + vector[1]).norm() < 1e-3);
    // Exactly singular.
    let (value, vector) =
        Factored::new(real(&[&[0.0, 0.0, 0.0], &[1.0, 2.0, 2.0]])).unwrap().smallest_singular();
    assert!(value < f64::MIN_POSITIVE);
    assert!((vector[0].norm() - 1.0).abs() < 1e-15 && vector[1].norm() < 1e-15);
}

#[test]
fn refuses_what_it_cannot_factor() {
    assert!(Factored::new(real(&[&[1.0], &[2.0]])).is_none());
    assert!(Factored::new(real(&[&[f64::NAN, 1.0]])).is_none());
}
