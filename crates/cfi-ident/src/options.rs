//! How to fit: the engine, and when it counts a singular value as zero.

use crate::FitError;

/// How the equations are reduced to a problem of the size of the parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Engine {
    /// Sums of lag products in doubled precision, refined on the data where that brings anything: O(N (l + r + d)) operations, and the exact
    /// solution to the last bits.
    #[default]
    Gram,
    /// Householder reflections in doubles: O(N (l + r + d)^2) operations, off by the condition number times the rounding unit. It shares nothing with
    /// the other engine and is there to be compared with.
    Qr,
}

/// How to fit.
///
/// # Example
///
/// ```
/// use cfi_ident::FitOptions;
///
/// let plain = FitOptions { refinement_steps: 0, ..FitOptions::default() };
/// assert_eq!(plain.rank_tolerance, None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FitOptions {
    /// Which way the solution is found. The default is [`Engine::Gram`].
    pub engine: Engine,
    /// Singular values at or below this fraction of the largest count as zero. The regressors are first scaled to norm one.
    ///
    /// `None` (the default) takes what the engine can tell from zero: about 1e-14 for the sums, whatever the length of the record; max(equations,
    /// parameters) times the rounding unit 2^-52 for reflections.
    pub rank_tolerance: Option<f64>,
    /// The largest number of refinement steps on the data; 0 keeps what the Gram matrix gives. Reflections are not refined.
    ///
    /// The default is 4. A step costs about as much as the sums. One brings nearly everything, a second confirms it, and a record with noise
    /// rarely needs any.
    pub refinement_steps: usize,
    /// Threads that sum, at least 1 (the default). The result is the same to the last bit whatever their number.
    pub threads: usize,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { engine: Engine::Gram, rank_tolerance: None, refinement_steps: 4, threads: 1 }
    }
}

impl FitOptions {
    pub(crate) fn check(&self) -> Result<(), FitError> {
        if let Some(value) = self.rank_tolerance
            && !(0.0..1.0).contains(&value)
        {
            let what = "the rank tolerance";
            return Err(FitError::BadValue { what, value, needed: "at least 0 and less than 1" });
        }
        if self.threads == 0 {
            let what = "the number of threads";
            return Err(FitError::BadValue { what, value: 0.0, needed: "at least 1" });
        }
        Ok(())
    }
}
