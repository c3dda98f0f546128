//! How [`mroots()`](super::mroots()) is to decide on multiplicities.

/// Whether roots may be merged into multiple ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Multiplicities {
    /// Merge roots where a polynomial with multiple roots explains the coefficients within their error.
    #[default]
    Detect,
    /// Every root is simple, except zero: return the roots of the coefficients exactly as given.
    AllSimple,
}

/// Options of [`mroots()`](crate::mroots()).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MrootsOptions {
    /// Whether roots may be merged; by default they may.
    pub multiplicities: Multiplicities,
    /// Relative error of the coefficients, against the Newton polygon's hull, up to which a polynomial with
    /// multiple roots counts as the one that was meant. Default: 4 times the machine epsilon, a few roundings.
    /// Raise it for measured coefficients.
    pub coefficient_error: f64,
    /// Leading coefficients of modulus at most this many times the largest are dropped. Default: 0, none.
    pub vanishing_leading: f64,
    /// Sweeps over all roots. Default: 500; about 20 are usual, slow convergence needs a multiple root.
    pub maximum_iterations: usize,
}

impl Default for MrootsOptions {
    fn default() -> Self {
        Self {
            multiplicities: Multiplicities::Detect,
            coefficient_error: 4.0 * f64::EPSILON,
            vanishing_leading: 0.0,
            maximum_iterations: 500,
        }
    }
}
