//! One column explained by the others.

use doubled::{DoubleDouble, power_of_two, times_power_of_two};

use crate::{Cholesky, Gram, HankelError, sums::times};

/// The solution of `min over b of || X b - t ||`, X the columns of a layout without one, and that one t.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LeastSquares {
    /// One for each column of X, in the units of the record.
    pub coefficients: Vec<f64>,
    /// `|| X b - t ||`, in the unit of the target. From the Gram matrix alone, it is rounding below about the root of
    /// [`Gram::rounding`] times the norm of t.
    pub residual_norm: f64,
    /// `|| X b - t || / || t ||`; 0 for a zero target.
    pub relative_residual: f64,
    /// The factor of the regressors.
    pub factor: Cholesky,
    /// How far the coefficients may be off because the Gram matrix is rounded, relative to their norm in units in which every column has norm one: its rounding times
    /// the condition number squared. After a refinement it no longer applies.
    pub expected_error: f64,
    /// What passes over the data have brought.
    pub refinement: Refinement,
    /// `|| t ||`, in the unit of the record.
    pub target_norm: f64,
    /// What no b at all explains of the target, in the unit of the record: the same as `residual_norm` before a refinement, unless small singular values
    /// were cut off.
    pub unexplained_norm: f64,
    /// The target in the basis of [`Cholesky::triangle`], in the unit of the record: `|| X b - t ||^2` is
    /// `|| R D^-1 b - projected ||^2` and what no b explains.
    pub projected: Vec<f64>,
    /// The solution in the units of the factor and the target.
    pub(crate) scaled: Vec<f64>,
    /// Rows that were summed.
    pub(crate) rows: usize,
    /// Index of the target among the columns.
    pub(crate) target: usize,
    /// The target's samples are in units of two to this.
    pub(crate) unit: i32,
    /// Norm of the target over that unit.
    scaled_target_norm: f64,
}

/// How a refinement on the data went.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Refinement {
    /// Corrections applied.
    pub steps: usize,
    /// Norm of the last correction over that of the solution, in units in which every column has norm one; 0 without steps.
    pub last_correction: f64,
    /// Whether the last correction was at rounding level; `false` without steps.
    pub converged: bool,
}

impl Gram {
    /// Explains the column `target` by all others, in their order.
    ///
    /// Where the columns are dependent, the solution has the smallest norm in units in which every column has norm one, which does not depend on the
    /// units of the record. `tolerance` is that of [`Gram::cholesky`].
    ///
    /// # Errors
    ///
    /// As [`Gram::cholesky`]; [`HankelError::BadSize`] for a target that does not exist or is the only column, [`HankelError::Overflow`] for a
    /// coefficient beyond a double.
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Column, Layout, Options, gram};
    ///
    /// // x(k+2) = x(k+1) + x(k): Fibonacci
    /// let columns = vec![Column::new(0, 0), Column::new(0, 1), Column::new(0, 2)];
    /// let record = [1.0, 1.0, 2.0, 3.0, 5.0, 8.0, 13.0];
    /// let found = gram(&Layout::new(1, columns)?, &[&record], &Options::default())?.least_squares(2, None)?;
    /// assert_eq!(found.coefficients, [1.0, 1.0]);
    /// assert_eq!(found.factor.rank(), 2);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn least_squares(
        &self,
        target: usize,
        tolerance: Option<f64>,
    ) -> Result<LeastSquares, HankelError> {
        self.square()?;
        let size = self.shape().0;
        if target >= size || size < 2 {
            return Err(HankelError::BadSize {
                what: "the index of the target",
                found: target,
                needed: format!("below {size}, with at least one other column"),
            });
        }
        let regressors: Vec<usize> = (0..size).filter(|i| *i != target).collect();
        let factor = self.select(&regressors)?.cholesky(tolerance)?;
        let right_hand_side: Vec<DoubleDouble> = factor
            .order()
            .iter()
            .map(|i| {
                let step = self.exponent(regressors[*i]) - factor.exponent(*i);
                times(self.at(regressors[*i], target), power_of_two(step))
            })
            .collect();
        let z = factor.forward(&right_hand_side);
        let total = self.at(target, target);
        let explained = &z[..factor.rank()];
        let without =
            |z: &[DoubleDouble]| z.iter().fold(total, |rest, z| rest - *z * *z).value().max(0.0);
        let rest = without(explained);
        let target_norm = total.value().max(0.0).sqrt();
        let unit = self.exponent(target);
        let solution = factor.smallest(&factor.backward(explained));
        let mut found = LeastSquares {
            coefficients: Vec::new(),
            residual_norm: 0.0,
            relative_residual: 0.0,
            expected_error: self.rounding() * factor.condition().powi(2),
            refinement: Refinement::default(),
            projected: z
                .iter()
                .map(|z| times_power_of_two(z.value(), self.exponent(target)))
                .collect(),
            scaled: solution.into_iter().map(DoubleDouble::value).collect(),
            rows: self.rows(),
            target,
            unit,
            target_norm: times_power_of_two(target_norm, unit),
            unexplained_norm: times_power_of_two(without(&z).sqrt(), unit),
            scaled_target_norm: target_norm,
            factor,
        };
        found.describe(rest.sqrt())?;
        Ok(found)
    }
}

impl LeastSquares {
    /// Fills in what is in the units of the record. `residual` is the norm in the unit of the target.
    pub(crate) fn describe(&mut self, residual: f64) -> Result<(), HankelError> {
        let scaled_back = self
            .scaled
            .iter()
            .enumerate()
            .map(|(i, b)| times_power_of_two(*b, self.unit - self.factor.exponent(i)));
        self.coefficients = scaled_back.collect();
        if self.coefficients.iter().any(|b| !b.is_finite()) {
            return Err(HankelError::Overflow { what: "a coefficient" });
        }
        self.residual_norm = times_power_of_two(residual, self.unit);
        self.relative_residual =
            if self.scaled_target_norm > 0.0 { residual / self.scaled_target_norm } else { 0.0 };
        Ok(())
    }

    /// `(X' X)^+ g` for a gradient g, all in the units of the factor.
    pub(crate) fn correction(&self, gradient: &[DoubleDouble]) -> Vec<f64> {
        let factor = &self.factor;
        let in_order: Vec<DoubleDouble> = factor.order().iter().map(|i| gradient[*i]).collect();
        let step = factor.smallest(&factor.backward(&factor.forward(&in_order)[..factor.rank()]));
        step.into_iter().map(DoubleDouble::value).collect()
    }
}
