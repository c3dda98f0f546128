//! Choices of a realization, each with its default.

use crate::{EraError, Order};

/// How to realize a sequence of Markov parameters.
///
/// # Example
///
/// ```
/// use era::{EraOptions, Order};
///
/// let options = EraOptions::with_order(Order::Fixed(6)).noise_floor(1e-9);
/// assert_eq!(options.noise_floor, Some(1e-9));
/// assert_eq!(options.block_rows, None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct EraOptions {
    /// How the order is chosen. Default: the largest gap, which needs no number.
    pub order: Order,
    /// Block rows of the Hankel matrix. Default: as square as it can be, for that allows the largest order.
    pub block_rows: Option<usize>,
    /// Block columns of the Hankel matrix. Default: all parameters are used.
    pub block_columns: Option<usize>,
    /// Absolute uncertainty of one entry of a Markov parameter, in its own unit: what the fit that found them says of
    /// them. Taken as a bound; independent errors of this standard deviation reach about half of the floor that it sets.
    /// Default: none, the numbers are exact up to rounding.
    pub noise_floor: Option<f64>,
}

impl EraOptions {
    /// The defaults with another rule for the order.
    #[must_use]
    pub fn with_order(order: Order) -> Self {
        Self { order, ..Self::default() }
    }

    /// These options with a stated uncertainty of the Markov parameters.
    #[must_use]
    pub fn noise_floor(self, level: f64) -> Self {
        Self { noise_floor: Some(level), ..self }
    }

    /// These options with a given shape of the Hankel matrix. Together with its shift it uses `rows + columns` parameters.
    #[must_use]
    pub fn blocks(self, rows: usize, columns: usize) -> Self {
        Self { block_rows: Some(rows), block_columns: Some(columns), ..self }
    }

    pub(crate) fn check(&self) -> Result<(), EraError> {
        self.order.check()?;
        match self.noise_floor {
            Some(value) if !(value.is_finite() && value >= 0.0) => {
                Err(EraError::InvalidNoiseFloor { value })
            }
            _ => Ok(()),
        }
    }
}
