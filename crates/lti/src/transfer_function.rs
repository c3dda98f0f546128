//! Transfer functions of `f64` systems: numerators and denominator correct to the last digits.

use doubled::DoubleDouble;
use nalgebra::DMatrix;
use poly::{Poly, Rational};

use crate::magnitude::Magnitude;
use crate::resolvent::{ResolventNumerators, resolvent_numerators};
use crate::scaling::{Balanced, balance};
use crate::{LtiError, StateSpace, TimeDomain};

/// 2^-96: double-double products and sums have relative errors of a few 2^-104, and some hundreds of them add up.
const DOUBLED_ROUNDING: f64 = 1.0 / (1_u128 << 96) as f64;

/// Numerators with the level below which a coefficient can't be told from zero.
pub(crate) struct WithRounding {
    pub(crate) exact: ResolventNumerators<f64>,
    /// As `exact.numerators`: rounding level of each coefficient, ascending.
    pub(crate) levels: Vec<Vec<Vec<f64>>>,
}

impl<T: TimeDomain> StateSpace<T> {
    /// The numerators C adj(pI - A) B + D delta and the denominator delta = det(pI - A) of all transfer functions.
    ///
    /// Computed in double-double arithmetic on the balanced system and rounded once, so each coefficient is
    /// accurate to about one unit in the last place of what the entries of A, B, C, D give exactly.
    /// Leading coefficients of a numerator that are below n u times the sum of the absolute values of their terms
    /// are set to zero: the rounding of the entries alone explains them, and as leading coefficients they would
    /// make zeros near infinity.
    ///
    /// The paper's p = d/dt is the variable in continuous time, its q in discrete time.
    ///
    /// # Errors
    ///
    /// [`LtiError::Overflow`] if a coefficient is outside the range of `f64`.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::dmatrix;
    /// // 3/(p + 2)
    /// let lag = StateSpace::<Continuous>::new(dmatrix![-2.0], dmatrix![1.0], dmatrix![3.0], dmatrix![0.0])?;
    /// let result = lag.resolvent_numerators()?;
    /// assert_eq!(result.delta.coefficients(), [2.0, 1.0]);
    /// assert_eq!(result.numerators[0][0].coefficients(), [3.0]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn resolvent_numerators(&self) -> Result<ResolventNumerators<f64>, LtiError> {
        Ok(self.numerators_with_rounding()?.exact)
    }

    /// The transfer function from one input to one output: numerator / det(xI - A), common factors kept.
    ///
    /// # Errors
    ///
    /// [`LtiError::NoSuchChannel`] or [`LtiError::Overflow`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::dmatrix;
    /// let lag = StateSpace::<Continuous>::new(dmatrix![-2.0], dmatrix![1.0], dmatrix![3.0], dmatrix![1.0])?;
    /// let g = lag.transfer_function(0, 0)?; // 1 + 3/(s + 2) = (s + 5)/(s + 2)
    /// assert_eq!(g.numerator().coefficients(), [5.0, 1.0]);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn transfer_function(
        &self,
        output: usize,
        input: usize,
    ) -> Result<Rational<f64>, LtiError> {
        let part = self.subsystem(&[output], &[input])?;
        let ResolventNumerators { delta, numerators } = part.resolvent_numerators()?;
        Rational::new(numerators[0][0].clone(), delta)
            .map_err(|source| LtiError::Polynomial { operation: "the transfer function", source })
    }

    pub(crate) fn numerators_with_rounding(&self) -> Result<WithRounding, LtiError> {
        let n = self.order();
        // A = scale D Ab D^-1; p = scale p_b; Gamma(p) = scale^(n-1) c D adj(p_b I - Ab) D^-1 b + d scale^n delta_b.
        let Balanced { matrix, diagonal, scale } = balance(self.a());
        let mut b = self.b().clone();
        let mut c = self.c().clone();
        for i in 0..n {
            b.row_mut(i).unscale_mut(diagonal[i]);
            c.column_mut(i).scale_mut(diagonal[i]);
        }
        let doubled = |m: &DMatrix<f64>| m.map(DoubleDouble::from);
        let sizes = |m: &DMatrix<f64>| m.map(|x| Magnitude(x.abs()));
        // b = scale b_b: then everything is homogeneous, Gamma_k = scale^(n-k) Gamma_b,k.
        let b = b / scale;
        let exact = resolvent_numerators(
            &doubled(&matrix),
            &doubled(&b),
            &doubled(&c),
            &doubled(self.d()),
        )?;
        let bound =
            resolvent_numerators(&sizes(&matrix), &sizes(&b), &sizes(&c), &sizes(self.d()))?;

        let unit = (n.max(1) as f64) * f64::EPSILON / 2.0;
        let mut delta = exact.delta.coefficients().to_vec();
        for (k, coefficient) in delta.iter_mut().enumerate() {
            if coefficient.value().abs() <= DOUBLED_ROUNDING * bound.delta.coefficient(k).0 {
                *coefficient = DoubleDouble::ZERO;
            }
        }
        let delta = unscaled(&delta, n, scale)?;
        let mut numerators = Vec::with_capacity(self.outputs());
        let mut levels = Vec::with_capacity(self.outputs());
        for i in 0..self.outputs() {
            let mut row = Vec::with_capacity(self.inputs());
            let mut row_levels = Vec::with_capacity(self.inputs());
            for j in 0..self.inputs() {
                let terms = |k: usize| bound.numerators[i][j].coefficient(k).0;
                let relative = |k: usize| unit * terms(k);
                let mut coefficients = exact.numerators[i][j].coefficients().to_vec();
                for (k, coefficient) in coefficients.iter_mut().enumerate() {
                    // What is left at the level of double-double rounding cancelled exactly.
                    if coefficient.value().abs() <= DOUBLED_ROUNDING * terms(k) {
                        *coefficient = DoubleDouble::ZERO;
                    }
                }
                while coefficients
                    .last()
                    .is_some_and(|x| x.value().abs() <= relative(coefficients.len() - 1))
                {
                    coefficients.pop();
                }
                row.push(Poly::new(unscaled(&coefficients, n, scale)?));
                let level =
                    |k: usize| relative(k) * scale.powi(i32::try_from(n - k).unwrap_or(i32::MAX));
                row_levels.push((0..=n).map(level).collect());
            }
            numerators.push(row);
            levels.push(row_levels);
        }
        Ok(WithRounding {
            exact: ResolventNumerators { delta: Poly::new(delta), numerators },
            levels,
        })
    }
}

/// The coefficients times scale^(n-k), in steps that under- or overflow only if the result does.
fn unscaled(coefficients: &[DoubleDouble], n: usize, scale: f64) -> Result<Vec<f64>, LtiError> {
    let mut result = Vec::with_capacity(coefficients.len());
    for (k, coefficient) in coefficients.iter().enumerate() {
        let mut value = coefficient.value();
        for _ in k..n {
            value *= scale;
        }
        let vanished = value == 0.0 && coefficient.value() != 0.0;
        if !value.is_finite() || vanished {
            return Err(LtiError::Overflow { operation: "a coefficient of the transfer function" });
        }
        result.push(value);
    }
    Ok(result)
}

#[cfg(test)]
mod tests;
