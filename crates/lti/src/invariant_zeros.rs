//! Invariant zeros: where the Rosenbrock matrix loses rank.

use doubled::DoubleDoubleComplex;
use num_complex::Complex;

use crate::dense::{CMatrix, CVector, generalized_eigenpairs, singular_triple};
use crate::doubled_product::row_product;
use crate::eigen::compare;
use crate::rosenbrock::{Reduced, Rosenbrock};
use crate::{LtiError, StateSpace, TimeDomain};

/// Options of [`StateSpace::invariant_zeros_with`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct ZerosOptions {
    /// Singular values below this times the Frobenius norm of the scaled system matrix count as zero.
    ///
    /// Default: `None`, which stands for (n + max(m, p)) times the machine epsilon: right for a system whose entries
    /// are known to rounding. A system identified from noisy data needs the relative size of its errors here.
    pub rank_tolerance: Option<f64>,
}

/// One invariant zero and how far it can be trusted.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct InvariantZero {
    /// The zero: in rad/s in continuous time, in the z plane in discrete time.
    pub value: Complex<f64>,
    /// The singular value of the scaled Rosenbrock matrix that vanishes there, relative to the largest.
    pub residual: f64,
    /// First-order change of the zero, relative to the scale of A, per relative change of the scaled system matrix.
    /// Infinite for a defective zero.
    pub condition: f64,
}

/// The invariant zeros of a system.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct InvariantZeros {
    /// The zeros with multiplicity, sorted by real part, then by modulus of the imaginary part, positive imaginary
    /// part first. Conjugate pairs are exactly conjugate.
    pub zeros: Vec<InvariantZero>,
    /// The rank of the transfer-function matrix at almost every point.
    pub normal_rank: usize,
    /// The smallest singular value that counted as nonzero in a rank decision, relative to the norm of the scaled
    /// system matrix; infinite if there was none.
    pub smallest_kept: f64,
    /// The largest one that counted as zero; 0 if there was none. Where it isn't far below `smallest_kept`, the
    /// number of zeros is in doubt.
    pub largest_dropped: f64,
}

impl InvariantZeros {
    /// The values of the zeros.
    #[must_use]
    pub fn values(&self) -> Vec<Complex<f64>> {
        self.zeros.iter().map(|zero| zero.value).collect()
    }
}

impl<T: TimeDomain> StateSpace<T> {
    /// The invariant zeros: the finite points x at which the Rosenbrock matrix
    /// `[A - x I, B; C, D]` has less than its normal rank.
    ///
    /// For a square system whose G has full rank they are the roots of det(xI - A) det G(x): the transmission zeros,
    /// and the modes that no input reaches or no output shows. Systems may be rectangular or degenerate.
    ///
    /// Method: scaling by powers of two, orthogonal reduction to a system with invertible feedthrough
    /// (Emami-Naeini & Van Dooren 1982), generalised eigenvalues; the zeros of a square system are then refined
    /// on the unreduced matrix.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotConverged`] if a decomposition fails.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::dmatrix;
    /// // (s + 3) / ((s + 1)(s + 2))
    /// let system = StateSpace::<Continuous>::new(
    ///     dmatrix![0.0, 1.0; -2.0, -3.0], dmatrix![0.0; 1.0], dmatrix![3.0, 1.0], dmatrix![0.0])?;
    /// let zeros = system.invariant_zeros()?;
    /// assert_eq!(zeros.normal_rank, 1);
    /// assert_eq!(zeros.zeros.len(), 1);
    /// assert!((zeros.zeros[0].value.re + 3.0).abs() < 1e-14);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn invariant_zeros(&self) -> Result<InvariantZeros, LtiError> {
        self.invariant_zeros_with(&ZerosOptions::default())
    }

    /// [`invariant_zeros`](Self::invariant_zeros) with a stated rank tolerance.
    ///
    /// # Errors
    ///
    /// As there, and [`LtiError::NotFiniteArgument`] for a tolerance that isn't finite.
    pub fn invariant_zeros_with(&self, options: &ZerosOptions) -> Result<InvariantZeros, LtiError> {
        if let Some(value) = options.rank_tolerance.filter(|x| !x.is_finite()) {
            return Err(LtiError::NotFiniteArgument { quantity: "the rank tolerance", value });
        }
        let system = Rosenbrock::scaled(self);
        let Reduced { pencil_a, pencil_b, normal_rank, smallest_kept, largest_dropped } =
            system.reduce(options.rank_tolerance)?;
        let vanishing = system.states() + normal_rank;
        let mut zeros = Vec::new();
        for pair in generalized_eigenpairs(&pencil_a, &pencil_b)? {
            if !pair.value.re.is_finite() || !pair.value.im.is_finite() {
                // An exactly singular B: one more zero at infinity.
                continue;
            }
            let overlap =
                pair.left.dotc(&(pencil_b.map(|x| Complex::new(x, 0.0)) * &pair.right)).norm();
            let size = pair.left.norm() * pair.right.norm() * system.norm;
            let condition = if overlap > 0.0 { size / overlap } else { f64::INFINITY };
            let value = system.refined(pair.value, vanishing, condition)?;
            let residual = system.residual(value, vanishing)?;
            let zero = InvariantZero { value: value * system.time_scale, residual, condition };
            zeros.push(zero);
            if value.im != 0.0 {
                zeros.push(InvariantZero { value: zero.value.conj(), ..zero });
            }
        }
        zeros.sort_by(|x, y| compare(&x.value, &y.value));
        Ok(InvariantZeros { zeros, normal_rank, smallest_kept, largest_dropped })
    }
}

