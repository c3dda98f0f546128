use super::*;

/// A deterministic, well spread matrix.
fn matrix(rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |i, j| {
        (1.3 * i as f64 + 0.7 * (j * j) as f64 + 0.1).sin() + 0.2 * (i % 3) as f64
    })
}

/// Folds `all` in blocks of `height` rows.
fn fold(all: &DMatrix<f64>, height: usize) -> Triangle {
    let mut triangle = Triangle::new(all.ncols() - 1);
    let mut from = 0;
    while from < all.nrows() {
        let rows = height.min(all.nrows() - from);
        triangle.absorb(&mut all.rows(from, rows).into_owned());
        from += rows;
    }
    triangle
}

#[test]
fn triangle_has_the_gram_matrix_of_the_rows_whatever_the_blocks() {
    let all = matrix(101, 7);
    let gram = all.transpose() * &all;
    for height in [1, 2, 5, 7, 50, 101, 1000] {
        let triangle = fold(&all, height);
        let difference = triangle.r.transpose() * &triangle.r - &gram;
        assert!(difference.amax() < 1e-13 * gram.amax(), "{height}: {}", difference.amax());
        assert_eq!(triangle.rows(), 101);
        for i in 0..7 {
            for j in 0..i {
                assert_eq!(
                    triangle.r[(i, j)].to_bits(),
                    0.0_f64.to_bits(),
                    "nothing below the diagonal"
                );
            }
        }
    }
}

#[test]
fn residual_and_right_hand_side_solve_a_line_by_hand() {
    // Psi = (1, 2, 4) on Phi = (1, 1, 1): mean 7/3, residual (-4/3, -1/3, 5/3), its norm sqrt(42) / 3.
    let mut triangle = Triangle::new(1);
    triangle.absorb(&mut DMatrix::from_row_slice(3, 2, &[1.0, 1.0, 1.0, 2.0, 1.0, 4.0]));
    let slope = triangle.right_hand_side()[0] / triangle.regressors()[(0, 0)];
    assert!((slope - 7.0 / 3.0).abs() < 1e-15, "{slope}");
    assert!((triangle.residual_norm() - 42.0_f64.sqrt() / 3.0).abs() < 1e-15);
}

#[test]
fn empty_blocks_and_zero_columns_are_harmless() {
    let mut triangle = Triangle::new(2);
    triangle.absorb(&mut DMatrix::zeros(0, 3));
    assert_eq!((triangle.rows(), triangle.columns()), (0, 2));
    triangle.absorb(&mut DMatrix::from_row_slice(2, 3, &[0.0, 3.0, 1.0, 0.0, 4.0, 1.0]));
    assert!(triangle.r.iter().all(|x| x.is_finite()));
    assert!((triangle.regressors().column(1).norm() - 5.0).abs() < 1e-15);
}
