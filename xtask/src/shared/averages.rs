//! What many numbers say together.

pub(crate) fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

/// The middle value, or the mean of the two in the middle; not a number where there is none.
pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => sorted[n / 2],
        n => f64::midpoint(sorted[n / 2 - 1], sorted[n / 2]),
    }
}

/// The value that this part of all values does not exceed, none between two; not a number where
/// there is none.
pub(crate) fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = sorted
        .iter()
        .enumerate()
        .find(|(below, _)| (below + 1) as f64 >= part * values.len() as f64);
    place.map_or(f64::NAN, |(_, value)| *value)
}

/// Density in bins of equal width between two ends; what lies beyond counts in the outermost bins.
/// (left end, right end, density)
pub(crate) fn histogram(values: &[f64], ends: (f64, f64), bins: u32) -> Vec<(f64, f64, f64)> {
    let width = (ends.1 - ends.0) / f64::from(bins);
    (0..bins)
        .map(|bin| {
            let left = ends.0 + width * f64::from(bin);
            let right = left + width;
            let inside =
                |value: f64| (value >= left || bin == 0) && (value < right || bin + 1 == bins);
            let number = values.iter().filter(|value| inside(**value)).count();
            (left, right, number as f64 / (values.len().max(1) as f64 * width))
        })
        .collect()
}

#[cfg(test)]
mod tests;
