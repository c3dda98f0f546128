//! Does the model explain the records? The size of the residuals, and whether they are white.

use nalgebra::{DMatrix, DVector};

use super::chi_squared::chi_squared_survival;
use crate::likelihood::cost::spectrum::RecordSpectrum;

/// The size of the residuals: chi-squared distributed where the model holds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ChiSquared {
    /// The sum of squared residuals over their variances.
    pub value: f64,
    /// Real residuals less the parameters that were fitted to them.
    pub degrees_of_freedom: f64,
    /// The probability of a larger value, if the model holds. `None` where the noise levels were estimated from the same residuals:
    /// then the value is what it is by construction.
    pub p_value: Option<f64>,
}

impl ChiSquared {
    pub(crate) fn new(value: f64, degrees_of_freedom: f64, levels_estimated: bool) -> Self {
        let p_value = (!levels_estimated).then(|| chi_squared_survival(value, degrees_of_freedom));
        Self { value, degrees_of_freedom, p_value }
    }

    /// The probability of a value per degree of freedom as far from 1, on this side, where it scatters with this variance.
    pub(crate) fn probability_with_variance(&self, variance: f64) -> f64 {
        let off = self.per_degree_of_freedom() - 1.0;
        0.5 * chi_squared_survival(off * off / variance, 1.0)
    }

    /// About 1 where the model holds.
    #[must_use]
    pub fn per_degree_of_freedom(&self) -> f64 {
        self.value / self.degrees_of_freedom
    }
}

/// Whether the residuals of one record are white: the autocorrelations of lags 1 to h, as the transform of the residuals' spectrum, held
/// against zero (the statistic of Box & Pierce 1970, in the frequency domain, so that it serves any band).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Whiteness {
    /// The record's name.
    pub record: String,
    /// Autocorrelations of lags 1, 2, ..; each is 0 within about 1 / sqrt((m - 1) N).
    pub autocorrelations: Vec<f64>,
    /// Their squares over their variances, summed.
    pub statistic: f64,
    /// How many independent autocorrelations the frequencies allow.
    pub degrees_of_freedom: usize,
    /// The probability of a larger statistic, if the residuals are white. It holds whether or not the noise levels were estimated.
    pub p_value: f64,
}

impl Whiteness {
    /// The probability where the autocorrelations scatter with `factor` times the variance that the record alone gives them.
    pub(crate) fn p_value_with_variance(&self, factor: f64) -> f64 {
        chi_squared_survival(self.statistic / factor, self.degrees_of_freedom as f64)
    }
}

/// Lags that are tested.
const LAGS: usize = 20;

/// Tests the costs of each frequency of one record.
pub(crate) fn whiteness(
    record: &str,
    spectrum: &RecordSpectrum,
    costs: &[f64],
    sensors: usize,
) -> Whiteness {
    let lags = LAGS.min(costs.len() / 4);
    let (total, weights) = (costs.iter().sum::<f64>(), spectrum.weight.iter().sum::<f64>());
    let mean = if weights > 0.0 { total / weights } else { 0.0 };
    let mut sums = DVector::<f64>::zeros(lags);
    let mut first = DVector::<f64>::zeros(lags);
    let mut second = DMatrix::<f64>::zeros(lags, lags);
    let mut cosines = vec![0.0; lags];
    for ((z, &weight), &cost) in spectrum.z.iter().zip(&spectrum.weight).zip(costs) {
        let mut power = num_complex::Complex::new(1.0, 0.0);
        for cosine in &mut cosines {
            power *= z;
            *cosine = power.re;
        }
        for k in 0..lags {
            sums[k] += (cost - weight * mean) * cosines[k];
            first[k] += weight * cosines[k];
            for l in 0..=k {
                second[(k, l)] += weight * cosines[k] * cosines[l];
            }
        }
    }
    second.fill_upper_triangle_with_lower_triangle();
    // A cost at one frequency has mean w (m - 1) v and variance 2 w (m - 1) v^2.
    let variance = 2.0 * mean * mean / (sensors - 1) as f64;
    let covariance: DMatrix<f64> =
        (second - &first * first.transpose() / weights.max(1.0)) * variance;
    let autocorrelations =
        sums.iter().map(|sum| if total > 0.0 { sum / total } else { 0.0 }).collect();
    let (mut statistic, mut rank) = (0.0, 0);
    if lags > 0 && variance > 0.0 {
        // In a narrow band neighbouring lags say the same.
        const SAME: f64 = 1e-6;
        let eigen = covariance.symmetric_eigen();
        let largest = eigen.eigenvalues.max();
        for (k, &value) in eigen.eigenvalues.iter().enumerate() {
            if value > SAME * largest {
                statistic += eigen.eigenvectors.column(k).dot(&sums).powi(2) / value;
                rank += 1;
            }
        }
    }
    Whiteness {
        record: record.to_owned(),
        autocorrelations,
        statistic,
        degrees_of_freedom: rank,
        p_value: chi_squared_survival(statistic, rank as f64),
    }
}

#[cfg(test)]
mod tests;
