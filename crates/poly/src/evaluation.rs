//! A value and how far rounding may have moved it.

/// A computed value with a bound on its rounding error.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Evaluation<T> {
    /// The computed value.
    pub value: T,
    /// The exact value lies within this distance, barring underflow.
    pub error_bound: f64,
}
