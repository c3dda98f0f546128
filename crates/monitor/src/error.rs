//! Why nothing can be watched.

/// Why a detector could not be made or used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MonitorError {
    /// No transmissibility, or one between channels that are not there.
    #[error(
        "found a transmissibility from channel {input} to channel {output} and {channels} channel(s); two different channels are needed"
    )]
    NoSuchChannel {
        /// Index of the pseudo input, from 0.
        input: usize,
        /// Index of the pseudo output, from 0.
        output: usize,
        /// Channels that a stretch has.
        channels: usize,
    },
    /// Nothing to watch with.
    #[error("no transmissibility is given; at least one is needed")]
    NoLink,
    /// Too few healthy windows to calibrate with.
    #[error(
        "the healthy data hold {found} windows of {window} samples, and {needed} are needed to calibrate {links} transmissibilities; give a longer reference or a shorter window"
    )]
    TooFewWindows {
        /// Windows found.
        found: usize,
        /// Windows needed.
        needed: usize,
        /// Samples in a window.
        window: usize,
        /// Transmissibilities.
        links: usize,
    },
    /// No stretch of the training data gives a residual.
    #[error("the training data are too short for a residual")]
    NoTraining,
    /// An option out of its range.
    #[error("{what} is {value}; {needed} is needed")]
    BadOption {
        /// The option.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Its range.
        needed: &'static str,
    },
    /// Residuals without noise, or with the same noise in several transmissibilities.
    #[error(
        "the residuals of the healthy data vary too little to calibrate with: sensors without noise, or one that stands still"
    )]
    Degenerate,
    /// A transmissibility that does not fit the data.
    #[error("{reason}")]
    Residual {
        /// What the model said.
        reason: String,
    },
}

impl From<cfi_ident::FitError> for MonitorError {
    fn from(error: cfi_ident::FitError) -> Self {
        Self::Residual { reason: error.to_string() }
    }
}
