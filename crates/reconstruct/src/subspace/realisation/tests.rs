use super::*;
use nalgebra::{DVector, dmatrix};

fn observability(a: &DMatrix<f64>, c: &DMatrix<f64>, rows: usize) -> DMatrix<f64> {
    let mut blocks = vec![c.clone()];
    for i in 1..rows {
        blocks.push(&blocks[i - 1] * a);
    }
    DMatrix::from_fn(rows * c.nrows(), a.nrows(), |i, k| blocks[i / c.nrows()][(i % c.nrows(), k)])
}

#[test]
fn shift_invariance_gives_the_system_back() {
    let (a, c) = (dmatrix![0.9, 0.2; -0.3, 1.1], dmatrix![1.0, 0.0; 2.0, -1.0]);
    let found = realise(&observability(&a, &c, 6), 2).unwrap();
    assert!((found.a - a).norm() < 1e-13 && (&found.c - &c).norm() < 1e-15);
    assert!(found.residual < 1e-14 && found.condition > 1.0 && found.condition < 100.0);
}

#[test]
fn a_matrix_without_shift_invariance_says_so() {
    let matrix = DMatrix::from_fn(8, 2, |i, k| ((7 * i * i + 3 * k) as f64).sin());
    assert!(realise(&matrix, 2).unwrap().residual > 0.1);
    // A state that no sensor shows leaves its direction out.
    let found = realise(&dmatrix![1.0, 0.0; 0.5, 0.0; 0.25, 0.0], 1).unwrap();
    assert!(found.condition.is_infinite() && found.a.iter().all(|entry| entry.is_finite()));
    assert!((found.a[(0, 0)] - 0.5).abs() < 1e-15);
}

#[test]
fn eigenvectors_of_simple_and_of_multiple_eigenvalues() {
    let check = |a: DMatrix<f64>, value: Complex<f64>, tolerance: f64| {
        let vector = eigenvector(&a, value).unwrap();
        let residual = a.map(Complex::from) * &vector - &vector * value;
        assert!(residual.norm() < tolerance, "{value}: {:e}", residual.norm());
        assert!((vector.norm() - 1.0).abs() < 1e-14);
    };
    check(dmatrix![0.0, 2.0; -2.0, 0.0], Complex::new(0.0, 2.0), 1e-9);
    check(dmatrix![1.0, 5.0; 0.0, 1.0], Complex::new(1.0, 0.0), 1e-4);
    check(DMatrix::identity(3, 3), Complex::new(1.0, 0.0), 1e-9);
    check(
        DMatrix::from_diagonal(&DVector::from_row_slice(&[0.0, 0.5])),
        Complex::new(0.0, 0.0),
        1e-9,
    );
}
