//! A transmissibility between two channels, and its residual.

use cfi_ident::CfiModel;

use crate::{MonitorError, Stretch};

/// A transmissibility between two channels.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// The model.
    pub model: CfiModel,
    /// Index of the pseudo input among the channels, from 0.
    pub input: usize,
    /// Index of the pseudo output.
    pub output: usize,
}

/// A residual and where it begins.
#[derive(Debug, Clone)]
pub(crate) struct Residual {
    /// Index in the stretch of the first value.
    pub(crate) first: usize,
    pub(crate) values: Vec<f64>,
}

impl Link {
    /// Whether this channel takes part.
    #[must_use]
    pub fn contains(&self, channel: usize) -> bool {
        self.input == channel || self.output == channel
    }

    /// How many samples after a residual's own the pseudo input is needed.
    pub(crate) fn look_ahead(&self) -> usize {
        let orders = self.model.structure().orders;
        orders.anticausal().saturating_sub(orders.iir())
    }

    /// Measured minus predicted pseudo output; nothing where the stretch is too short for one.
    pub(crate) fn residual(&self, stretch: &Stretch<'_>) -> Result<Option<Residual>, MonitorError> {
        let (Some(input), Some(output)) = (stretch.get(self.input), stretch.get(self.output))
        else {
            return Err(self.missing(stretch.len()));
        };
        let orders = self.model.structure().orders;
        if orders.equations(input.len()) == 0 {
            return Ok(None);
        }
        let found = self.model.residuals(input, output)?;
        Ok(Some(Residual { first: found.first, values: found.values }))
    }

    pub(crate) fn missing(&self, channels: usize) -> MonitorError {
        MonitorError::NoSuchChannel { input: self.input, output: self.output, channels }
    }
}
