use super::*;

/// x (zI - A), with A row by row.
fn times(z: Complex<f64>, a: &[f64], x: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let n = x.len();
    (0..n).map(|l| z * x[l] - (0..n).map(|i| x[i] * a[i * n + l]).sum::<Complex<f64>>()).collect()
}

#[test]
fn solves_rows() {
    // The zero in the corner makes pivoting necessary at z = 0.
    let a = [0.0, 2.0, -1.0, 3.0, 0.5, 0.25, -2.0, 1.0, 4.0];
    for z in [Complex::new(0.0, 0.0), Complex::new(0.3, 0.8), Complex::new(-1.0, 0.0)] {
        let mut resolvent = Resolvent::new(3);
        resolvent.factor(z, &a);
        let x = [Complex::new(1.0, -2.0), Complex::new(0.5, 0.0), Complex::new(0.0, 3.0)];
        let mut row = times(z, &a, &x);
        resolvent.solve_row(&mut row);
        for k in 0..3 {
            assert!((row[k] - x[k]).norm() < 1e-14, "{z}: {} for {}", row[k], x[k]);
        }
    }
}

#[test]
fn an_eigenvalue_gives_its_left_eigenvector() {
    // A = [1 1; 0 0.5] at z = 1: the left eigenvector is (1, 2).
    let mut resolvent = Resolvent::new(2);
    resolvent.factor(Complex::new(1.0, 0.0), &[1.0, 1.0, 0.0, 0.5]);
    let mut x = [Complex::new(1.0, 0.0), Complex::new(1.0, 0.0)];
    resolvent.solve_row(&mut x);
    assert!(x[0].re.is_finite() && (x[1] / x[0] - 2.0).norm() < 1e-14);
    assert!(resolvent.smallest_pivot() < 1e-15);
}
