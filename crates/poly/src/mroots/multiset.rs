//! The multiset of roots, with what is needed to doubt it.

use num_complex::Complex;

/// One distinct root.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Root {
    /// Where it is.
    pub value: Complex<f64>,
    /// How often it counts.
    pub multiplicity: usize,
    /// `|p(z)| / sum |c_k| |z|^k`: the smallest relative change of the coefficients that makes `value` a root.
    pub residual: f64,
    /// Largest relative change of the root per relative change of the coefficients, to first order.
    ///
    /// Simple root: `sum |c_k| |z|^k / (|z| |p'(z)|)`. Multiple root: the same for changes that keep the
    /// multiplicities (Zeng 2005). A root at zero by vanishing coefficients has condition 0.
    pub condition: f64,
    /// Estimated distance to the exact root of the coefficients as given.
    ///
    /// Simple root: the radius `n |p| / |p'|` of a disc that holds a root, and the rounding of `value`.
    /// Multiple root: condition times the backward error of the structure.
    pub error_estimate: f64,
}

/// How the roots were decided on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MrootsMethod {
    /// All nonzero roots are simple, each refined by itself.
    Simple,
    /// Some roots are multiple, all refined together with the multiplicities held (Zeng 2005).
    Pejorative,
}

/// The multiset of roots, with its numerical doubt; made by [`mroots()`](crate::mroots()).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Mroots {
    /// Distinct roots, by ascending real part, then modulus of the imaginary part, positive imaginary part first.
    pub roots: Vec<Root>,
    /// How the roots were decided on.
    pub method: MrootsMethod,
    /// Largest change of a coefficient, relative to the Newton polygon's hull, that makes `roots` exact.
    pub backward_error: f64,
    /// Sweeps over all roots.
    pub iterations: usize,
    /// Whether every root met its stopping test.
    pub converged: bool,
    /// Number of leading coefficients dropped as vanishing.
    pub vanished_leading: usize,
}

impl Mroots {
    /// Every root as often as its multiplicity says, in the order of [`Mroots::roots`].
    pub fn values(&self) -> Vec<Complex<f64>> {
        self.roots
            .iter()
            .flat_map(|root| std::iter::repeat_n(root.value, root.multiplicity))
            .collect()
    }
}
