//! What a window of whitened residuals says: its mean and its variance, for each transmissibility.

use nalgebra::DVector;

use crate::{Link, MonitorError, Stretch, Whitening};

/// One window's numbers.
#[derive(Debug, Clone)]
pub(crate) struct Features {
    /// Index in the stretch of the first sample.
    pub(crate) first: usize,
    /// Mean of the whitened residual of each transmissibility.
    pub(crate) level: DVector<f64>,
    /// Cube root of the variance about that mean.
    pub(crate) spread: DVector<f64>,
}

/// All whole windows of a stretch, in order of time.
pub(crate) fn features(
    links: &[Link],
    whitenings: &[Whitening],
    stretch: &Stretch<'_>,
    window: usize,
) -> Result<Vec<Features>, MonitorError> {
    let mut signals = Vec::new();
    for (link, whitening) in links.iter().zip(whitenings) {
        let Some(residual) = link.residual(stretch)? else { return Ok(Vec::new()) };
        signals.push((residual.first + whitening.order(), whitening.apply(&residual.values)));
    }
    let first = signals.iter().map(|(first, _)| *first).max().unwrap_or(0);
    let end = signals.iter().map(|(first, values)| first + values.len()).min().unwrap_or(0);
    let windows = end.saturating_sub(first) / window;
    let of = |start: usize| {
        let moments = signals.iter().map(|(from, values)| {
            moments(values.get(start - from..start - from + window).unwrap_or_default())
        });
        let (level, spread): (Vec<f64>, Vec<f64>) = moments.unzip();
        Features { first: start, level: level.into(), spread: spread.into() }
    };
    Ok((0..windows).map(|index| of(first + index * window)).collect())
}

/// Mean, and cube root of the variance.
fn moments(values: &[f64]) -> (f64, f64) {
    let n = values.len().max(2) as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (n - 1.0);
    (mean, variance.cbrt())
}
