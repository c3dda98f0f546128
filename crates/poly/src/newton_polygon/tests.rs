//! Tests of the Newton polygon.

use super::NewtonPolygon;

const NONE: f64 = f64::NEG_INFINITY;

fn check(heights: &[f64], expected: &[(usize, f64)]) {
    let polygon = NewtonPolygon::new(heights);
    let edges: Vec<(usize, f64)> = polygon.edges().map(|e| (e.roots, e.log2_modulus)).collect();
    assert_eq!(edges, expected);
}

#[test]
fn edges() {
    check(&[0.0, 0.0], &[(1, 0.0)]);
    // x^4 - 16: one circle of radius 2.
    check(&[4.0, NONE, NONE, NONE, 0.0], &[(4, 1.0)]);
    // (x - 1)(x - 2^10): moduli 2^0 and 2^10.
    check(&[10.0, 10.0, 0.0], &[(1, 0.0), (1, 10.0)]);
    // A point below the hull does not count, nor one on it.
    check(&[0.0, -5.0, 0.0], &[(2, 0.0)]);
    check(&[0.0, 0.0, 0.0], &[(2, 0.0)]);
    check(&[0.0, 3.0, 1.0, 3.5, NONE, 0.0], &[(1, -3.0), (2, -0.25), (2, 1.75)]);
    check(&[7.0], &[]);
}

#[test]
fn heights() {
    let polygon = NewtonPolygon::new(&[0.0, 3.0, 1.0, 3.5, NONE, 0.0]);
    let heights: Vec<f64> = (0..6).map(|k| polygon.height(k)).collect();
    assert_eq!(heights, [0.0, 3.0, 3.25, 3.5, 1.75, 0.0]);
}
