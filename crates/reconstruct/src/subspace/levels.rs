//! Noise levels of the sensors from the records themselves.

use nalgebra::{DMatrix, DVector};

use super::whitening::{Source, Whitening};
use crate::ReconstructError;

/// A change of the levels by less than this ends the iteration: a hundredth of what 2000 samples determine them to.
const TOLERANCE: f64 = 1e-4;

/// Rounds before the iteration gives up. It takes 3 to 8, where it does not flicker between noise directions of nearly equal variance.
const ROUNDS: usize = 30;

/// Levels are not followed below this fraction of a sensor's deviation: there they are rounding errors of the samples.
const ROUNDING: f64 = 1e-13;

/// Where the estimate looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// The number of block rows.
    pub(super) block_rows: usize,
    /// The dimension of the signal there.
    pub(super) signal: usize,
}

/// Estimated levels.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    /// The standard deviation of each sensor's noise.
    pub(super) deviations: Vec<f64>,
    pub(super) rounds: usize,
    pub(super) converged: bool,
    /// Whether no sensor shows more than rounding errors; the deviations are upper bounds then.
    pub(super) rounding: bool,
}

/// The block rows in which noise is looked for: as few as show it, since each further one spends more degrees of freedom on the signal.
///
/// At 2000 samples levels come out 1 to 3 % low with 8 of them, and 4 to 8 % low with 33; at 300 samples 6 % and more than 20 %. Half of all
/// directions are kept for the noise: `(m - 1) L - n >= L (m - 1) / 2`, with some to spare.
pub(super) fn window_rows(sensors: usize, order: usize, block_rows: usize) -> usize {
    const FEWEST: usize = 8;
    FEWEST.max((3 * order).div_ceil(sensors - 1)).min(block_rows)
}

/// Estimates the levels s by fitting `K_j' (I x diag s^2) K_j` to the covariances `K_j' G_j K_j` of the noise directions K_j.
///
/// The fit is linear in s^2. It is weighted by the inverse of its own covariances, which in units of s are identities: so each round scales the
/// sensors, finds the noise directions, solves the m x m normal equations
///
/// ```text
/// sum_b tr(P_a P_b) f_b = sum_i w_i |K_ai|^2,    P_a = K_a' K_a,
/// ```
///
/// summed over the records with their numbers of samples, and multiplies the levels by the roots of f. It starts at 1 % of each
/// sensor's deviation, does not go below 1e-13 of it, and ends when no level changes by more than 1e-4 of itself. Weights from the data instead, as in the inverse of `K' G K`, would
/// favour the directions that happen to have little noise, and cost some per cent.
pub(super) fn estimate(
    sources: &[&(Source, f64)],
    deviations: &[f64],
    window: Window,
) -> Result<Levels, ReconstructError> {
    let m = deviations.len();
    let rows = m * window.block_rows;
    let mut found: Vec<f64> = deviations.iter().map(|deviation| 1e-2 * deviation).collect();
    for round in 1..=ROUNDS {
        let (mut normal, mut right) = (DMatrix::zeros(m, m), DVector::zeros(m));
        let previous = found.clone();
        let whitening = Whitening::Levels(found.clone());
        for (source, weight) in sources {
            let spectrum = whitening.spectrum(source, rows)?;
            let noise = noise_directions(&spectrum.values, rows - window.signal);
            let directions = spectrum.vectors.columns(0, noise);
            let projector = directions * directions.transpose();
            for (i, k) in (0..rows).flat_map(|i| (0..rows).map(move |k| (i, k))) {
                normal[(i % m, k % m)] += weight * projector[(i, k)].powi(2);
            }
            for (value, direction) in spectrum.values.iter().zip(directions.column_iter()) {
                for (i, entry) in direction.iter().enumerate() {
                    right[i % m] += weight * value.max(0.0) * entry * entry;
                }
            }
        }
        // A variance can come out negative, and must not fall faster than the noise directions can follow.
        let change: Vec<f64> = match normal.cholesky() {
            Some(normal) => normal.solve(&right).iter().map(|f: &f64| f.max(1e-4).sqrt()).collect(),
            None => vec![1.0; m],
        };
        found.iter_mut().zip(&change).for_each(|(level, factor)| *level *= factor);
        for (level, deviation) in found.iter_mut().zip(deviations) {
            *level = level.max(ROUNDING * deviation);
        }
        let settled =
            found.iter().zip(&previous).all(|(new, old)| (new / old - 1.0).abs() < TOLERANCE);
        if settled {
            return Ok(Levels {
                rounding: is_rounding(&found, deviations),
                deviations: found,
                rounds: round,
                converged: true,
            });
        }
    }
    Ok(Levels {
        rounding: is_rounding(&found, deviations),
        deviations: found,
        rounds: ROUNDS,
        converged: false,
    })
}

/// The number of noise directions: at least so many, and more where a jump of the eigenvalues shows that the signal has fewer dimensions. Free
/// motion has n; its largest noise directions, taken for signal, would make levels collapse.
fn noise_directions(values: &[f64], least: usize) -> usize {
    /// Eigenvalues of noise don't differ by as much from one to the next.
    const JUMP: f64 = 1000.0;
    let jump = (least..values.len()).find(|&i| values[i] > JUMP * values[i - 1].max(0.0));
    jump.unwrap_or(least)
}

/// Whether no sensor shows more than rounding errors.
fn is_rounding(found: &[f64], deviations: &[f64]) -> bool {
    found.iter().zip(deviations).all(|(level, deviation)| *level <= 2.0 * ROUNDING * deviation)
}

#[cfg(test)]
mod tests;
