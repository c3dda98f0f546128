//! Reads the files in `tests/data`, and measures distances.

use nalgebra::DMatrix;
use num_complex::Complex;
use serde_json::Value;

pub(crate) fn oracle() -> Value {
    serde_json::from_str(include_str!("../data/oracle.json")).expect("oracle.json is JSON")
}

pub(crate) fn aircraft() -> Value {
    serde_json::from_str(include_str!("../data/aircraft.json")).expect("aircraft.json is JSON")
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(number).collect()
}

pub(crate) fn matrix(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> =
        value.as_array().expect("a list of rows").iter().map(numbers).collect();
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

pub(crate) fn complex(value: &Value) -> Complex<f64> {
    Complex::new(number(&value[0]), number(&value[1]))
}

pub(crate) fn complexes(value: &Value) -> Vec<Complex<f64>> {
    value.as_array().expect("a list").iter().map(complex).collect()
}

/// Largest |x - y| over the largest |y|.
pub(crate) fn relative(x: &DMatrix<f64>, y: &DMatrix<f64>) -> f64 {
    assert_eq!(x.shape(), y.shape());
    if y.amax() == 0.0 { x.amax() } else { (x - y).amax() / y.amax() }
}

/// Largest |x - y| / |y| entry by entry; an entry that should be 0 has to be.
pub(crate) fn entrywise(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len(), "{x:?} {y:?}");
    let one = |(x, y): (&f64, &f64)| if x == y { 0.0 } else { (x - y).abs() / y.abs() };
    x.iter().zip(y).map(one).fold(0.0, f64::max)
}

/// The largest distance between two lists of points after pairing them greedily, relative to each point of `y`.
pub(crate) fn distances(x: &[Complex<f64>], y: &[Complex<f64>]) -> Vec<f64> {
    assert_eq!(x.len(), y.len(), "{x:?} {y:?}");
    let mut left = x.to_vec();
    let mut result = Vec::new();
    for target in y {
        let (k, _) = left
            .iter()
            .enumerate()
            .min_by(|(_, a), (_, b)| (*a - target).norm().total_cmp(&(*b - target).norm()))
            .expect("as many left as there are targets");
        result.push((left.swap_remove(k) - target).norm());
    }
    result
}

/// As [`distances`], the largest relative to the modulus of its target (absolute for targets at 0).
pub(crate) fn worst_relative(x: &[Complex<f64>], y: &[Complex<f64>]) -> f64 {
    let size = |z: &Complex<f64>| if z.norm() == 0.0 { 1.0 } else { z.norm() };
    distances(x, y).iter().zip(y).map(|(d, z)| d / size(z)).fold(0.0, f64::max)
}
