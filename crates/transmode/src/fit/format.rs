//! What kind of file a record is.

use std::path::Path;

use crate::records::format_error::FormatError;

/// How a record is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Csv,
    Npy,
    /// Raw doubles of so many channels.
    Raw(u64),
}

impl Format {
    /// Judges by the name: `.npy`, `.f64`, anything else is CSV; or by the number of channels, which only raw doubles need.
    pub(super) fn of(file: &Path, channels: Option<u64>) -> Result<Self, FormatError> {
        let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase());
        match (extension.as_deref(), channels) {
            (Some("npz"), _) => Err(FormatError::IsArchive),
            (Some("npy" | "csv"), Some(_)) => Err(FormatError::NeedlessChannels),
            (Some("npy"), None) => Ok(Self::Npy),
            (_, Some(channels)) => Ok(Self::Raw(channels)),
            (Some("f64"), None) => Err(FormatError::MissingChannels),
            _ => Ok(Self::Csv),
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Npy => "npy",
            Self::Raw(_) => "raw",
        }
    }
}

#[cfg(test)]
mod tests;
