//! Which part of the signals no linear model explains? From the residuals, as white noise of each sensor and a part of its power.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::spectra::Spectrum;
use crate::likelihood::Estimate;
use crate::likelihood::cost::noise::LEAST_MODEL_ERROR;

/// The relative model error eps, from residuals whose variance is s_i^2 + eps^2 P_i(w) for sensor i, by maximum likelihood.
pub(super) fn model_error(
    residuals: &[DMatrix<Complex<f64>>],
    spectra: &[Spectrum],
) -> Option<Estimate> {
    const STEPS: usize = 50;
    const STILL: f64 = 1e-3;
    /// One step changes a variance at most by this factor.
    const LARGEST_FACTOR: f64 = 10.0;
    let sensors = residuals.first()?.nrows();
    // Residuals and powers over each sensor's mean power, so that all variances are parts.
    let mean = |sensor: usize| {
        let (sum, count) = spectra.iter().fold((0.0, 0), |(sum, count), spectrum| {
            (sum + spectrum.power.row(sensor).sum(), count + spectrum.power.ncols())
        });
        if sum > 0.0 { sum / count as f64 } else { 1.0 }
    };
    let means: Vec<f64> = (0..sensors).map(mean).collect();
    let floor = LEAST_MODEL_ERROR * LEAST_MODEL_ERROR;
    let least = |k: usize| if k == sensors { floor } else { 1e-3 * floor };
    let mut variances = DVector::from_element(sensors + 1, 1e-4);
    let mut information = DMatrix::zeros(sensors + 1, sensors + 1);
    for _ in 0..STEPS {
        information.fill(0.0);
        let mut score = DVector::zeros(sensors + 1);
        for (own, spectrum) in residuals.iter().zip(spectra) {
            for k in 0..own.ncols() {
                let weight = spectrum.weight[k];
                for sensor in 0..sensors {
                    let power = spectrum.power[(sensor, k)] / means[sensor];
                    let variance = variances[sensor] + variances[sensors] * power;
                    let found = own[(sensor, k)].norm_sqr() / means[sensor];
                    let excess = weight * (found - variance) / (variance * variance);
                    let precision = weight / (variance * variance);
                    score[sensor] += excess;
                    score[sensors] += excess * power;
                    information[(sensor, sensor)] += precision;
                    information[(sensor, sensors)] += precision * power;
                    information[(sensors, sensor)] += precision * power;
                    information[(sensors, sensors)] += precision * power * power;
                }
            }
        }
        let step = information.clone().lu().solve(&score)?;
        let mut change = 0.0_f64;
        for k in 0..=sensors {
            let (low, high) = (variances[k] / LARGEST_FACTOR, variances[k] * LARGEST_FACTOR);
            let next = (variances[k] + step[k]).clamp(low, high).max(least(k));
            change = change.max((next / variances[k]).ln().abs());
            variances[k] = next;
        }
        if change < STILL {
            break;
        }
    }
    let covariance = information.try_inverse()?;
    let value = variances[sensors].sqrt();
    let spread = (2.0 * covariance[(sensors, sensors)].max(0.0)).sqrt();
    Some(Estimate { value, standard_error: 0.5 * spread / value })
}

#[cfg(test)]
mod tests;
