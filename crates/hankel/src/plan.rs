//! Which lag products the entries of a Gram matrix are made of.
//!
//! The entry of columns x(k + a) and y(k + b) is a sum of x(m) y(m + b - a) over a window of m. Entries of one *lag* b - a of one pair of
//! channels share all of their sum but the ends of the window, so that each such sum is taken once: O(N p c) work for p
//! columns of c channels instead of O(N p^2).

use crate::{
    column::{Column, signed},
    kernel::BLOCK,
};

/// The lag products of one pair of channels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Pair {
    /// The channel x, taken at m.
    pub(crate) x: usize,
    /// The channel y, taken at m + lag.
    pub(crate) y: usize,
    /// First lag of each block of [`BLOCK`] neighbouring lags.
    pub(crate) blocks: Vec<isize>,
    /// Position of the first block's first lag among the sums of the plan.
    pub(crate) offset: usize,
}

/// One entry of the matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Entry {
    /// Row and column in the result.
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// Which of the plan's pairs.
    pub(crate) pair: usize,
    /// Which of the plan's sums.
    pub(crate) sum: usize,
    /// The lag between the two columns.
    pub(crate) lag: isize,
    /// Where the window of m starts in a segment; it has as many members as the segment has rows.
    pub(crate) start: usize,
}

/// All lag products and how the entries use them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Plan {
    pub(crate) pairs: Vec<Pair>,
    /// Sorted by sum and start. In a symmetric layout the upper triangle only.
    pub(crate) entries: Vec<Entry>,
    /// Number of sums, padded lags included.
    pub(crate) sums: usize,
    /// The lags at which each channel is y, first and last.
    reach: Vec<(isize, isize)>,
    owners: Ownership,
}

/// The channels that sums belong to.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Ownership {
    pairs: Vec<(usize, usize)>,
    sums: Vec<(usize, usize)>,
    entries: Vec<(usize, usize)>,
    channels: Vec<usize>,
    /// Columns of the left side, followed by those of the right side if it has its own.
    columns: Vec<usize>,
}

/// Which channels a product or plain sum belongs to.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Owners<'a> {
    /// Channels of each product.
    pub(crate) products: &'a [(usize, usize)],
    /// Channel of each plain sum.
    pub(crate) plain: &'a [usize],
    /// Channels of each variance.
    pub(crate) pairs: &'a [(usize, usize)],
}

impl Plan {
    pub(crate) fn new(
        channels: usize,
        left: &[Column],
        right: Option<&[Column]>,
        earliest: isize,
    ) -> Self {
        let others = right.unwrap_or(left);
        let mut wanted = Vec::with_capacity(left.len() * others.len());
        for (row, a) in left.iter().enumerate() {
            let from = if right.is_none() { row } else { 0 };
            for (column, b) in others.iter().enumerate().skip(from) {
                let (a, b) = if a <= b { (a, b) } else { (b, a) };
                let start = a.lag.abs_diff(earliest);
                wanted.push((a.channel, b.channel, b.lag - a.lag, start, row, column));
            }
        }
        wanted.sort_unstable();
        let mut pairs: Vec<Pair> = Vec::new();
        let mut entries: Vec<Entry> = Vec::with_capacity(wanted.len());
        let mut sums = 0;
        for (x, y, lag, start, row, column) in wanted {
            if pairs.last().is_none_or(|pair| (pair.x, pair.y) != (x, y)) {
                pairs.push(Pair { x, y, blocks: Vec::new(), offset: sums });
            }
            let pair = pairs.len() - 1;
            let blocks = &mut pairs[pair].blocks;
            if blocks.last().is_none_or(|first| lag - first >= signed(BLOCK)) {
                blocks.push(lag);
                sums += BLOCK;
            }
            let first = blocks.last().copied().unwrap_or(lag);
            let sum = sums - BLOCK + lag.abs_diff(first);
            entries.push(Entry { row, column, pair, sum, lag, start });
        }
        let channels_of = |pair: &Pair| (pair.x, pair.y);
        let owners = Ownership {
            pairs: pairs.iter().map(channels_of).collect(),
            sums: pairs
                .iter()
                .flat_map(|pair| std::iter::repeat_n(channels_of(pair), pair.blocks.len() * BLOCK))
                .collect(),
            entries: entries.iter().map(|entry| channels_of(&pairs[entry.pair])).collect(),
            channels: (0..channels).collect(),
            columns: left.iter().chain(right.into_iter().flatten()).map(|c| c.channel).collect(),
        };
        let mut reach: Vec<Option<(isize, isize)>> = vec![None; channels];
        for Entry { pair, lag, .. } in &entries {
            let range = reach[pairs[*pair].y].get_or_insert((*lag, *lag));
            *range = (range.0.min(*lag), range.1.max(*lag));
        }
        let reach = reach.into_iter().map(Option::unwrap_or_default).collect();
        Self { pairs, entries, sums, reach, owners }
    }

    /// The lags at which a channel is y, first and last.
    pub(crate) fn reach(&self, channel: usize) -> (isize, isize) {
        self.reach[channel]
    }

    /// Whose the sums of lag products and of channels are.
    pub(crate) fn sum_owners(&self) -> Owners<'_> {
        let Ownership { pairs, sums, channels, .. } = &self.owners;
        Owners { products: sums, plain: channels, pairs }
    }

    /// Whose the entries and the sums of columns are.
    pub(crate) fn entry_owners(&self) -> Owners<'_> {
        let Ownership { pairs, entries, columns, .. } = &self.owners;
        Owners { products: entries, plain: columns, pairs }
    }
}

#[cfg(test)]
mod tests;
