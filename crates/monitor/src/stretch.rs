//! A stretch of a record, and how long its channels stand still.

use std::ops::Range;

/// A stretch of a record: one slice for each channel, equally long. A NaN is a sample that is missing.
pub type Stretch<'a> = Vec<&'a [f64]>;

/// The runs of equal values of at least two samples; a missing one ends a run.
fn runs(values: &[f64]) -> impl Iterator<Item = Range<usize>> {
    let mut start = 0;
    values.chunk_by(|a, b| a.total_cmp(b).is_eq() && !a.is_nan()).filter_map(move |run| {
        let range = start..start + run.len();
        start = range.end;
        (range.len() > 1).then_some(range)
    })
}

/// The stretches between missing samples of any channel, in order, none empty.
///
/// # Example
///
/// ```
/// let (beta, p) = ([1.0, 2.0, f64::NAN, 4.0], [5.0, 6.0, 7.0, 8.0]);
/// let found = monitor::complete(&vec![&beta, &p]);
/// assert_eq!(found, [vec![&[1.0, 2.0][..], &[5.0, 6.0]], vec![&[4.0][..], &[8.0]]]);
/// ```
#[must_use]
pub fn complete<'a>(stretch: &Stretch<'a>) -> Vec<Stretch<'a>> {
    let samples = stretch.iter().map(|channel| channel.len()).min().unwrap_or(0);
    let is_complete = |k: &usize| stretch.iter().all(|channel| !channel[*k].is_nan());
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(first) = (start..samples).find(is_complete) {
        let end = (first..samples).find(|k| !is_complete(k)).unwrap_or(samples);
        found.push(stretch.iter().map(|channel| &channel[first..end]).collect());
        start = end;
    }
    found
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
