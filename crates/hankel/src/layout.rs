//! Which shifted copies of which channels are the columns.

use crate::{
    HankelError,
    column::{Column, signed},
    plan::Plan,
};

/// The largest span of lags: windows of twice this many samples of each channel are kept in memory.
const LARGEST_SPAN: usize = 1 << 24;

/// The columns of a regressor matrix, or of two of them whose product is wanted.
///
/// Rows run over every k for which all columns lie inside the record: a record of N samples gives `N - span` rows, where the span is the latest
/// lag minus the earliest. Columns may stand in any order, with any lags.
///
/// # Example
///
/// ```
/// use hankel::{Column, Layout};
///
/// // Rows [x(k), x(k+1), u(k-3)].
/// let layout = Layout::new(2, vec![Column::new(0, 0), Column::new(0, 1), Column::new(1, -3)])?;
/// assert_eq!((layout.span(), layout.rows(10)), (4, 6));
/// # Ok::<(), hankel::HankelError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    channels: usize,
    left: Vec<Column>,
    /// `None`: the same as the left ones.
    right: Option<Vec<Column>>,
    earliest: isize,
    span: usize,
    plan: Plan,
}

impl Layout {
    /// The Gram matrix of these columns with themselves.
    ///
    /// # Errors
    ///
    /// [`HankelError::NoColumn`], [`HankelError::UnknownChannel`], [`HankelError::RepeatedColumn`], [`HankelError::SpanTooLarge`].
    pub fn new(channels: usize, columns: Vec<Column>) -> Result<Self, HankelError> {
        Self::build(channels, columns, None)
    }

    /// The products of the left columns, which become rows of the result, with the right ones, on the rows for which both sides lie
    /// inside the record.
    ///
    /// # Errors
    ///
    /// As [`Layout::new`], for each side.
    pub fn cross(
        channels: usize,
        left: Vec<Column>,
        right: Vec<Column>,
    ) -> Result<Self, HankelError> {
        Self::build(channels, left, Some(right))
    }

    /// The block-Hankel matrix of all channels with `block_rows` blocks: H H' with row `i * channels + c` of H holding
    /// `x_c(k + i)`.
    ///
    /// # Errors
    ///
    /// As [`Layout::new`].
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Layout, Options, gram};
    ///
    /// // H = [1 2 3; 2 3 4]
    /// let gram = gram(&Layout::block_hankel(1, 2)?, &[&[1.0, 2.0, 3.0, 4.0]], &Options::default())?;
    /// assert_eq!(gram.matrix()?.as_slice(), [14.0, 20.0, 20.0, 29.0]);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn block_hankel(channels: usize, block_rows: usize) -> Result<Self, HankelError> {
        if block_rows > LARGEST_SPAN {
            return Err(HankelError::SpanTooLarge { span: block_rows, most: LARGEST_SPAN });
        }
        let lags = 0..signed(block_rows);
        let columns = lags.flat_map(|lag| (0..channels).map(move |c| Column::new(c, lag)));
        Self::build(channels, columns.collect(), None)
    }

    fn build(
        channels: usize,
        left: Vec<Column>,
        right: Option<Vec<Column>>,
    ) -> Result<Self, HankelError> {
        check(channels, &left)?;
        right.as_deref().map_or(Ok(()), |columns| check(channels, columns))?;
        let all = || left.iter().chain(right.iter().flatten()).map(|c| c.lag);
        let (earliest, latest) =
            all().fold((isize::MAX, isize::MIN), |(low, high), lag| (low.min(lag), high.max(lag)));
        let span = latest.abs_diff(earliest);
        if span > LARGEST_SPAN {
            return Err(HankelError::SpanTooLarge { span, most: LARGEST_SPAN });
        }
        let plan = Plan::new(channels, &left, right.as_deref(), earliest);
        Ok(Self { channels, left, right, earliest, span, plan })
    }

    /// Number of channels.
    #[must_use]
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// The columns; in a cross layout those on the left.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.left
    }

    /// The columns on the right; the same as the left ones unless this is a cross layout.
    #[must_use]
    pub fn right_columns(&self) -> &[Column] {
        self.right.as_deref().unwrap_or(&self.left)
    }

    /// Whether both sides are the same columns, so that the result is symmetric.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.right.is_none()
    }

    /// Latest lag minus earliest lag; a row takes one sample more than this.
    #[must_use]
    pub fn span(&self) -> usize {
        self.span
    }

    /// The earliest lag.
    pub(crate) fn earliest(&self) -> isize {
        self.earliest
    }

    /// Rows that a record of this many samples gives.
    #[must_use]
    pub fn rows(&self, samples: usize) -> usize {
        samples.saturating_sub(self.span)
    }

    pub(crate) fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Checks that as many channels are given as the layout has, all of one length, and returns that.
    pub(crate) fn samples(&self, record: &[&[f64]]) -> Result<usize, HankelError> {
        if record.len() != self.channels {
            return Err(HankelError::WrongChannelCount {
                found: record.len(),
                needed: self.channels,
            });
        }
        let expected = record.first().map_or(0, |channel| channel.len());
        match record.iter().position(|channel| channel.len() != expected) {
            Some(channel) => Err(HankelError::UnequalLengths {
                channel,
                samples: record[channel].len(),
                expected,
            }),
            None => Ok(expected),
        }
    }
}

fn check(channels: usize, columns: &[Column]) -> Result<(), HankelError> {
    if columns.is_empty() {
        return Err(HankelError::NoColumn);
    }
    if let Some(column) = columns.iter().position(|c| c.channel >= channels) {
        let channel = columns[column].channel;
        return Err(HankelError::UnknownChannel { column, channel, channels });
    }
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by_key(|i| (columns[*i], *i));
    match order.windows(2).find(|pair| columns[pair[0]] == columns[pair[1]]) {
        Some(pair) => Err(HankelError::RepeatedColumn {
            first: pair[0],
            second: pair[1],
            channel: columns[pair[0]].channel,
            lag: columns[pair[0]].lag,
        }),
        None => Ok(()),
    }
}
