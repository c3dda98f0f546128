//! Least squares with a penalty on the Markov parameters.
//!
//! ```text
//! minimise over theta    1/(2 n s_o^2) || Psi - theta Phi ||^2  +  lambda P(g),      g_i = h_i s_i / s_o
//! ```
//!
//! n is the number of equations, s_i and s_o the root mean squares of the pseudo input (over the middle column, y_i(k)) and of the
//! pseudo output (the right-hand side). So the first term is half the squared relative residual, `lambda` has no unit, and one value means
//! the same for short and long records in any units. Only the Markov parameters are penalised: the coefficients of D(q), whose
//! roots should lie near the unit circle, are left free.
//!
//! | penalty | P(g) |
//! |---|---|
//! | [`Regularization::Ridge`] | 1/2 sum g_i^2 |
//! | [`Regularization::Lasso`] | sum abs(g_i) |
//! | [`Regularization::ExponentiallyWeighted`] | 1/2 sum rho^(-abs(i)) g_i^2 |
//! | [`Regularization::NuclearNorm`] | sum of the singular values of the Hankel matrices of g_1 .. g_r and of g_-1 .. g_-d |
//!
//! Squares are a least-squares problem of their own and are solved directly, and so is any penalty with `lambda` = 0. The lasso and the nuclear
//! norm are conic programs, solved by an interior-point method. Only the folded triangle of the equations enters, so the size of the problem does
//! not depend on the number of samples.
//!
//! The solution is not refined in doubled precision as that of the plain fit is: a penalty moves it by far more.
//! This module needs the feature `regularized` and a system OpenBLAS.

mod fit;
mod hold_out;
mod program;
mod solver;

pub use fit::{RegularizedFit, fit};
pub use hold_out::{HoldOutScore, Lambda};
pub use solver::Status;

use crate::FitError;

/// What is penalised. `g_i` are the Markov parameters in units of the two signals' root mean squares; see the module for the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Regularization {
    /// Half the sum of squares of all Markov parameters.
    Ridge,
    /// The sum of magnitudes of all Markov parameters: those that are not needed become zero.
    Lasso,
    /// Squares weighted by `rho^-|i|`: impulse responses that decay like `rho^(|i|/2)` in both directions of time cost the same
    /// at every lag.
    ExponentiallyWeighted {
        /// `rho`, above 0 and at most 1; 1 is the ridge.
        decay: f64,
    },
    /// The sum of singular values of the causal and of the anticausal Hankel matrix: the convex stand-in for their ranks, which are
    /// the orders of the two halves. `h_0` is a direct feedthrough and is not penalised.
    NuclearNorm,
}

/// The largest weight of [`Regularization::ExponentiallyWeighted`], beyond which rounding drowns the other parameters.
const LARGEST_WEIGHT: f64 = 1e12;

impl Regularization {
    fn check(self, reach: usize) -> Result<(), FitError> {
        if let Self::ExponentiallyWeighted { decay } = self {
            let what = "the decay of the exponential weights";
            if !(decay > 0.0 && decay <= 1.0) {
                return Err(FitError::BadValue {
                    what,
                    value: decay,
                    needed: "above 0 and at most 1",
                });
            }
            if weight(decay, reach) > LARGEST_WEIGHT {
                return Err(FitError::BadValue {
                    what,
                    value: decay,
                    needed: "large enough to keep all weights below 1e12",
                });
            }
        }
        Ok(())
    }
}

/// rho^-|i|
fn weight(decay: f64, index: usize) -> f64 {
    decay.powf(-(index as f64))
}

/// When the solver stops.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Iterations of the interior-point method. The default is 200; well-posed programs need 10 to 40.
    pub max_iterations: u32,
    /// Absolute and relative gap between primal and dual objective, and infeasibility, at which a solution counts as solved.
    ///
    /// The default is 1e-8, the solver's own: semidefinite cones of this size seldom reach less in double precision.
    pub tolerance: f64,
    /// The same for an almost solved program, which is accepted when nothing better is reached. The default is 1e-6.
    pub reduced_tolerance: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { max_iterations: 200, tolerance: 1e-8, reduced_tolerance: 1e-6 }
    }
}

impl Settings {
    fn check(&self) -> Result<(), FitError> {
        for (what, value) in [
            ("the solver's tolerance", self.tolerance),
            ("the solver's reduced tolerance", self.reduced_tolerance),
        ] {
            if !(value > 0.0 && value < 1.0) {
                return Err(FitError::BadValue { what, value, needed: "between 0 and 1" });
            }
        }
        if self.max_iterations == 0 {
            return Err(FitError::BadValue {
                what: "the number of iterations",
                value: 0.0,
                needed: "at least 1",
            });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
