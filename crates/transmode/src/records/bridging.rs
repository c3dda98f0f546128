//! Short gaps become missing samples inside one record; long ones split it.

use std::ops::Range;

/// Which gaps are bridged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Bridge {
    /// None: each gap splits.
    #[default]
    Never,
    /// Those of up to [`USUAL_SAMPLES`], or [`USUAL_S`] where that is more samples, but not more than [`MOST_SAMPLES`].
    Usual,
    /// Those of up to so many seconds.
    UpTo(f64),
}

/// A recorder that drops a row or two goes on as before.
const USUAL_SAMPLES: usize = 3;

/// A quarter of a second, in which modes of flight hardly move.
const USUAL_S: f64 = 0.25;

/// The most that [`USUAL_S`] may stand for: what is unknown costs time.
const MOST_SAMPLES: f64 = 25.0;

/// No more than one row in so many is taken as missing: with more, the stretches between them are not one record but many.
const ROWS_FOR_ONE: usize = 4;

/// To a likelihood each missing sample is one more unknown, and their effort grows with the third power of their number.
pub(crate) const MOST_MISSING: usize = 400;

impl Bridge {
    /// The longest gap that is bridged, in missing rows.
    pub(crate) fn longest(self, period_s: f64) -> usize {
        /// Seconds are given to so many parts of a sample.
        const ROUNDING: f64 = 1e-6;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "what is too large stays the largest number there is"
        )]
        let rows = |seconds: f64| (seconds / period_s + ROUNDING).floor() as usize;
        match self {
            Self::Never => 0,
            Self::Usual => rows(USUAL_S.min(MOST_SAMPLES * period_s)).max(USUAL_SAMPLES),
            Self::UpTo(seconds) => rows(seconds),
        }
    }
}

/// A stretch of a file, with the samples that are missing in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stretch {
    /// The first and the last one are complete.
    pub(crate) rows: Range<usize>,
    /// Rows that the file does not have: in front of this row so many.
    pub(crate) absent: Vec<(usize, usize)>,
    /// Rows that are not there or not complete.
    pub(crate) missing: usize,
    /// The most of them in a gap.
    pub(crate) longest_gap: usize,
}

impl Stretch {
    /// Samples of each channel, those included that are missing.
    pub(crate) fn samples(&self) -> usize {
        self.rows.len() + self.absent.iter().map(|(_, count)| count).sum::<usize>()
    }

    /// A channel of the file, NaN in the place of what is missing.
    pub(crate) fn of(&self, channel: &[f64]) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.samples());
        let mut absent = self.absent.iter().peekable();
        for row in self.rows.clone() {
            if let Some((_, count)) = absent.next_if(|(at, _)| *at == row) {
                values.resize(values.len() + count, f64::NAN);
            }
            values.push(channel[row]);
        }
        values
    }
}

/// The stretches of `rows` between gaps of more than `longest` missing rows, in order, none empty. The file lacks so many rows in front of each of
/// `gaps`, in ascending order; a row is incomplete where any channel is NaN. Where more than `most_missing` rows of a stretch would be unknown, each gap splits.
pub(crate) fn stretches(
    rows: Range<usize>,
    gaps: &[(usize, usize)],
    channels: &[&[f64]],
    longest: usize,
    most_missing: usize,
) -> Vec<Stretch> {
    let found = bridged(rows.clone(), gaps, channels, longest);
    let is_too_much = |stretch: &Stretch| {
        stretch.missing * ROWS_FOR_ONE > stretch.samples() || stretch.missing > most_missing
    };
    if longest > 0 && found.iter().any(is_too_much) {
        return bridged(rows, gaps, channels, 0);
    }
    found
}

fn bridged(
    rows: Range<usize>,
    gaps: &[(usize, usize)],
    channels: &[&[f64]],
    longest: usize,
) -> Vec<Stretch> {
    let mut found: Vec<Stretch> = Vec::new();
    let mut gaps = gaps.iter().copied().peekable();
    let (mut open, mut waiting) = (0, Vec::new());
    for row in rows.clone() {
        while gaps.next_if(|(at, _)| *at < row).is_some() {}
        if let Some((_, count)) = gaps.next_if(|(at, _)| *at == row && row > rows.start) {
            open += count;
            waiting.push((row, count));
        }
        if channels.iter().any(|channel| channel[row].is_nan()) {
            open += 1;
            continue;
        }
        match found.last_mut() {
            Some(stretch) if open <= longest => {
                stretch.rows.end = row + 1;
                stretch.absent.append(&mut waiting);
                stretch.missing += open;
                stretch.longest_gap = stretch.longest_gap.max(open);
            }
            _ => found.push(Stretch {
                rows: row..row + 1,
                absent: Vec::new(),
                missing: 0,
                longest_gap: 0,
            }),
        }
        waiting.clear();
        open = 0;
    }
    found
}

#[cfg(test)]
mod tests;
