//! What can be wrong with a layout, a record or a merge.

/// Why no Gram matrix could be made, or no system solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HankelError {
    /// A layout without columns.
    #[error("the layout has no columns: name at least one channel and lag")]
    NoColumn,
    /// A column of a channel that the layout does not have.
    #[error(
        "column {column} names channel {channel}, but there are {channels} channels, counted from 0"
    )]
    UnknownChannel {
        /// Index of the column.
        column: usize,
        /// The channel that it names.
        channel: usize,
        /// How many there are.
        channels: usize,
    },
    /// The same channel and lag twice.
    #[error("columns {first} and {second} are both channel {channel} at lag {lag}: leave one out")]
    RepeatedColumn {
        /// Index of the one.
        first: usize,
        /// Index of the other.
        second: usize,
        /// Their channel.
        channel: usize,
        /// Their lag.
        lag: isize,
    },
    /// A lag so large that a window of it cannot be stored.
    #[error("the lags span {span} samples; at most {most} are possible")]
    SpanTooLarge {
        /// Latest lag minus earliest lag.
        span: usize,
        /// The largest span.
        most: usize,
    },
    /// Another number of channels than the layout has.
    #[error("{found} channels were given, and the layout has {needed}")]
    WrongChannelCount {
        /// Given.
        found: usize,
        /// Expected.
        needed: usize,
    },
    /// Channels of one record with different numbers of samples.
    #[error(
        "channel {channel} has {samples} samples, and channel 0 has {expected}: cut them to the same length"
    )]
    UnequalLengths {
        /// The channel that differs.
        channel: usize,
        /// Its samples.
        samples: usize,
        /// Those of the first channel.
        expected: usize,
    },
    /// An infinite sample, or a NaN that was not declared to mean a gap.
    #[error(
        "sample {sample} of channel {channel} is {value}: remove it, or mark it as missing with NaN and `Missing::Gap`"
    )]
    NotFinite {
        /// The channel.
        channel: usize,
        /// Index of the sample among those handed over in this call, from 0.
        sample: usize,
        /// What stands there.
        value: f64,
    },
    /// No segment is long enough for a single row.
    #[error(
        "no row: the longest of {segments} segments has {longest} samples, and one row takes {needed}"
    )]
    TooShort {
        /// Segments that were given.
        segments: usize,
        /// Samples of the longest.
        longest: usize,
        /// Samples that one row takes, the span of the lags plus one.
        needed: usize,
    },
    /// Partial results of different layouts.
    #[error(
        "the two partial results have different layouts: both must have the same channels and columns"
    )]
    DifferentLayouts,
    /// A value that is too large for a double.
    #[error("{what} is too large for a double: scale the channels, or use the scaled form")]
    Overflow {
        /// What it is.
        what: &'static str,
    },
    /// An operation on a rectangular (cross) Gram matrix that needs a square one.
    #[error(
        "the Gram matrix is {rows} x {columns}: this needs one with the same columns on both sides"
    )]
    NotSquare {
        /// Left columns.
        rows: usize,
        /// Right columns.
        columns: usize,
    },
    /// A matrix decomposition did not converge.
    #[error("the singular values of a {rows} x {columns} triangle did not converge")]
    Decomposition {
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
    },
    /// An index or a length that does not fit the matrix.
    #[error("{what} is {found}, and has to be {needed}")]
    BadSize {
        /// What it is.
        what: &'static str,
        /// Given.
        found: usize,
        /// Expected.
        needed: String,
    },
    /// An option out of range.
    #[error("{what} is {value}, and has to be {needed}")]
    BadValue {
        /// Which option.
        what: &'static str,
        /// Given.
        value: f64,
        /// Expected.
        needed: &'static str,
    },
}
