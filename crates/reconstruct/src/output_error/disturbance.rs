//! What disturbs the sensors beside the response to the inputs: its cross-spectral matrix, from the residuals of a fit.
//!
//! Gusts, sensor noise and what no linear model explains are all in the residuals. Their products over neighbouring frequencies, averaged, estimate the m x m
//! matrix S of the disturbance, whatever it is; its inverse weighs the next fit (sample maximum likelihood, Pintelon & Schoukens, System Identification, 2nd
//! ed., 2012, chapter 12).

use nalgebra::{Cholesky, DMatrix};
use num_complex::Complex;

use super::spectra::Spectrum;
use crate::likelihood::cost::noise::LEAST_MODEL_ERROR;

/// Frequencies to each side that are averaged, where the record has enough of them.
const REACH: usize = 12;
/// A record with few frequencies is averaged over this part of them to each side.
const LARGEST_PART: usize = 4;

/// The weights of a record's residuals.
#[derive(Clone, Debug)]
pub(super) struct Weighting {
    /// S^-1 at each frequency, row by row.
    pub(super) precision: Vec<Complex<f64>>,
    /// The sum of weight times ln det S.
    pub(super) log_determinant: f64,
    /// How many independent products were averaged.
    pub(super) averaged: f64,
}

/// The same weight at all frequencies: each sensor over its mean power in the band.
pub(super) fn flat(spectrum: &Spectrum) -> Weighting {
    let (sensors, count) = spectrum.y.shape();
    let inverse = |sensor: usize| {
        let row = spectrum.y.row(sensor);
        let power = row.iter().map(Complex::norm_sqr).sum::<f64>() / count.max(1) as f64;
        Complex::from(if power > 0.0 { 1.0 / power } else { 1.0 })
    };
    let mut at_one = vec![Complex::ZERO; sensors * sensors];
    for sensor in 0..sensors {
        at_one[sensor * (sensors + 1)] = inverse(sensor);
    }
    let precision = at_one.repeat(count);
    Weighting { precision, log_determinant: 0.0, averaged: f64::INFINITY }
}

/// From the residuals of a fit, m x F, and the eigenvalues z of the system.
///
/// A gust goes through the system, so that what it does to the sensors peaks at lightly damped and at slow modes, more sharply than an average over frequencies
/// can follow; sensor noise does not. So the residuals are averaged as they are, and once more with these peaks made as wide as the average; what is more likely
/// counts. A part of each sensor's power is always taken as unexplained: the least relative model error.
pub(super) fn from_residuals(
    residuals: &DMatrix<Complex<f64>>,
    spectrum: &Spectrum,
    eigenvalues: &[Complex<f64>],
) -> Option<Weighting> {
    let as_they_are = vec![1.0; spectrum.z.len()];
    let both = [as_they_are, widening(spectrum, eigenvalues)];
    let found = both.iter().filter_map(|shape| averaged(residuals, spectrum, shape));
    found.min_by(|x, y| x.1.total_cmp(&y.1)).map(|(weighting, _)| weighting)
}

/// What the peaks of narrow modes are multiplied by at each frequency to be as wide as the average.
fn widening(spectrum: &Spectrum, eigenvalues: &[Complex<f64>]) -> Vec<f64> {
    let count = spectrum.z.len();
    let step = (spectrum.z[count - 1].arg() - spectrum.z[0].arg()) / (count - 1).max(1) as f64;
    let width = step * kernel(count).len() as f64;
    let wider = |z: &Complex<f64>| {
        let s = z.ln();
        Complex::new(-s.re.abs().max(width), s.im).exp()
    };
    let pairs: Vec<_> = eigenvalues.iter().map(|z| (*z, wider(z))).collect();
    let ratio = |z: &Complex<f64>| {
        let one = |(narrow, wide): &(Complex<f64>, Complex<f64>)| {
            (z - narrow).norm_sqr() / (z - wide).norm_sqr()
        };
        pairs.iter().map(one).product::<f64>().max(1e-12)
    };
    spectrum.z.iter().map(ratio).collect()
}

/// The average of residuals times the root of `shape`, over it; and minus twice the logarithm of its likelihood.
fn averaged(
    residuals: &DMatrix<Complex<f64>>,
    spectrum: &Spectrum,
    shape: &[f64],
) -> Option<(Weighting, f64)> {
    let (sensors, count) = residuals.shape();
    let kernel = kernel(count);
    let reach = kernel.len() as isize - 1;
    let weight = |lag: isize| kernel[lag.unsigned_abs()];
    let mut precision: Vec<Complex<f64>> = Vec::with_capacity(count * sensors * sensors);
    let (mut log_determinant, mut squares) = (0.0, 0.0);
    let mut covariance = DMatrix::<Complex<f64>>::zeros(sensors, sensors);
    for k in 0..count {
        covariance.fill(Complex::ZERO);
        for lag in -reach..=reach {
            let other = reflected(k as isize + lag, count);
            let column = residuals.column(other);
            let share = weight(lag) * shape[other] / shape[k];
            for l in 0..sensors {
                let with = column[l].conj() * share;
                for i in 0..sensors {
                    covariance[(i, l)] += column[i] * with;
                }
            }
        }
        for sensor in 0..sensors {
            let least = LEAST_MODEL_ERROR * LEAST_MODEL_ERROR * spectrum.power[(sensor, k)];
            covariance[(sensor, sensor)] += Complex::from(least.max(f64::MIN_POSITIVE));
        }
        let factor = Cholesky::new(covariance.clone())?;
        let logs = factor.l_dirty().diagonal().iter().map(|entry| 2.0 * entry.re.ln()).sum::<f64>();
        log_determinant += spectrum.weight[k] * logs;
        let inverse = factor.inverse();
        let own = residuals.column(k);
        squares += spectrum.weight[k] * own.dotc(&(&inverse * own)).re;
        precision.extend(inverse.transpose().iter());
    }
    let likelihood = log_determinant + squares;
    let finite = likelihood.is_finite() && precision.iter().all(|entry| entry.is_finite());
    let products =
        weight(0).powi(2) + 2.0 * (1..=reach).map(|lag| weight(lag).powi(2)).sum::<f64>();
    let weighting = Weighting { precision, log_determinant, averaged: 1.0 / products };
    finite.then_some((weighting, likelihood))
}

/// Hann's weights of a frequency and its neighbours to one side; all of them, both sides, add up to 1.
pub(super) fn kernel(count: usize) -> Vec<f64> {
    let reach = REACH.min(count / LARGEST_PART);
    let angle = |lag: usize| std::f64::consts::PI * lag as f64 / (reach + 1) as f64;
    let raw: Vec<f64> = (0..=reach).map(|lag| 0.5 * (1.0 + angle(lag).cos())).collect();
    let sum = raw[0] + 2.0 * raw[1..].iter().sum::<f64>();
    raw.into_iter().map(|weight| weight / sum).collect()
}

/// An index that runs back at both ends.
pub(super) fn reflected(k: isize, count: usize) -> usize {
    let last = count as isize - 1;
    let k = if k < 0 { -k } else { k };
    let k = if k > last { 2 * last - k } else { k };
    k.clamp(0, last).unsigned_abs()
}

#[cfg(test)]
mod tests;
