//! Markov parameters in both directions of time.

use nalgebra::DMatrix;

use crate::EraError;
use crate::realize::{check_blocks, scalars};

/// The coefficients of a noncausal finite-impulse-response model `sum_(i=-d)^r h_i q^-i`.
///
/// Checked: there is an `h_0`, all `h_i` have one shape and are finite. `d = 0` and `r = 0` are allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct NoncausalMarkov {
    anticausal: Vec<DMatrix<f64>>,
    causal: Vec<DMatrix<f64>>,
}

impl NoncausalMarkov {
    /// From the two halves, each in the direction of its own time: `anticausal = [h_-1, h_-2, .., h_-d]` and
    /// `causal = [h_0, h_1, .., h_r]`.
    ///
    /// # Errors
    ///
    /// No `h_0`, shapes that differ, values that are not finite.
    pub fn new(anticausal: Vec<DMatrix<f64>>, causal: Vec<DMatrix<f64>>) -> Result<Self, EraError> {
        let shape = causal.first().ok_or(EraError::NoFeedthrough)?.shape();
        check_blocks(shape, (0..).zip(&causal))?;
        check_blocks(shape, (1..).map(|index: isize| -index).zip(&anticausal))?;
        Ok(Self { anticausal, causal })
    }

    /// [`NoncausalMarkov::new`] for one input and one output.
    ///
    /// # Errors
    ///
    /// As [`NoncausalMarkov::new`].
    pub fn siso(anticausal: &[f64], causal: &[f64]) -> Result<Self, EraError> {
        Self::new(scalars(anticausal), scalars(causal))
    }

    /// For one input and one output, from the window `h_-d, .., h_0, .., h_r` in the order of the index.
    ///
    /// # Errors
    ///
    /// As [`NoncausalMarkov::new`]; a window of `d` numbers or fewer has no `h_0`.
    ///
    /// # Example
    ///
    /// ```
    /// use era::NoncausalMarkov;
    ///
    /// // 3 q^2 + 2 q + 5 + 7/q
    /// let h = NoncausalMarkov::from_window(&[3.0, 2.0, 5.0, 7.0], 2)?;
    /// assert_eq!(h.anticausal()[0][(0, 0)], 2.0);
    /// assert_eq!(h.causal()[0][(0, 0)], 5.0);
    /// # Ok::<(), era::EraError>(())
    /// ```
    pub fn from_window(window: &[f64], anticausal_count: usize) -> Result<Self, EraError> {
        let (anticausal, causal) =
            window.split_at_checked(anticausal_count).ok_or(EraError::NoFeedthrough)?;
        let reversed: Vec<f64> = anticausal.iter().rev().copied().collect();
        Self::siso(&reversed, causal)
    }

    /// `h_-1, h_-2, .., h_-d`.
    #[must_use]
    pub fn anticausal(&self) -> &[DMatrix<f64>] {
        &self.anticausal
    }

    /// `h_0, h_1, .., h_r`.
    #[must_use]
    pub fn causal(&self) -> &[DMatrix<f64>] {
        &self.causal
    }
}

#[cfg(test)]
mod tests;
