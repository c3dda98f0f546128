//! A real eigenvalue that is held where it was put, by a penalty, while everything else settles around it.

use nalgebra::{DMatrix, DVector};

use crate::likelihood::cost::evaluation::Evaluation;

/// Where an eigenvalue is held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EigenvaluePenalty {
    /// z.
    pub(crate) eigenvalue: f64,
    /// What a squared distance from there adds to the cost.
    pub(crate) weight: f64,
}

impl EigenvaluePenalty {
    /// Adds the penalty to cost, gradient and Gram matrix. Where the closest eigenvalue is not real the cost becomes infinite.
    pub(crate) fn penalise(&self, evaluation: &mut Evaluation) {
        let Some((z, slope)) = self.closest(&evaluation.system.a) else {
            evaluation.cost = f64::INFINITY;
            return;
        };
        let off = z - self.eigenvalue;
        evaluation.cost += self.weight * off * off;
        // A is first among the entries, by columns.
        let mut slope = DVector::from_column_slice(slope.as_slice());
        if let Some(tangent) = &evaluation.tangent {
            slope = tangent.rows(0, slope.len()).tr_mul(&slope);
        }
        for i in 0..slope.len() {
            evaluation.descent[i] -= self.weight * off * slope[i];
            for k in 0..slope.len() {
                evaluation.gram[(i, k)] += self.weight * slope[i] * slope[k];
            }
        }
    }

    /// The eigenvalue closest to the place, and its derivative by A: w v' with w' v = 1.
    fn closest(&self, a: &DMatrix<f64>) -> Option<(f64, DMatrix<f64>)> {
        let n = a.nrows();
        let off = |z: &num_complex::Complex<f64>| (z.re - self.eigenvalue).hypot(z.im);
        let values = a.complex_eigenvalues();
        let z = values.iter().min_by(|x, y| off(x).total_cmp(&off(y)))?;
        if z.im != 0.0 {
            return None;
        }
        // One step of inverse iteration from a shift that is off by rounding errors.
        let shift = z.re + f64::EPSILON * a.norm().max(1.0);
        let factor = (a - DMatrix::identity(n, n) * shift).lu();
        let transposed = (a.transpose() - DMatrix::identity(n, n) * shift).lu();
        let mut v = DVector::from_fn(n, |i, _| 1.0 + 0.1 * i as f64);
        let mut w = v.clone();
        for _ in 0..3 {
            v = factor.solve(&v)?.normalize();
            w = transposed.solve(&w)?.normalize();
        }
        let product = w.dot(&v);
        let slope = w * v.transpose() / product;
        slope.iter().all(|entry| entry.is_finite()).then_some((z.re, slope))
    }
}

#[cfg(test)]
mod tests;
