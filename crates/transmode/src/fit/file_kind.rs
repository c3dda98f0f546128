//! What kind of file a record is, as far as reading it goes: whole, or in blocks.

use std::path::Path;

use crate::records::format_error::FormatError;

/// How the fit reads a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileKind {
    /// A table that is read into memory, whatever its format.
    Table,
    Npy,
    /// Raw doubles of so many channels.
    Raw(u64),
}

impl FileKind {
    /// Judges by the name: `.npy` and `.f64` are streamed, anything else is a table; or by the number of channels, which only raw doubles need.
    pub(super) fn of(file: &Path, channels: Option<u64>) -> Result<Self, FormatError> {
        let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase());
        match (extension.as_deref(), channels) {
            (Some("npy" | "npz" | "csv" | "mat"), Some(_)) => Err(FormatError::NeedlessChannels),
            (Some("npy"), None) => Ok(Self::Npy),
            (_, Some(channels)) => Ok(Self::Raw(channels)),
            (Some("f64"), None) => Err(FormatError::MissingChannels),
            _ => Ok(Self::Table),
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Table => "table",
            Self::Npy => "npy",
            Self::Raw(_) => "raw",
        }
    }
}

#[cfg(test)]
mod tests;
