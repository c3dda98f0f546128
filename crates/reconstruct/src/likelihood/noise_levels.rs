//! Noise levels by restricted likelihood: the excitation takes one direction of the sensors at each frequency, and the rest tells the noise.
//!
//! With N an orthonormal complement of g, the residual N^H e has covariance N^H S N, S = diag s^2, and
//!
//! sum of w [ln det (N^H S N) + e^H N (N^H S N)^-1 N^H e]
//!
//! is minimised over the variances. N (N^H S N)^-1 N^H is the Phi of `sums.rs`; so the gradient is the sum of w (Phi_ii - |(Phi e)_i|^2), the expected
//! curvature that of w |Phi_il|^2, and one scoring step solves for the change of the variances.

use nalgebra::DVector;

use super::evaluation::Evaluation;
use super::options::{LikelihoodNoise, LikelihoodOptions};
use super::spectrum::{count, rms};
use super::uncertainty::Estimate;
use crate::Record;

/// Where nothing is known, the noise starts at this part of a sensor's root mean square over all records.
const FIRST_GUESS: f64 = 0.01;

/// What each sensor is divided by: its noise level as far as it is known.
pub(super) fn units(records: &[Record], options: &LikelihoodOptions) -> Vec<f64> {
    let sensors = records.first().map_or(0, |record| record.channels().len());
    match &options.noise {
        LikelihoodNoise::Given(levels)
        | LikelihoodNoise::Estimated { first_guess: Some(levels) } => levels.clone(),
        LikelihoodNoise::Estimated { first_guess: None } => (0..sensors)
            .map(|sensor| {
                let squares: f64 = records
                    .iter()
                    .map(|record| rms(&record.channels()[sensor].values).powi(2))
                    .sum();
                FIRST_GUESS * (squares / count(records.len())).sqrt()
            })
            .collect(),
        LikelihoodNoise::Spectra(spectra) => (0..sensors)
            .map(|sensor| {
                let all = spectra.iter().flat_map(|spectrum| spectrum.covariances());
                let (sum, number) = all.fold((0.0, 0.0), |(sum, number), covariance| {
                    (sum + covariance[(sensor, sensor)].re, number + 1.0)
                });
                (sum / number).sqrt()
            })
            .collect(),
    }
}

/// The variances after one scoring step, and the largest change of the logarithm of one.
pub(super) fn updated(evaluation: &Evaluation, variances: &[f64]) -> (Vec<f64>, f64) {
    // One step changes a variance at most by this factor; noise-free records would send it to zero at once.
    const LARGEST_FACTOR: f64 = 100.0;
    // In units of the first guess squared: rounding errors of a sensor lie above it.
    const LEAST: f64 = 1e-24;
    let step = evaluation
        .information
        .clone()
        .lu()
        .solve(&evaluation.score)
        .filter(|step| step.iter().all(|entry| entry.is_finite()))
        .unwrap_or_else(|| DVector::zeros(variances.len()));
    let next: Vec<f64> = variances
        .iter()
        .zip(step.iter())
        .map(|(&variance, step)| {
            let (low, high) = (variance / LARGEST_FACTOR, variance * LARGEST_FACTOR);
            (variance + step).clamp(low, high).max(LEAST)
        })
        .collect();
    let change = next
        .iter()
        .zip(variances)
        .map(|(next, variance)| (next / variance).ln().abs())
        .fold(0.0, f64::max);
    (next, change)
}

/// Standard deviations in the sensors' units, with their own standard deviations where they were estimated.
pub(super) fn estimates(
    evaluation: &Evaluation,
    variances: &[f64],
    units: &[f64],
    estimated: bool,
) -> Vec<Estimate> {
    let covariance = if estimated { evaluation.information.clone().try_inverse() } else { None };
    variances
        .iter()
        .zip(units)
        .enumerate()
        .map(|(sensor, (&variance, unit))| {
            let value = variance.sqrt() * unit;
            // The information about a variance is half the expected curvature of the objective above.
            let deviation = match &covariance {
                Some(covariance) => {
                    let spread = (2.0 * covariance[(sensor, sensor)].max(0.0)).sqrt();
                    0.5 * value * spread / variance
                }
                None if estimated => f64::INFINITY,
                None => 0.0,
            };
            Estimate { value, deviation }
        })
        .collect()
}

#[cfg(test)]
mod tests;
