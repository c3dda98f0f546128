//! What can be wrong with a flight.

/// Why a flight could not be simulated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FlightError {
    /// A corner frequency must be positive and finite.
    #[error("the corner frequency is {corner_rad_s} rad/s, a positive number is needed")]
    Corner {
        /// What was given.
        corner_rad_s: f64,
    },
    /// A system without states, or an input that it does not have.
    #[error(
        "found a system of order {order} with {inputs} input(s); input {input} (from 0) and at least one state are needed"
    )]
    NoSuchInput {
        /// Order of the system.
        order: usize,
        /// Its inputs.
        inputs: usize,
        /// The one asked for.
        input: usize,
    },
    /// The system could not be built or sampled.
    #[error("{reason}")]
    System {
        /// What the system's own check said.
        reason: String,
    },
}

impl FlightError {
    pub(crate) fn system(error: &lti::LtiError) -> Self {
        Self::System { reason: error.to_string() }
    }
}

pub(crate) fn check_corner(corner_rad_s: f64) -> Result<(), FlightError> {
    if corner_rad_s > 0.0 && corner_rad_s.is_finite() {
        Ok(())
    } else {
        Err(FlightError::Corner { corner_rad_s })
    }
}
