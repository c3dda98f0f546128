//! The characteristic polynomial without division: the Samuelson-Berkowitz algorithm.

use crate::{Poly, PolyError, Ring};

/// The characteristic polynomial det(pI - A) of an n x n matrix over any ring.
///
/// `matrix` holds the entries row by row. The result is monic of degree n; 1 for n = 0.
/// About n^4 / 4 products and no division, so it is exact wherever the ring is
/// (Berkowitz 1984, Information Processing Letters 18).
///
/// # Errors
/// [`PolyError::EntryCount`] unless there are n^2 entries.
///
/// # Example
/// ```
/// use poly::{Poly, characteristic_polynomial};
///
/// let a = [1, 1, 1, 0, 2, -1, 0, 1, 1];
/// assert_eq!(characteristic_polynomial(&a, 3)?, Poly::from_descending(&[1, -4, 6, -3]));
/// # Ok::<(), poly::PolyError>(())
/// ```
pub fn characteristic_polynomial<T: Ring>(matrix: &[T], n: usize) -> Result<Poly<T>, PolyError> {
    if n.checked_mul(n) != Some(matrix.len()) {
        return Err(PolyError::EntryCount { rows: n, columns: n, found: matrix.len() });
    }
    let mut descending = vec![T::one()];
    for k in 0..n {
        // The leading block of size k, bordered by column s, row r and corner a:
        // multiply by the Toeplitz matrix of 1, -a, -r s, -r A s, ..., -r A^(k-1) s.
        let mut toeplitz = vec![T::one(), -matrix[k * n + k].clone()];
        let mut power: Vec<T> = (0..k).map(|i| matrix[i * n + k].clone()).collect();
        for step in 0..k {
            toeplitz.push(-dot(&matrix[k * n..k * n + k], &power));
            if step + 1 < k {
                power = (0..k).map(|i| dot(&matrix[i * n..i * n + k], &power)).collect();
            }
        }
        descending = (0..k + 2)
            .map(|i| {
                (0..=i.min(k))
                    .fold(T::zero(), |sum, j| sum + toeplitz[i - j].clone() * descending[j].clone())
            })
            .collect();
    }
    Ok(Poly::from_descending(&descending))
}

fn dot<T: Ring>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
}
