//! What a file is: by what it holds, and by its name where that says nothing.

use std::path::Path;

use super::format_error::FormatError;

/// What every NPY file starts with.
pub(crate) const NPY_MAGIC: &[u8] = b"\x93NUMPY";
const GZIP_MAGIC: &[u8] = b"\x1f\x8b";
/// Of a ZIP archive: a file entry, or the end of an archive without any.
const ZIP_MAGICS: [&[u8]; 2] = [b"PK\x03\x04", b"PK\x05\x06"];
const PARQUET_MAGIC: &[u8] = b"PAR1";
const HDF5_MAGIC: &[u8] = b"\x89HDF\r\n\x1a\n";

/// How many bytes of a file tell its format.
pub(crate) const START: usize = 1024;

/// How a record is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Text,
    GzippedText,
    Npy,
    Npz,
    /// MATLAB, level 5.
    Mat,
    Parquet,
}

impl Format {
    /// Judges the first bytes of a file, at most [`START`].
    pub(crate) fn of(start: &[u8], file: &Path) -> Result<Self, FormatError> {
        let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase());
        let extension = extension.as_deref();
        if start.starts_with(GZIP_MAGIC) {
            return Ok(Self::GzippedText);
        }
        if start.starts_with(NPY_MAGIC) {
            return Ok(Self::Npy);
        }
        if ZIP_MAGICS.iter().any(|magic| start.starts_with(magic)) {
            return Ok(Self::Npz);
        }
        if start.starts_with(PARQUET_MAGIC) {
            return if cfg!(feature = "parquet") {
                Ok(Self::Parquet)
            } else {
                Err(FormatError::NoParquet)
            };
        }
        // MATLAB puts 512 bytes of its own before those of HDF5.
        if start.starts_with(b"MATLAB 7.3")
            || start.get(512..).is_some_and(|start| start.starts_with(HDF5_MAGIC))
        {
            return Err(FormatError::Mat73);
        }
        if start.starts_with(HDF5_MAGIC) {
            return Err(if extension == Some("mat") {
                FormatError::Mat73
            } else {
                FormatError::Hdf5
            });
        }
        if is_mat(start) {
            return Ok(Self::Mat);
        }
        match extension {
            Some("npy") if start.is_empty() => Err(FormatError::Empty),
            Some("npy") => Err(FormatError::NotNpy),
            Some("npz") => Err(FormatError::Misnamed { format: "NPZ" }),
            Some("parquet") => Err(FormatError::Misnamed { format: "Parquet" }),
            // Version 4 starts with its first matrix: type, rows, columns, as integers below 256 or so.
            Some("mat") if start.len() >= 20 && start[..20].contains(&0) => Err(FormatError::Mat4),
            Some("mat") => Err(FormatError::Misnamed { format: "MATLAB" }),
            Some("f64") => Err(FormatError::IsRaw),
            Some("xls" | "xlsx" | "ods") => Err(FormatError::Spreadsheet),
            _ => Ok(Self::Text),
        }
    }

    pub(crate) fn is_text(self) -> bool {
        matches!(self, Self::Text | Self::GzippedText)
    }

    /// A short name for messages and other programs.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Text => "csv",
            Self::GzippedText => "csv.gz",
            Self::Npy => "npy",
            Self::Npz => "npz",
            Self::Mat => "mat",
            Self::Parquet => "parquet",
        }
    }
}

/// Whether a file has the header of MATLAB's level 5: 124 bytes of text, then its version and the order of its bytes.
fn is_mat(start: &[u8]) -> bool {
    start.starts_with(b"MATLAB 5.0 MAT-file")
        || matches!(start.get(124..128), Some([0, 1, b'I', b'M'] | [1, 0, b'M', b'I']))
}

#[cfg(test)]
mod tests;
