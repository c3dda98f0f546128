//! Noise levels by restricted likelihood: the excitation takes one direction of the sensors at each frequency, and the rest tells the noise.
//!
//! With N an orthonormal complement of g, the residual N^H e has covariance N^H S N, S = diag s^2, and
//!
//! sum of w [ln det (N^H S N) + e^H N (N^H S N)^-1 N^H e]
//!
//! is minimised over the variances. N (N^H S N)^-1 N^H is the Phi of `accumulate.rs`; so the gradient is the sum of w (Phi_ii - |(Phi e)_i|^2), the expected
//! curvature that of w |Phi_il|^2, and one scoring step solves for the change of the variances.

use nalgebra::DVector;

use crate::likelihood::cost::evaluation::Evaluation;

/// The variances after one scoring step, and the largest change of the logarithm of one.
pub(crate) fn updated(
    evaluation: &Evaluation,
    variances: &[f64],
    floors: &[f64],
) -> (Vec<f64>, f64) {
    // One step changes a variance at most by this factor; noise-free records would send it to zero at once.
    const LARGEST_FACTOR: f64 = 100.0;
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
        .zip(floors)
        .map(|((&variance, step), floor)| {
            let (low, high) = (variance / LARGEST_FACTOR, variance * LARGEST_FACTOR);
            (variance + step).clamp(low, high).max(*floor)
        })
        .collect();
    let change = next
        .iter()
        .zip(variances)
        .map(|(next, variance)| (next / variance).ln().abs())
        .fold(0.0, f64::max);
    (next, change)
}

#[cfg(test)]
mod tests;
