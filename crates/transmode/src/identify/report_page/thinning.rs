//! Long signals and spectra as few points that look the same.

/// The places of at most two samples for each of `columns` stretches, the smallest and the largest, in their own order: no peak is lost.
pub(super) fn extremes(values: &[f64], columns: usize) -> Vec<usize> {
    let columns = columns.max(1);
    if values.len() <= 2 * columns {
        return (0..values.len()).collect();
    }
    let length = values.len().div_ceil(columns);
    let mut kept = Vec::with_capacity(2 * columns);
    for (stretch, values) in values.chunks(length).enumerate() {
        let by_value = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let low = values.iter().enumerate().min_by(by_value).map_or(0, |(place, _)| place);
        let high = values.iter().enumerate().max_by(by_value).map_or(0, |(place, _)| place);
        let start = stretch * length;
        kept.push(start + low.min(high));
        if low != high {
            kept.push(start + low.max(high));
        }
    }
    kept
}

/// Frequencies that are drawn as one point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bin {
    /// Their mean.
    pub(super) frequency_rad_s: f64,
    /// Their places in the spectrum.
    pub(super) places: std::ops::Range<usize>,
}

impl Bin {
    /// The mean of a spectrum over the bin.
    pub(super) fn mean(&self, spectrum: &[f64]) -> f64 {
        let values = spectrum.get(self.places.clone()).unwrap_or_default();
        values.iter().sum::<f64>() / values.len().max(1) as f64
    }
}

/// Bins of equal width on a logarithmic axis, about `count` of them; each holds a frequency, and zero is in none.
pub(super) fn logarithmic(frequencies_rad_s: &[f64], count: usize) -> Vec<Bin> {
    let first = frequencies_rad_s.iter().position(|frequency| *frequency > 0.0);
    let (Some(first), Some(&last)) = (first, frequencies_rad_s.last()) else { return Vec::new() };
    let ratio = (last / frequencies_rad_s[first]).powf(1.0 / count.max(1) as f64);
    let (mut bins, mut start) = (Vec::new(), first);
    while start < frequencies_rad_s.len() {
        let edge = frequencies_rad_s[start] * ratio.max(1.0 + f64::EPSILON);
        let rest = &frequencies_rad_s[start..];
        let length = rest.iter().take_while(|frequency| **frequency < edge).count().max(1);
        let mean = rest[..length].iter().sum::<f64>() / length as f64;
        bins.push(Bin { frequency_rad_s: mean, places: start..start + length });
        start += length;
    }
    bins
}

#[cfg(test)]
mod tests;
