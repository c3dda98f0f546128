//! What a window of whitened residuals says: its mean and its variance, for each transmissibility.

use nalgebra::DVector;

use crate::missing::{Filled, Missing, Moments, fill};
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
    /// Degrees of freedom of the variance.
    pub(crate) freedom: DVector<f64>,
}

/// All whole windows of a stretch, in order of time; without those of which missing samples leave too little.
pub(crate) fn features(
    links: &[Link],
    whitenings: &[Whitening],
    stretch: &Stretch<'_>,
    window: usize,
) -> Result<Vec<Features>, MonitorError> {
    let filled: Vec<Filled> = stretch.iter().map(|channel| fill(channel)).collect();
    let whole: Stretch<'_> = filled.iter().map(|channel| channel.values.as_slice()).collect();
    let mut signals = Vec::new();
    for (link, whitening) in links.iter().zip(whitenings) {
        let Some(residual) = link.residual(&whole)? else { return Ok(Vec::new()) };
        let lacking = |channel: usize| filled.get(channel).map_or(&[][..], |of| &of.missing);
        let missing = Missing::of(link, whitening, [link.input, link.output].map(lacking))?;
        let first = residual.first + whitening.order();
        signals.push((first, whitening.apply(&residual.values), missing));
    }
    let first = signals.iter().map(|(first, ..)| *first).max().unwrap_or(0);
    let end = signals.iter().map(|(first, values, _)| first + values.len()).min().unwrap_or(0);
    let windows = end.saturating_sub(first) / window;
    let of = |start: usize| {
        let moments = signals.iter().map(|(from, values, missing)| {
            let values = values.get(start - from..start - from + window).unwrap_or_default();
            missing.moments(values, start)
        });
        let moments: Vec<Moments> = moments.collect::<Option<_>>()?;
        let each = |number: fn(&Moments) -> f64| {
            DVector::from_iterator(moments.len(), moments.iter().map(number))
        };
        Some(Features {
            first: start,
            level: each(|of| of.level),
            spread: each(|of| of.variance.cbrt()),
            freedom: each(|of| of.freedom),
        })
    };
    Ok((0..windows).filter_map(|index| of(first + index * window)).collect())
}

impl Features {
    /// The spread as a whole window would have it, where healthy ones have this one on average.
    ///
    /// The cube root of a variance with f degrees of freedom is nearly normal, with the mean (1 - 2/(9 f)) and the variance 2/(9 f) in units of its true value (Wilson and Hilferty).
    pub(crate) fn spread_as_whole(&self, healthy: &DVector<f64>, window: usize) -> DVector<f64> {
        let whole = window as f64 - 1.0;
        let mean = |freedom: f64| 1.0 - 2.0 / (9.0 * freedom);
        DVector::from_fn(self.spread.len(), |link, _| {
            let (freedom, usual) = (self.freedom[link], healthy[link]);
            let off = self.spread[link] - usual * mean(freedom) / mean(whole);
            usual + off * (freedom / whole).sqrt()
        })
    }
}
