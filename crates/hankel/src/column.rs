//! A shifted copy of a channel.

/// One column: row k holds sample `k + lag` of a channel.
///
/// # Example
///
/// ```
/// use hankel::Column;
///
/// let ahead = Column::new(0, 2); // x(k + 2) of the first channel
/// assert_eq!(ahead.lag, 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Column {
    /// Index of the channel, from 0.
    pub channel: usize,
    /// Samples ahead of the row; negative is in the past.
    pub lag: isize,
}

impl Column {
    /// Binds a channel and a lag.
    #[must_use]
    pub fn new(channel: usize, lag: isize) -> Self {
        Self { channel, lag }
    }
}

/// A count as a lag. Counts of samples fit: a slice has at most `isize::MAX` bytes.
pub(crate) fn signed(count: usize) -> isize {
    isize::try_from(count).expect("a count of samples fits in isize")
}
