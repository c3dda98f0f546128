//! What every engine has to find out about a least-squares problem.

use nalgebra::DMatrix;

/// A solution and what is known about it, whichever way it was found.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Solution {
    /// The parameters in the order of (42), in the given units.
    pub(crate) theta: Vec<f64>,
    /// 2-norm of the residual in the unit of the pseudo output.
    pub(crate) residual_norm: f64,
    /// Over that of Psi; 0 if that is zero.
    pub(crate) relative_residual: f64,
    pub(crate) rank: usize,
    pub(crate) condition: f64,
    /// Of the regressors scaled to norm one, descending, one for each parameter.
    pub(crate) singular_values: Vec<f64>,
    /// (Phi Phi')^+ for regressors scaled to norm one.
    pub(crate) inverse: DMatrix<f64>,
    /// Norms of the regressors as factor times two to a power; the factor of a zero regressor is 0.
    pub(crate) norms: Vec<(f64, i32)>,
    /// Directions of parameters, in units in which each regressor has norm one, that change nothing: orthonormal columns.
    pub(crate) null_directions: DMatrix<f64>,
    /// How far theta may be off by rounding, relative to its norm in units in which each regressor has norm one.
    pub(crate) expected_error: f64,
    pub(crate) refinement: Refinement,
}

/// How the refinement of the solution on the data went.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Refinement {
    /// Corrections applied.
    pub steps: usize,
    /// Norm of the last correction over the norm of the parameters, in units in which each regressor has norm one; 0 without steps.
    pub last_correction: f64,
    /// Whether there is nothing left to correct: the last correction was at rounding level, or none was needed.
    pub converged: bool,
}
