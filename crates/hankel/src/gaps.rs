//! Where a record is cut: at missing samples.

use pulp::Arch;

use crate::{HankelError, Layout, scan::AllFinite};

/// What a NaN means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Missing {
    /// An error, like an infinite sample. The default: a gap that nobody noticed should not pass silently.
    #[default]
    Refuse,
    /// A missing sample: if any channel has one, the record is cut there into segments, and no row reaches across.
    Gap,
}

/// Checks the channels and gives the stretches between gaps, as from .. to; always one more than there are gaps, some may be empty.
pub(crate) fn pieces(
    layout: &Layout,
    record: &[&[f64]],
    missing: Missing,
) -> Result<Vec<(usize, usize)>, HankelError> {
    let samples = layout.samples(record)?;
    let arch = Arch::new();
    let mut gaps = Vec::new();
    for (channel, samples) in record.iter().enumerate() {
        // Only if there is one are they looked for.
        if arch.dispatch(AllFinite(samples)) {
            continue;
        }
        for (sample, value) in samples.iter().enumerate().filter(|(_, x)| !x.is_finite()) {
            if missing == Missing::Gap && value.is_nan() {
                gaps.push(sample);
            } else {
                return Err(HankelError::NotFinite { channel, sample, value: *value });
            }
        }
    }
    gaps.sort_unstable();
    gaps.dedup();
    let starts = std::iter::once(0).chain(gaps.iter().map(|gap| gap + 1));
    Ok(starts.zip(gaps.iter().copied().chain([samples])).collect())
}
