//! Why there is no fit, in terms of a file.

use cfi_ident::FitError;

/// What is wrong with the record.
#[derive(Debug, thiserror::Error)]
pub(super) enum Explained {
    #[error("there is no sample at which both columns hold a number; choose others")]
    OnlyGaps,
    #[error("{error}; transpose the array if it is not samples x channels")]
    Turned { error: FitError },
    #[error("{0}")]
    Fit(FitError),
}

pub(super) fn explained(error: FitError) -> Explained {
    match error {
        FitError::NoSegment => Explained::OnlyGaps,
        other => Explained::Fit(other),
    }
}

/// The same for a file that holds `samples` of `channels`: where there are more channels, they may have been exchanged.
pub(super) fn explained_in_array(error: FitError, samples: u64, channels: u64) -> Explained {
    match error {
        FitError::TooFewSamples { .. } if channels > samples => Explained::Turned { error },
        other => explained(other),
    }
}
