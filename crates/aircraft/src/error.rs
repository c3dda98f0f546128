//! What can be wrong with the numbers of an aircraft.

/// Why a model could not be built or its modes could not be named.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AircraftError {
    /// A number is an infinity or not a number.
    #[error("{name} is {value}, a finite number is needed")]
    NotFinite {
        /// The field.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number must be positive and is not.
    #[error("{name} is {value}, a positive number is needed")]
    NotPositive {
        /// The field.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The moments of inertia belong to no body.
    #[error(
        "Ixx Izz = {product} does not exceed Ixz^2 = {square}, so that the inertia matrix is not positive definite"
    )]
    IndefiniteInertia {
        /// `Ixx Izz`.
        product: f64,
        /// `Ixz^2`.
        square: f64,
    },
    /// No control surface was asked for.
    #[error("found no control surface, at least one is needed")]
    NoSurface,
    /// No output was asked for.
    #[error("found no output, at least one is needed")]
    NoOutput,
    /// A system has not the four lateral states.
    #[error(
        "found {found} states, the lateral model has 4: sideslip, roll rate, yaw rate, bank angle"
    )]
    WrongOrder {
        /// States found.
        found: usize,
    },
    /// The state-space model was refused, or its eigenvalues could not be found.
    #[error("the lateral state-space model failed: {reason}")]
    InvalidModel {
        /// What the model's own check said.
        reason: String,
    },
}
