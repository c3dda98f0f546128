//! Hotelling's T^2 of a new observation against a sample of healthy ones.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use crate::MonitorError;

/// Mean and covariance of healthy observations.
#[derive(Debug, Clone)]
pub(crate) struct Healthy {
    observations: usize,
    mean: DVector<f64>,
    /// Standard deviation of each component.
    deviation: DVector<f64>,
    factor: Cholesky<f64, Dyn>,
}

impl Healthy {
    pub(crate) fn of(sample: &[DVector<f64>]) -> Result<Self, MonitorError> {
        let observations = sample.len();
        let p = sample.first().map_or(0, |x| x.len());
        let mut mean = DVector::zeros(p);
        for x in sample {
            mean += x / observations as f64;
        }
        let mut covariance = DMatrix::zeros(p, p);
        for x in sample {
            let off = x - &mean;
            covariance += &off * off.transpose() / (observations as f64 - 1.0);
        }
        let deviation = covariance.diagonal().map(f64::sqrt);
        if deviation.iter().any(|deviation| deviation.is_nan() || *deviation <= 0.0) {
            return Err(MonitorError::Degenerate);
        }
        let factor = covariance.cholesky().ok_or(MonitorError::Degenerate)?;
        Ok(Self { observations, mean, deviation, factor })
    }

    pub(crate) fn observations(&self) -> usize {
        self.observations
    }

    pub(crate) fn mean(&self) -> &DVector<f64> {
        &self.mean
    }

    /// T^2 of a new observation: n/(n + 1) (x - mean)' S^-1 (x - mean).
    pub(crate) fn distance(&self, x: &DVector<f64>) -> f64 {
        let off = x - &self.mean;
        off.dot(&self.factor.solve(&off)) / self.widening()
    }

    /// Each component off its mean, in standard deviations of that difference.
    pub(crate) fn scaled(&self, x: &DVector<f64>) -> DVector<f64> {
        (x - &self.mean).component_div(&self.deviation) / self.widening().sqrt()
    }

    /// A vector in standard deviations of the components.
    pub(crate) fn in_deviations(&self, x: &DVector<f64>) -> DVector<f64> {
        x.component_div(&self.deviation)
    }

    /// Variance of a new observation off the mean of the others, over its own.
    fn widening(&self) -> f64 {
        1.0 + 1.0 / self.observations as f64
    }

    /// What T^2 of a healthy observation exceeds with this probability.
    pub(crate) fn limit(&self, probability: f64) -> f64 {
        limit(self.mean.len(), self.observations, probability)
    }

    /// The same for one component alone, squared.
    pub(crate) fn limit_of_one(&self, probability: f64) -> f64 {
        limit(1, self.observations, probability)
    }
}

/// `p (n - 1) / (n - p)` times the quantile of F(p, n - p).
pub(crate) fn limit(p: usize, n: usize, probability: f64) -> f64 {
    let free = n.saturating_sub(p).max(1) as f64;
    let factor = p as f64 * (n as f64 - 1.0) / free;
    let Ok(distribution) = FisherSnedecor::new(p.max(1) as f64, free) else {
        return f64::INFINITY;
    };
    // The upper tail by bisection of its logarithm: the library's quantile loses the tail in 1 - probability.
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    while distribution.sf(high) > probability && high < 1e30 {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        if distribution.sf(middle) > probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    factor * high
}

/// Chance of at least `least` successes in `trials`, each with this probability.
pub(crate) fn at_least(least: usize, trials: usize, probability: f64) -> f64 {
    let mut chance = (1.0 - probability).powf(trials as f64);
    let mut below = 0.0;
    for successes in 0..least {
        below += chance;
        let ratio = (trials - successes.min(trials)) as f64 / (successes + 1) as f64;
        chance *= ratio * probability / (1.0 - probability);
    }
    (1.0 - below).max(0.0)
}

#[cfg(test)]
mod tests;
