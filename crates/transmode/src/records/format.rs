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
    /// MATLAB, version 7.3, which is HDF5.
    Mat73,
    Hdf5,
    Parquet,
    ZstdText,
}

/// Formats that are told by their first bytes and not read: what they are, and what to do.
const FOREIGN: [(&[u8], &str, &str); 14] = [
    (
        b"ULog\x01\x12\x35",
        "this is a PX4 flight log (ULog)",
        "convert it with ulog2csv of the Python package pyulog, which writes a CSV file for each topic",
    ),
    (
        b"TDSm",
        "this is a National Instruments file (TDMS)",
        "export it as CSV or LVM in LabVIEW or DIAdem, or in Python with the package npTDMS: TdmsFile.read(file).as_dataframe().to_csv(..)",
    ),
    (
        b"MDF     ",
        "this is a measurement data file (MDF)",
        "export it as CSV or MAT, with the Python package asammdf say",
    ),
    (
        b"UnFinMF ",
        "this is a measurement data file (MDF) that was not finished",
        "repair and export it as CSV, with the Python package asammdf say",
    ),
    (
        b"\xa3\x95\x80\x80",
        "this is an ArduPilot log (DataFlash)",
        "convert it with mavlogdump.py --format csv of the Python package pymavlink",
    ),
    (b"#ROSBAG", "this is a ROS bag", "export its topics as CSV, with rostopic echo -p say"),
    (
        b"\x89MCAP0\r\n",
        "this is an MCAP file",
        "export its topics as CSV, with the Python package mcap say",
    ),
    (
        b"SQLite format 3\0",
        "this is an SQLite database",
        "export the table as CSV, with sqlite3 -csv say",
    ),
    (
        b"CDF\x01",
        "this is a classic NetCDF file",
        "save it as NetCDF-4, which is HDF5, with nccopy -k 4",
    ),
    (
        b"CDF\x02",
        "this is a classic NetCDF file",
        "save it as NetCDF-4, which is HDF5, with nccopy -k 4",
    ),
    (b"ARROW1", "this is an Arrow file", "save it as CSV"),
    (b"\xfd7zXZ\0", "this is a file compressed with xz", "unpack it with xz -d"),
    (b"BZh", "this is a file compressed with bzip2", "unpack it with bunzip2"),
    (b"\x04\x22\x4d\x18", "this is a file compressed with lz4", "unpack it with lz4 -d"),
];

const ZSTD_MAGIC: &[u8] = b"\x28\xb5\x2f\xfd";

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
            return Ok(Self::Mat73);
        }
        if start.starts_with(HDF5_MAGIC) {
            return Ok(if extension == Some("mat") { Self::Mat73 } else { Self::Hdf5 });
        }
        if start.starts_with(ZSTD_MAGIC) {
            return Ok(Self::ZstdText);
        }
        if let Some((_, what, remedy)) = FOREIGN.iter().find(|(magic, ..)| start.starts_with(magic))
        {
            return Err(FormatError::Foreign { what, remedy });
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
        matches!(self, Self::Text | Self::GzippedText | Self::ZstdText)
    }

    /// A short name for messages and other programs.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Text => "csv",
            Self::GzippedText => "csv.gz",
            Self::Npy => "npy",
            Self::Npz => "npz",
            Self::ZstdText => "csv.zst",
            Self::Mat => "mat",
            Self::Mat73 => "mat v7.3",
            Self::Hdf5 => "hdf5",
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
