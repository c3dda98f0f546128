//! Where a record comes from.

use std::path::PathBuf;

use super::clock::Clock;

/// The file of a record, and what of it the record is.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) file: PathBuf,
    /// The time of its first and of its last sample, in seconds of the file's own time.
    pub(crate) span_s: [f64; 2],
    /// Rows that are missing or incomplete, in gaps that were bridged.
    pub(crate) bridged: usize,
    /// The unit of each channel after conversion, where the file states one.
    pub(crate) units: Vec<Option<&'static str>>,
    /// Index of the file, or of the window of one, among all of them: the stretches between the
    /// gaps of one have it in common.
    pub(crate) whole: usize,
    /// Where its sample period comes from.
    pub(crate) clock: Clock,
}
