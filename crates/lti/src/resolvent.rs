//! The numerators of the resolvent, C adj(pI - A) B + D det(pI - A), without division and so over any ring.

use nalgebra::{DMatrix, Scalar};
use poly::{Poly, Ring};

use crate::LtiError;
use crate::state_space::{check_shape, check_square};

/// The common denominator and all numerators of a transfer-function matrix: G_ij = numerators\[i\]\[j\] / delta.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ResolventNumerators<T: Ring> {
    /// The characteristic polynomial delta(p) = det(pI - A), monic of degree n.
    ///
    /// Source: paper eq. (7).
    pub delta: Poly<T>,
    /// One polynomial per output (first index) and input (second index), of degree at most n:
    /// Gamma(p) = c adj(pI - A) b + d delta(p) for a row c of C, a column b of B and their entry d of D.
    ///
    /// For the two outputs of a transmissibility, Gamma_i is that of (c_i, d_i) and Gamma_o that of (c_o, d_o).
    ///
    /// Source: paper eq. (5) and paper eq. (6).
    pub numerators: Vec<Vec<Poly<T>>>,
}

/// delta and all numerators C adj(pI - A) B + D delta over any commutative ring.
///
/// | symbol | shape |
/// |---|---|
/// | A | n x n |
/// | B | n x m |
/// | C | p x n |
/// | D | p x m |
///
/// With delta = sum of delta_k p^k, adj(pI - A) b = sum of v_k p^k where v_(n-1) = b and
/// v_(k-1) = A v_k + delta_k b. Nothing is divided: integers and rationals stay exact. For `f64` systems use
/// [`StateSpace::resolvent_numerators`](crate::StateSpace::resolvent_numerators), which rounds only once.
///
/// # Errors
///
/// [`LtiError::NotSquare`] or [`LtiError::Shape`].
///
/// # Example
///
/// ```
/// use lti::resolvent_numerators;
/// use nalgebra::dmatrix;
/// use poly::Poly;
/// // The double integrator: 1/p^2 from force to position, p/p^2 to velocity.
/// let result = resolvent_numerators(
///     &dmatrix![0, 1; 0, 0], &dmatrix![0; 1], &dmatrix![1, 0; 0, 1], &dmatrix![0; 0])?;
/// assert_eq!(result.delta, Poly::new(vec![0, 0, 1]));
/// assert_eq!(result.numerators[0][0], Poly::new(vec![1]));
/// assert_eq!(result.numerators[1][0], Poly::new(vec![0, 1]));
/// # Ok::<(), lti::LtiError>(())
/// ```
pub fn resolvent_numerators<T: Ring + Scalar>(
    a: &DMatrix<T>,
    b: &DMatrix<T>,
    c: &DMatrix<T>,
    d: &DMatrix<T>,
) -> Result<ResolventNumerators<T>, LtiError> {
    check_square("A", a)?;
    let (n, m, p) = (a.nrows(), b.ncols(), c.nrows());
    check_shape("B", b, n, m)?;
    check_shape("C", c, p, n)?;
    check_shape("D", d, p, m)?;
    let delta = characteristic_polynomial(a)?;
    let columns: Vec<Vec<Vec<T>>> =
        (0..m).map(|j| adjugate_times(a, &delta, b.column(j).as_slice())).collect();
    let numerator = |i: usize, j: usize| {
        let row: Vec<T> = c.row(i).iter().cloned().collect();
        combined(&columns[j], &row, &d[(i, j)], &delta)
    };
    let numerators = (0..p).map(|i| (0..m).map(|j| numerator(i, j)).collect()).collect();
    Ok(ResolventNumerators { delta, numerators })
}

pub(crate) fn check_vectors<T>(n: usize, b: &[T], c: &[T]) -> Result<(), LtiError> {
    if b.len() != n {
        return Err(LtiError::Shape {
            matrix: "b",
            rows: b.len(),
            columns: 1,
            needed_rows: n,
            needed_columns: 1,
        });
    }
    if c.len() != n {
        return Err(LtiError::Shape {
            matrix: "c",
            rows: 1,
            columns: c.len(),
            needed_rows: 1,
            needed_columns: n,
        });
    }
    Ok(())
}

/// det(pI - A) by the division-free algorithm of Samuelson and Berkowitz.
pub(crate) fn characteristic_polynomial<T: Ring + Scalar>(
    a: &DMatrix<T>,
) -> Result<Poly<T>, LtiError> {
    let n = a.nrows();
    let row_major: Vec<T> = (0..n).flat_map(|i| (0..n).map(move |j| a[(i, j)].clone())).collect();
    poly::characteristic_polynomial(&row_major, n).map_err(|source| LtiError::Polynomial {
        operation: "the characteristic polynomial",
        source,
    })
}

/// c adj(pI - A) b + d delta where delta is known.
pub(crate) fn numerator_given_delta<T: Ring + Scalar>(
    a: &DMatrix<T>,
    delta: &Poly<T>,
    b: &[T],
    c: &[T],
    d: &T,
) -> Poly<T> {
    combined(&adjugate_times(a, delta, b), c, d, delta)
}

/// The coefficients v_0 .. v_(n-1) of adj(pI - A) b.
fn adjugate_times<T: Ring + Scalar>(a: &DMatrix<T>, delta: &Poly<T>, b: &[T]) -> Vec<Vec<T>> {
    let n = a.nrows();
    let mut descending: Vec<Vec<T>> = Vec::with_capacity(n);
    for k in (0..n).rev() {
        let next = match descending.last() {
            None => b.to_vec(),
            Some(previous) => {
                let coefficient = delta.coefficient(k + 1);
                (0..n)
                    .map(|i| {
                        (0..n).fold(coefficient.clone() * b[i].clone(), |sum, j| {
                            sum + a[(i, j)].clone() * previous[j].clone()
                        })
                    })
                    .collect()
            }
        };
        descending.push(next);
    }
    descending.reverse();
    descending
}

fn combined<T: Ring>(adjugate_b: &[Vec<T>], c: &[T], d: &T, delta: &Poly<T>) -> Poly<T> {
    let coefficient = |k: usize| {
        let through = adjugate_b.get(k).map_or_else(T::zero, |v| {
            c.iter().zip(v).fold(T::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
        });
        through + d.clone() * delta.coefficient(k)
    };
    Poly::new((0..=adjugate_b.len()).map(coefficient).collect())
}

#[cfg(test)]
mod tests;
