//! What can be wrong with a binary record, in the words of a message.

use crate::numbers::counted;

/// Why a binary record cannot be read: what was found, what is needed, what to do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum FormatError {
    #[error("the file holds no samples")]
    Empty,
    #[error("this is no regular file; a binary record is read in place: save it to disk first")]
    NotRegular,
    #[error(
        "this does not start as an NPY file does; save it with numpy.save, or call it .f64 if it is raw doubles"
    )]
    NotNpy,
    #[error("this is an NPY file; call it .npy and leave out --channels")]
    IsNpy,
    #[error(
        "this is no {format} file, though it is called one; save it again, or call it by what it is"
    )]
    Misnamed { format: &'static str },
    #[error("byte {at} is zero, so this is no text, and no other format that is read: CSV, .mat, .h5, .npy, .npz{parquet}", parquet = PARQUET)]
    Binary { at: usize },
    #[error("this is a MATLAB file of version 4; save it with save('file.mat', '-v7')")]
    Mat4,
    #[error(
        "this is a Parquet file, and this program was built without Parquet; export it as CSV, or build with --features parquet"
    )]
    NoParquet,
    #[error("this is a spreadsheet; export the sheet as CSV")]
    Spreadsheet,
    #[error("this is a ZIP archive without arrays (.npy); save the record with numpy.savez")]
    NoArrays,
    #[error("the archive is damaged or truncated ({what}); copy or save it again")]
    Archive { what: String },
    #[error(
        "raw doubles say neither names nor times; save the record as NPY, or use it with transmode fit --channels"
    )]
    IsRaw,
    #[error("the MATLAB file is damaged or truncated at byte {at}: {what}; copy or save it again")]
    DamagedMat { at: u64, what: &'static str },
    #[error(
        "the file holds no numeric vector or matrix (it holds {found}); save the channels as variables, or as fields of a structure"
    )]
    NoNumbers { found: String },
    #[error("it has no variable {variable:?}; it has {available}")]
    NoVariable { variable: String, available: String },
    #[error("{what}; {remedy}")]
    Foreign { what: &'static str, remedy: &'static str },
    #[error(
        "the HDF5 file cannot be read ({what}); copy it again, or export its channels as CSV or NPZ"
    )]
    Hdf5 { what: String },
    #[error("raw doubles do not say how many channels there are; give --channels")]
    MissingChannels,
    #[error("--channels is for raw doubles only; leave it out, or call the file .f64")]
    NeedlessChannels,
    #[error("--time is for CSV files only; leave it out: the samples must be evenly spaced")]
    NeedlessTime,
    #[error(
        "this is NPY version {major}.{minor}; 1.0, 2.0 and 3.0 can be read: save it with numpy.save"
    )]
    Version { major: u8, minor: u8 },
    #[error("the file ends within its NPY header; copy or save it again")]
    HeaderEnds,
    #[error(
        "the NPY header is {found} bytes long; at most {limit} are read: save it again with numpy.save"
    )]
    LongHeader { found: u64, limit: u64 },
    #[error("the NPY header is damaged: {what}; save it again with numpy.save")]
    BadHeader { what: &'static str },
    #[error(
        "the numbers are of type {descr:?}; floats of 4 or 8 bytes (\"<f4\", \"<f8\", \">f4\", \">f8\") are needed: \
         save array.astype(\"float64\")"
    )]
    Numbers { descr: String },
    #[error(
        "the array is structured; a plain one of floats, samples x channels, is needed here: identify and inspect read its fields"
    )]
    Structured,
    #[error(
        "the array has the shape {}; two dimensions, samples x channels, are needed: {}",
        shape(found),
        remedy(found)
    )]
    Dimensions { found: Vec<u64> },
    #[error(
        "the array has {channels} channels, and at most {limit} are read; it must be samples x channels: transpose it \
         if it is the other way round"
    )]
    TooManyChannels { channels: u64, limit: u64 },
    #[error(
        "{samples} samples of {channels} channels take {needed} bytes, but the file has {found} for them: \
         {}", if u128::from(*found) < *needed { "it is truncated; copy or save it again" } else { "something else follows; save the array alone" }
    )]
    Length { samples: u64, channels: u64, needed: u128, found: u64 },
    #[error(
        "its {length} bytes are no multiple of {row}, one sample of {} of 8 bytes; check --channels, \
         or copy the file again if it is truncated",
        counted(*channels, "channel")
    )]
    RawLength { length: u64, channels: u64, row: u64 },
}

impl FormatError {
    /// Of a variable that is not among these.
    pub(super) fn no_variable(variable: &str, all: &[&str]) -> Self {
        const LISTED: usize = 30;
        let mut available = all.iter().take(LISTED).copied().collect::<Vec<_>>().join(", ");
        if all.len() > LISTED {
            available += &format!(" and {} more", all.len() - LISTED);
        }
        Self::NoVariable { variable: variable.to_owned(), available }
    }
}

/// One more format, where the program was built with it.
const PARQUET: &str = if cfg!(feature = "parquet") { ", .parquet" } else { "" };

/// As Python writes it.
fn shape(found: &[u64]) -> String {
    match found {
        [one] => format!("({one},)"),
        _ => {
            let sizes: Vec<_> = found.iter().map(u64::to_string).collect();
            format!("({})", sizes.join(", "))
        }
    }
}

fn remedy(found: &[u64]) -> &'static str {
    if found.len() < 2 {
        "put the sensors side by side, as numpy.stack((a, b), axis=1) does"
    } else {
        "save one record an array"
    }
}
