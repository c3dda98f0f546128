//! Which part of each sensor is tied linearly to the inputs of a record? Multiple coherence over neighbouring frequencies (Bendat & Piersol, Random Data, 4th ed.,
//! 2010, chapter 7).

use nalgebra::{Cholesky, DMatrix};
use num_complex::Complex;

use super::disturbance::{kernel, reflected};

/// Coherence of each row of `signals`, m x F, with all rows of `inputs` together, 0 to 1; and the value that chance gives on average.
pub(super) fn coherence(
    signals: &DMatrix<Complex<f64>>,
    inputs: &DMatrix<Complex<f64>>,
) -> (DMatrix<f64>, f64) {
    /// A part of an input's power, so that two inputs that move alike count as one.
    const RIDGE: f64 = 1e-9;
    let (sensors, count) = signals.shape();
    let power = |row: usize| inputs.row(row).iter().map(Complex::norm_sqr).sum::<f64>();
    let moving: Vec<usize> = (0..inputs.nrows()).filter(|&row| power(row) > 0.0).collect();
    let kernel = kernel(count);
    let reach = kernel.len() as isize - 1;
    let weight = |lag: isize| kernel[lag.unsigned_abs()];
    let squares: f64 = (-reach..=reach).map(|lag| weight(lag).powi(2)).sum();
    let mut found = DMatrix::zeros(sensors, count);
    if moving.is_empty() {
        return (found, 0.0);
    }
    for k in 0..count {
        let mut among = DMatrix::<Complex<f64>>::zeros(moving.len(), moving.len());
        let mut mixed = DMatrix::<Complex<f64>>::zeros(moving.len(), sensors);
        let mut own = vec![0.0; sensors];
        for lag in -reach..=reach {
            let at = reflected(k as isize + lag, count);
            let share = weight(lag);
            for (i, &input) in moving.iter().enumerate() {
                let conjugate = inputs[(input, at)].conj() * share;
                for (l, &other) in moving.iter().enumerate() {
                    among[(i, l)] += conjugate * inputs[(other, at)];
                }
                for sensor in 0..sensors {
                    mixed[(i, sensor)] += conjugate * signals[(sensor, at)];
                }
            }
            for (sensor, own) in own.iter_mut().enumerate() {
                *own += share * signals[(sensor, at)].norm_sqr();
            }
        }
        for i in 0..moving.len() {
            let least = among[(i, i)].re * RIDGE + f64::MIN_POSITIVE;
            among[(i, i)] += Complex::from(least);
        }
        let Some(factor) = Cholesky::new(among) else { continue };
        let half = factor.l().solve_lower_triangular(&mixed);
        let Some(half) = half else { continue };
        for sensor in 0..sensors {
            let tied: f64 = half.column(sensor).iter().map(Complex::norm_sqr).sum();
            let part = if own[sensor] > 0.0 { tied / own[sensor] } else { 0.0 };
            found[(sensor, k)] = part.clamp(0.0, 1.0);
        }
    }
    (found, (moving.len() as f64 * squares).min(1.0))
}

/// The part of each sensor's power that is tied to the inputs and not explained by the model: residuals and what the sensors read, m x F.
pub(super) fn tied_and_unexplained(
    residuals: &DMatrix<Complex<f64>>,
    measured: &DMatrix<Complex<f64>>,
    inputs: &DMatrix<Complex<f64>>,
) -> Vec<f64> {
    let (found, by_chance) = coherence(residuals, inputs);
    let part = |sensor: usize| {
        let power = |of: &DMatrix<Complex<f64>>, k: usize| of[(sensor, k)].norm_sqr();
        let frequencies = 0..residuals.ncols();
        let tied = |k: usize| (found[(sensor, k)] - by_chance).max(0.0) * power(residuals, k);
        let all: f64 = frequencies.clone().map(|k| power(measured, k)).sum();
        let tied: f64 = frequencies.map(tied).sum();
        if all > 0.0 { tied / all } else { 0.0 }
    };
    (0..residuals.nrows()).map(part).collect()
}

#[cfg(test)]
mod tests;
