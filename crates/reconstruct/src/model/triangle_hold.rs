//! What sensors read of an input that moves on straight between samples.
//!
//! Let u go straight from sample to sample, and M = log A. Then x(k+1) = A x(k) + T phi_1 b_c u(k) + T phi_2 b_c (u(k+1) - u(k)) with phi_1 = (e^M - I) / M and
//! phi_2 = (e^M - I - M) / M^2 (the triangle hold of Franklin, Powell & Workman, Digital Control of Dynamic Systems, 3rd ed., 1997). The state
//! w = x - T phi_2 b_c u makes that the usual form:
//!
//! ```text
//! w(k+1) = A w(k) + b u(k),  y(k) = C w(k) + d u(k),  b = T phi_1^2 b_c,  d = C T phi_2 b_c = C K(A) b,
//! K(A) = (A - I - log A) (A - I)^-2 = integral of t (I + t (A - I))^-1 over t from 0 to 1.
//! ```
//!
//! So the hold costs no parameter: d follows from A, C and b. The integral needs no logarithm and no case for eigenvalues at 1; by Gauss's rule it
//! is a rational function, whose derivative is that of each of its terms.

use nalgebra::{DMatrix, DVector, RowDVector};

/// Points of Gauss's rule. The error is below 1e-9 for eigenvalues of modes with more than four samples a period, and 1e-6 for one that
/// decays to a tenth in one sample.
const POINTS: usize = 12;

/// K(A) and the terms that its derivative needs.
pub(crate) struct TriangleHold {
    pub(crate) k: DMatrix<f64>,
    /// w_i t_i^2, and (I + t_i (A - I))^-1.
    terms: Vec<(f64, DMatrix<f64>)>,
}

impl TriangleHold {
    /// `None` where an eigenvalue of A is negative and hits a point of the rule.
    pub(crate) fn new(a: &DMatrix<f64>) -> Option<Self> {
        let n = a.nrows();
        let identity = DMatrix::identity(n, n);
        let mut k = DMatrix::zeros(n, n);
        let mut terms = Vec::with_capacity(POINTS);
        for (t, weight) in gauss(POINTS) {
            let inverse = (&identity + (a - &identity) * t).try_inverse()?;
            k += &inverse * (weight * t);
            terms.push((weight * t * t, inverse));
        }
        k.iter().all(|entry| entry.is_finite()).then_some(Self { k, terms })
    }

    /// The derivative of c K(A) b by the entries of A, n x n.
    pub(crate) fn slope(&self, c: &RowDVector<f64>, b: &DVector<f64>) -> DMatrix<f64> {
        let n = self.k.nrows();
        let mut slope = DMatrix::zeros(n, n);
        for (weight, inverse) in &self.terms {
            let (left, right) = (c * inverse, inverse * b);
            slope -= left.transpose() * right.transpose() * *weight;
        }
        slope
    }
}

/// Points and weights of Gauss's rule on the interval from 0 to 1.
fn gauss(points: usize) -> Vec<(f64, f64)> {
    const NEWTON: usize = 8;
    let count =
        DVector::<f64>::from_fn(points + 1, |k, _| f64::from(u32::try_from(k).unwrap_or(0)));
    let order = count[points];
    (0..points)
        .map(|k| {
            let mut x = (std::f64::consts::PI * (count[k] + 0.75) / (order + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..NEWTON {
                // Legendre's polynomials by their recurrence.
                let (mut last, mut value) = (1.0, x);
                for degree in 2..=points {
                    let degree = count[degree];
                    (last, value) = (
                        value,
                        ((2.0 * degree - 1.0) * x * value - (degree - 1.0) * last) / degree,
                    );
                }
                slope = order * (x * value - last) / (x * x - 1.0);
                x -= value / slope;
            }
            (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

#[cfg(test)]
mod tests;
