//! The inverse of a Gram matrix on the directions that it knows, as a factor.

use nalgebra::DMatrix;

/// F with F' F the inverse of a Gram matrix, one row for each direction that it knows: those whose eigenvalue, with all diagonal entries scaled to 1, is above
/// this part of the largest one. The inverse itself, where an eigenvalue is small, would lose what is small in the other directions. `None` where an entry is not
/// finite.
pub(crate) fn inverse_factor(gram: &DMatrix<f64>, tolerance: f64) -> Option<DMatrix<f64>> {
    let size = gram.nrows();
    let scale = gram.diagonal().map(|entry| if entry > 0.0 { 1.0 / entry.sqrt() } else { 0.0 });
    let unit = DMatrix::from_fn(size, size, |i, k| gram[(i, k)] * scale[i] * scale[k]);
    if !unit.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    if size == 0 {
        return Some(unit);
    }
    let eigen = unit.symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let rows: Vec<_> = (0..size)
        .filter(|&k| eigen.eigenvalues[k] > tolerance * largest)
        .map(|k| {
            let vector = eigen.eigenvectors.column(k).component_mul(&scale);
            vector.transpose() / eigen.eigenvalues[k].sqrt()
        })
        .collect();
    Some(if rows.is_empty() { DMatrix::zeros(0, size) } else { DMatrix::from_rows(&rows) })
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, dmatrix};

    use super::*;

    const TOLERANCE: f64 = 1e-12;

    #[test]
    fn the_factor_makes_the_inverse() {
        // Of scales far apart.
        let gram = dmatrix![4.0e12, 1.0e6, 0.0; 1.0e6, 9.0, 1.0e-6; 0.0, 1.0e-6, 1.0e-12];
        let factor = inverse_factor(&gram, TOLERANCE).unwrap();
        let product = factor.tr_mul(&factor) * &gram;
        let scale = gram.diagonal().map(f64::sqrt);
        for i in 0..3 {
            for k in 0..3 {
                let expected = f64::from(u8::from(i == k));
                let found = product[(i, k)] * scale[i] / scale[k];
                assert!((found - expected).abs() < 1e-12, "{i} {k} {found}");
            }
        }
    }

    /// What is not known stays out: the step along it is zero, not large.
    #[test]
    fn unknown_directions_are_left_out() {
        let known = dmatrix![1.0, 2.0, 0.0; 0.0, 1.0, 0.0];
        let factor = inverse_factor(&known.tr_mul(&known), TOLERANCE).unwrap();
        assert_eq!(factor.shape(), (2, 3));
        assert!(factor.column(2).norm() < 1e-14);
        assert_eq!(inverse_factor(&DMatrix::zeros(2, 2), TOLERANCE).unwrap().shape(), (0, 2));
        assert_eq!(inverse_factor(&DMatrix::zeros(0, 0), TOLERANCE).unwrap().shape(), (0, 0));
        assert!(inverse_factor(&dmatrix![f64::NAN], TOLERANCE).is_none());
    }
}
