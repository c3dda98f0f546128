use super::*;

fn eigenvalues(a: &DMatrix<f64>) -> Vec<(f64, f64)> {
    let mut all: Vec<_> = a.complex_eigenvalues().iter().map(|z| (z.re, z.im.abs())).collect();
    all.sort_by(|x, y| x.0.total_cmp(&y.0));
    all
}

fn close(found: &[(f64, f64)], expected: &[(f64, f64)]) -> bool {
    found.iter().zip(expected).all(|(f, e)| (f.0 - e.0).abs() < 1e-10 && (f.1 - e.1).abs() < 1e-6)
}

/// P diag P^-1 with a P that is not orthogonal.
fn system(blocks: &DMatrix<f64>) -> DMatrix<f64> {
    let n = blocks.nrows();
    let p =
        DMatrix::from_fn(n, n, |i, k| if i == k { 2.0 } else { 1.0 / (1.0 + (i + 2 * k) as f64) });
    &p * blocks * p.clone().try_inverse().unwrap()
}

#[test]
fn only_the_slow_real_modes_move() {
    let mut blocks = DMatrix::from_diagonal(&nalgebra::dvector![0.999, 0.95, 0.9, 0.9, -0.99]);
    blocks[(2, 3)] = 0.3;
    blocks[(3, 2)] = -0.3;
    let all = moved(&system(&blocks), 1000.0);
    // 0.999 is e^-1 over the record: the targets 5, 1 and -30 are elsewhere, and so is -3.
    let slow = [5.0, 1.0, -3.0, -30.0].map(|target: f64| (target / 1000.0).exp());
    assert_eq!(all.len(), 5);
    for (found, slow) in all.iter().zip(slow) {
        let mut expected = [(-0.99, 0.0), (0.9, 0.3), (0.9, 0.3), (0.95, 0.0), (slow, 0.0)];
        assert!((found.eigenvalue - slow).abs() < 1e-15);
        expected.sort_by(|x, y| x.0.total_cmp(&y.0));
        assert!(close(&eigenvalues(&found.a), &expected), "{:?}", eigenvalues(&found.a));
    }
    let last = [(-0.99, 0.0), (0.9, 0.3), (0.9, 0.3), (0.999, 0.0), (0.005_f64.exp(), 0.0)];
    assert!(close(&eigenvalues(&all[4].a), &last));
}

#[test]
fn where_the_mode_is_already_it_is_not_put() {
    let blocks = DMatrix::from_diagonal(&nalgebra::dvector![(-0.0028_f64).exp(), 0.5]);
    // -2.8 is as good as -3.
    assert_eq!(moved(&system(&blocks), 1000.0).len(), 3 + 1);
}

#[test]
fn an_overdamped_pair_comes_apart() {
    let mut blocks = DMatrix::from_diagonal_element(2, 2, 0.95);
    blocks[(0, 1)] = 0.01;
    blocks[(1, 0)] = -0.01;
    let all = moved(&system(&blocks), 2000.0);
    assert_eq!(all.len(), 4);
    assert!(close(&eigenvalues(&all[0].a), &[(0.95, 0.0), (0.0025_f64.exp(), 0.0)]));
    // An oscillation stays one.
    blocks[(0, 1)] = 0.2;
    blocks[(1, 0)] = -0.2;
    assert!(moved(&system(&blocks), 2000.0).is_empty());
}

#[test]
fn a_defective_matrix_is_left_alone() {
    let mut jordan = DMatrix::from_diagonal_element(2, 2, 0.9);
    jordan[(0, 1)] = 1.0;
    assert!(moved(&jordan, 100.0).is_empty());
}
