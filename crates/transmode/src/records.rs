//! Files -> records.
//!
//! [`load`] is the one way from files to records, whatever their format. A file becomes one record, called like the file without its folder; or
//! one for each window of it, called `file:start:end`. A gap, that is a step over whole periods or samples at which a sensor holds no
//! number, splits a record: its stretches become records of their own, called `record#1`, `record#2` and so on. Stretches of fewer than
//! [`segments::SHORTEST`] samples are left out, and a warning says so.
//!
//! Columns of measured inputs go the same way as the sensors, and are handed out beside the records.
//!
//! Numbers are converted to SI with angles in radians where the file states their unit, and are taken as they are where it does not.

pub(crate) mod binary;
pub(crate) mod blocks;
pub(crate) mod bridging;
pub(crate) mod clock;
mod clock_fit;
mod clock_unit;
mod common_period;
pub(crate) mod copies;
mod decimated;
mod decimation;
pub(crate) mod format;
pub(crate) mod format_error;
mod hdf5;
pub(crate) mod held;
mod known_inputs;
pub(crate) mod loading;
mod mat;
mod notes;
pub(crate) mod npy;
mod npz;
pub(crate) mod open;
pub(crate) mod options;
pub(crate) mod oversampling;
pub(crate) mod pair;
#[cfg(feature = "parquet")]
mod parquet;
mod paths;
pub(crate) mod progress;
pub(crate) mod raw;
mod resampling;
pub(crate) mod runs;
mod same_units;
pub(crate) mod sampling;
pub(crate) mod segments;
pub(crate) mod selection;
mod source;
pub(crate) mod table;
pub(crate) mod text;
pub(crate) mod timing;
pub(crate) mod unit;
pub(crate) mod warning;
pub(crate) mod wrap;
mod zstd;

pub(crate) use common_period::with_period;
pub(crate) use loading::{Loaded, is_same_file, load};
pub(crate) use options::{LoadOptions, Window};
pub(crate) use progress::Progress;
pub(crate) use sampling::{check_same_period, is_near_period};
pub(crate) use segments::SHORTEST;
pub(crate) use selection::Selection;
pub(crate) use source::Source;
pub(crate) use warning::LoadWarning;
