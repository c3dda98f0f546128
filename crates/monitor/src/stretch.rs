//! A stretch of a record, and how long its channels stand still.

use std::ops::Range;

/// A stretch of a record without gaps: one slice for each channel, equally long.
pub type Stretch<'a> = Vec<&'a [f64]>;

/// The runs of equal values of at least two samples.
fn runs(values: &[f64]) -> impl Iterator<Item = Range<usize>> {
    let mut start = 0;
    values.chunk_by(|a, b| a.total_cmp(b).is_eq()).filter_map(move |run| {
        let range = start..start + run.len();
        start = range.end;
        (range.len() > 1).then_some(range)
    })
}

/// The length of the longest run of equal values; 1 where no two neighbours are equal.
pub(crate) fn longest_run(values: &[f64]) -> usize {
    runs(values).map(|run| run.len()).max().unwrap_or(1)
}

/// The first run of more than `longest` samples that reaches beyond sample `from`.
pub(crate) fn first_run_beyond(
    values: &[f64],
    longest: usize,
    from: usize,
) -> Option<Range<usize>> {
    runs(values).find(|run| run.len() > longest && run.end > from)
}
