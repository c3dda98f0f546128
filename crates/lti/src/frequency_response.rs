//! The frequency response, from one Hessenberg reduction and one O(n^2) solve per frequency.

use doubled::DoubleDoubleComplex;
use nalgebra::DMatrix;
use num_complex::Complex;

use crate::dense::CMatrix;
use crate::doubled_product::row_product;
use crate::scaling::balance_similarity;
use crate::{LtiError, StateSpace, TimeDomain};

impl<T: TimeDomain> StateSpace<T> {
    /// G = C (x I - A)^-1 B + D at the given frequencies, each p x m.
    ///
    /// x = j omega in continuous time, x = exp(j omega T) in discrete time; frequencies are in rad/s and may be
    /// negative.
    ///
    /// Method: A is balanced by powers of two and reduced to Hessenberg form once; each frequency is a
    /// Hessenberg solve with partial pivoting and one step of refinement with a double-double residual, so that
    /// the response is accurate next to zeros as well.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotFiniteArgument`]; [`LtiError::PoleAtFrequency`] if a pole lies there exactly. Next to a
    /// pole the response is large, and its digits are those that the distance to the pole leaves.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::dmatrix;
    /// // 1/(s + 1) at 1 rad/s is (1 - j)/2.
    /// let lag = StateSpace::<Continuous>::new(dmatrix![-1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])?;
    /// let g = lag.frequency_response(&[1.0])?[0][0];
    /// assert!((g.re - 0.5).abs() < 1e-15 && (g.im + 0.5).abs() < 1e-15);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn frequency_response(
        &self,
        frequencies_rad_s: &[f64],
    ) -> Result<Vec<DMatrix<Complex<f64>>>, LtiError> {
        let plan = Plan::new(self);
        let mut responses = Vec::with_capacity(frequencies_rad_s.len());
        for &frequency_rad_s in frequencies_rad_s {
            if !frequency_rad_s.is_finite() {
                return Err(LtiError::NotFiniteArgument {
                    quantity: "the frequency",
                    value: frequency_rad_s,
                });
            }
            let point = self.time().on_axis(frequency_rad_s);
            responses
                .push(plan.evaluate(point).ok_or(LtiError::PoleAtFrequency { frequency_rad_s })?);
        }
        Ok(responses)
    }

    /// G = C (x I - A)^-1 B + D at one point x of the s plane (in rad/s) or the z plane.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotFiniteArgument`]; [`LtiError::PoleAtPoint`] if a pole lies there exactly.
    pub fn evaluate(&self, point: Complex<f64>) -> Result<DMatrix<Complex<f64>>, LtiError> {
        for value in [point.re, point.im] {
            if !value.is_finite() {
                return Err(LtiError::NotFiniteArgument { quantity: "the point", value });
            }
        }
        Plan::new(self).evaluate(point).ok_or(LtiError::PoleAtPoint { point })
    }
}

/// The system in balanced coordinates, and the Hessenberg form H = Q^T A Q of its state matrix.
struct Plan {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    d: DMatrix<f64>,
    q: CMatrix,
    hessenberg: DMatrix<f64>,
}

impl Plan {
    fn new<T: TimeDomain>(system: &StateSpace<T>) -> Self {
        let n = system.order();
        let (a, diagonal) = balance_similarity(system.a());
        let mut b = system.b().clone();
        let mut c = system.c().clone();
        for i in 0..n {
            b.row_mut(i).unscale_mut(diagonal[i]);
            c.column_mut(i).scale_mut(diagonal[i]);
        }
        let (q, hessenberg) = if n > 2 {
            a.clone().hessenberg().unpack()
        } else {
            (DMatrix::identity(n, n), a.clone())
        };
        Self { a, b, c, d: system.d().clone(), q: q.map(|x| Complex::new(x, 0.0)), hessenberg }
    }

    /// `None` at a pole.
    fn evaluate(&self, point: Complex<f64>) -> Option<CMatrix> {
        let b = self.b.map(|x| Complex::new(x, 0.0));
        let solution = self.solve(point, &b)?;
        // One step of refinement. Solution and correction are kept apart, so that C x is accurate also where it
        // nearly vanishes, next to a zero.
        let correction = self.solve(point, &self.residual(point, &solution))?;
        let (p, m) = self.d.shape();
        let response = CMatrix::from_fn(p, m, |i, j| {
            let state =
                [&solution, &correction].map(|part| row_product(&self.c, i, part.column(j)));
            (DoubleDoubleComplex::from(self.d[(i, j)]) + state[0] + state[1]).value()
        });
        response.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(response)
    }

    fn solve(&self, point: Complex<f64>, right: &CMatrix) -> Option<CMatrix> {
        let mut matrix = self.hessenberg.map(|x| Complex::new(-x, 0.0));
        for i in 0..matrix.nrows() {
            matrix[(i, i)] += point;
        }
        let mut solution = self.q.adjoint() * right;
        solve_hessenberg(&mut matrix, &mut solution)?;
        Some(&self.q * solution)
    }

    /// B - (x I - A) X, each entry summed in double-double arithmetic and then rounded.
    fn residual(&self, point: Complex<f64>, solution: &CMatrix) -> CMatrix {
        let n = self.a.nrows();
        CMatrix::from_fn(n, solution.ncols(), |i, j| {
            let moved = row_product(&self.a, i, solution.column(j));
            let kept = DoubleDoubleComplex::product(point, solution[(i, j)]);
            (DoubleDoubleComplex::from(self.b[(i, j)]) - kept + moved).value()
        })
    }
}

/// Solves H X = B in place for upper Hessenberg H, with partial pivoting; `None` for an exactly singular H.
fn solve_hessenberg(matrix: &mut CMatrix, right: &mut CMatrix) -> Option<()> {
    let n = matrix.nrows();
    for k in 0..n {
        if k + 1 < n {
            if matrix[(k + 1, k)].l1_norm() > matrix[(k, k)].l1_norm() {
                matrix.swap_rows(k, k + 1);
                right.swap_rows(k, k + 1);
            }
            if matrix[(k + 1, k)].l1_norm() > 0.0 {
                let factor = matrix[(k + 1, k)] / matrix[(k, k)];
                for j in k + 1..n {
                    let above = matrix[(k, j)];
                    matrix[(k + 1, j)] -= factor * above;
                }
                for j in 0..right.ncols() {
                    let above = right[(k, j)];
                    right[(k + 1, j)] -= factor * above;
                }
            }
        }
        if matrix[(k, k)].l1_norm() == 0.0 {
            return None;
        }
    }
    for j in 0..right.ncols() {
        for i in (0..n).rev() {
            let mut sum = right[(i, j)];
            for k in i + 1..n {
                sum -= matrix[(i, k)] * right[(k, j)];
            }
            right[(i, j)] = sum / matrix[(i, i)];
        }
    }
    Some(())
}

#[cfg(test)]
mod tests;
