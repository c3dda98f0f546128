//! Gaps split a record into stretches, each a record of its own.

use std::ops::Range;

/// A stretch between gaps with fewer samples is dropped: it holds fewer equations than any method asks for, and its unknown initial state
/// costs as much as it tells. A record without gaps is never dropped; the methods say what they need.
pub(crate) const SHORTEST: usize = 50;

/// The stretches of `rows` without a gap, in order, none empty. A gap is in front of each of the samples `after_gaps`, counted from the start of
/// the channels, and at each sample at which any channel is NaN.
pub(crate) fn segments(
    rows: Range<usize>,
    after_gaps: &[usize],
    channels: &[&[f64]],
) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut gaps = after_gaps.iter().copied().peekable();
    let mut start = rows.start;
    for row in rows.clone() {
        while gaps.next_if(|gap| *gap < row).is_some() {}
        if gaps.peek() == Some(&row) {
            found.push(start..row);
            start = row;
        }
        if channels.iter().any(|channel| channel[row].is_nan()) {
            found.push(start..row);
            start = row + 1;
        }
    }
    found.push(start..rows.end);
    found.retain(|segment| !segment.is_empty());
    found
}

#[cfg(test)]
mod tests;