impl Rosenbrock {
    /// [A - x I, B; C, D] in scaled coordinates.
    fn at(&self, x: Complex<f64>) -> CMatrix {
        let mut matrix = self.matrix.map(|entry| Complex::new(entry, 0.0));
        for i in 0..self.states() {
            matrix[(i, i)] -= x;
        }
        matrix
    }

    /// The singular value with the given number (counted from 1), relative to the largest.
    fn residual(&self, x: Complex<f64>, vanishing: usize) -> Result<f64, LtiError> {
        if vanishing == 0 {
            return Ok(0.0);
        }
        let (values, _, _) = singular_triple(&self.at(x), vanishing - 1)?;
        Ok(values[vanishing - 1] / values[0])
    }

    /// x + u^H P(x) v / (u^H E v), with u and v the singular vectors that belong to the vanishing singular value,
    /// P(x) v in double-double arithmetic and E the unit matrix on the states. Square systems only: elsewhere the
    /// zero moves under generic perturbations in ways the reduction has already decided on.
    fn refined(
        &self,
        x: Complex<f64>,
        vanishing: usize,
        condition: f64,
    ) -> Result<Complex<f64>, LtiError> {
        const STEPS: usize = 2;
        // Beyond this condition the vectors are too wrong for the step to gain anything.
        const WORST_CONDITION: f64 = 1e6;
        let (rows, columns) = self.matrix.shape();
        if rows != columns || vanishing != rows || condition > WORST_CONDITION {
            return Ok(x);
        }
        let explained = 100.0 * rows as f64 * f64::EPSILON * condition * (1.0 + x.norm());
        let mut value = x;
        for _ in 0..STEPS {
            let (_, u, v) = singular_triple(&self.at(value), vanishing - 1)?;
            let n = self.states();
            let overlap = u.rows(0, n).dotc(&v.rows(0, n));
            let mut step = u.dotc(&self.product(value, &v)) / overlap;
            if value.im == 0.0 {
                step.im = 0.0;
            }
            let candidate = value + step;
            let kept_kind = (value.im == 0.0) == (candidate.im == 0.0) && candidate.im >= 0.0;
            let small = (candidate - x).norm() <= explained;
            if !(kept_kind && small) {
                break;
            }
            value = candidate;
        }
        Ok(value)
    }

    /// P(x) v, each component summed in double-double arithmetic and then rounded.
    fn product(&self, x: Complex<f64>, v: &CVector) -> CVector {
        CVector::from_fn(self.matrix.nrows(), |i, _| {
            let mut sum = row_product(&self.matrix, i, v);
            if i < self.states() {
                sum -= DoubleDoubleComplex::product(x, v[i]);
            }
            sum.value()
        })
    }
}

#[cfg(test)]
mod tests;
