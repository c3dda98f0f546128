//! What can be wrong with a binary record, in the words of a message.

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
    #[error("an NPZ file is an archive of arrays; save the one array with numpy.save")]
    IsArchive,
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
    #[error("the array is structured; a plain one of floats, samples x channels, is needed")]
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
        "its {length} bytes are no multiple of {row}, one sample of {channels} channel(s) of 8 bytes; check --channels, \
         or copy the file again if it is truncated"
    )]
    RawLength { length: u64, channels: u64, row: u64 },
}

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
