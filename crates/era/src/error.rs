//! What can go wrong before a realization exists.

/// Why a sequence of Markov parameters could not be realized.
///
/// Numerical doubt is not an error: rank, residual and condition are fields of [`crate::Realization`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EraError {
    /// The sequence is too short for a Hankel matrix and its shift.
    #[error("found {found} Markov parameters after the feedthrough, at least {needed} are needed")]
    TooFewMarkovParameters {
        /// Number of parameters after the feedthrough.
        found: usize,
        /// Number that the smallest (or the requested) Hankel matrix needs.
        needed: usize,
    },
    /// The sequence has no feedthrough term `H_0`.
    #[error("found no Markov parameter, the sequence starts with the feedthrough H_0")]
    NoFeedthrough,
    /// A Markov parameter has no rows or no columns.
    #[error(
        "the Markov parameters are {rows} by {columns}, at least one output and one input are needed"
    )]
    NoChannels {
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
    },
    /// A Markov parameter has another shape than the first.
    #[error(
        "Markov parameter {index} is {rows} by {columns}, the first is {expected_rows} by {expected_columns}"
    )]
    ShapeMismatch {
        /// Its index; negative on the anticausal side.
        index: isize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
        /// Rows of the first parameter.
        expected_rows: usize,
        /// Columns of the first parameter.
        expected_columns: usize,
    },
    /// A Markov parameter holds an infinity or is not a number.
    #[error("Markov parameter {index} holds a value that is not finite")]
    NotFinite {
        /// Its index; negative on the anticausal side.
        index: isize,
    },
    /// The tolerance of the order selection is out of range.
    #[error("the order tolerance is {value}, it must lie in [0, 1)")]
    InvalidTolerance {
        /// The tolerance found.
        value: f64,
    },
    /// The noise floor is negative or not finite.
    #[error("the noise floor is {value}, it must be finite and not negative")]
    InvalidNoiseFloor {
        /// The floor found.
        value: f64,
    },
    /// The Hankel matrix has no block rows or no block columns.
    #[error(
        "the Hankel matrix has {rows} block rows and {columns} block columns, at least one of each is needed"
    )]
    EmptyHankel {
        /// Block rows asked for.
        rows: usize,
        /// Block columns asked for.
        columns: usize,
    },
    /// The singular value decomposition did not converge.
    #[error("the singular values of the {rows} by {columns} Hankel matrix did not converge")]
    NoConvergence {
        /// Rows of the matrix.
        rows: usize,
        /// Columns of the matrix.
        columns: usize,
    },
    /// A transfer function was asked of a system with several channels.
    #[error(
        "the model has {outputs} outputs and {inputs} inputs, a scalar transfer function needs one of each"
    )]
    NotScalar {
        /// Outputs found.
        outputs: usize,
        /// Inputs found.
        inputs: usize,
    },
    /// The realized matrices overflow or cannot form a model.
    #[error("the realized matrices are not a valid model: {reason}")]
    InvalidModel {
        /// What the model's own check said.
        reason: String,
    },
}
