use super::*;
use nalgebra::dmatrix;

#[test]
fn eigenvalues_ascend_and_vectors_belong_to_them() {
    let matrix = dmatrix![2.0, 1.0, 0.0; 1.0, 2.0, 0.0; 0.0, 0.0, -5.0];
    let found = eigen(&matrix).unwrap();
    for (found, expected) in found.values.iter().zip([-5.0, 1.0, 3.0]) {
        assert!((found - expected).abs() < 1e-14);
    }
    for (value, vector) in found.values.iter().zip(found.vectors.column_iter()) {
        assert!((&matrix * vector - vector * *value).norm() < 1e-14);
    }
    assert_eq!(eigenvalues(&matrix).unwrap().len(), 3);
}

#[test]
fn small_values_of_a_square_keep_their_digits() {
    // Singular values 1e8 and 3e-4: the square of the first is beyond 1e23 times that of the second.
    let found = eigen_of_square(&dmatrix![1e8, 0.0; 0.0, 3e-4; 0.0, 0.0]).unwrap();
    assert!((found.values[0].sqrt() / 3e-4 - 1.0).abs() < 1e-12, "{:?}", found.values);
    assert!((found.vectors[(1, 0)].abs() - 1.0).abs() < 1e-12);
}

#[test]
fn least_squares_of_nearly_orthonormal_columns_keep_their_digits() {
    for seed in 0..20 {
        let mut rng = crate::subspace::tests::generator(seed);
        let a = crate::subspace::tests::normal(&mut rng, 90, 4).qr().q().rows(0, 84).into_owned();
        let x = crate::subspace::tests::normal(&mut rng, 4, 4);
        let (found, values) = least_squares(&a, &(&a * &x), 1e-14).unwrap();
        assert!((found - x).norm() < 1e-13);
        assert!(values[0] <= 1.0 + 1e-14 && values.is_sorted_by(|a, b| a >= b));
    }
}

#[test]
fn dependent_columns_give_the_shortest_solution() {
    let a = dmatrix![1.0, 1.0; 2.0, 2.0; 0.0, 0.0];
    let (found, _) = least_squares(&a, &dmatrix![1.0; 2.0; 7.0], 1e-12).unwrap();
    assert!((found - dmatrix![0.5; 0.5]).norm() < 1e-14);
}
