//! When the conic solver stops.

use crate::FitError;

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
    pub(super) fn check(&self) -> Result<(), FitError> {
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
