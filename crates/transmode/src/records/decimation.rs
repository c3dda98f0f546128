//! Every K-th sample, behind a low-pass filter.
//!
//! Plain decimation folds all frequencies above the new Nyquist frequency onto those below. That is noise, and worse: within K old samples the
//! unknown excitation takes K values, which drive the sampled state along b, A b, .. A^(K-1) b, so that one excitation looks like several, and
//! the methods count them.
//!
//! So the channels are filtered first, all of them by the same linear filter F. From y_o = T y_i follows F y_o = T F y_i: what is filtered is a
//! record of the same system under a filtered excitation, with the same eigenvalues, and that excitation changes little within a new sample.
//! This holds whatever the phase of F; it has none, so that times stay what they are. At the ends of a record the filter would need samples that
//! are not there, and made-up ones would be an excitation of each sensor alone: those ends are cut off, about 13 new samples each.
//!
//! What it costs: the noise of the sensors is no longer white near the new Nyquist frequency, and there is hardly any signal left there. A
//! method that weighs frequencies should leave out those above 0.8 of it (`--band`).

use std::f64::consts::PI;
use std::num::NonZero;

/// Gain of the filter above its stop frequency, in decibels below one. Sensors are good to some 60 dB at best; what folds back lies below
/// their noise.
const ATTENUATION_DB: f64 = 80.0;

/// The filter passes up to this part of the new Nyquist frequency, and stops from the mirror image above it, so that only what is between the
/// two folds, and only onto itself.
const PASS: f64 = 0.8;

/// A symmetric filter that decimates by a factor.
#[derive(Clone, Debug)]
pub(crate) struct Decimator {
    factor: usize,
    /// The weight of the middle sample, then those of its neighbours at either side. Together with both sides they sum to one.
    weights: Vec<f64>,
}

impl Decimator {
    /// A windowed sinc with a Kaiser window. Its length grows with the factor: compare [`length`] with the record first.
    ///
    /// Source: J. F. Kaiser, "Nonrecursive digital filter design using the I0-sinh window function", 1974; as A. V. Oppenheim and R. W. Schafer,
    /// "Discrete-Time Signal Processing", 3rd edition, 7.75 and 7.76, give it.
    pub(crate) fn new(factor: NonZero<usize>) -> Self {
        let margin = margin(factor);
        let factor = factor.get();
        if factor == 1 {
            return Self { factor, weights: vec![1.0] };
        }
        let shape = 0.1102 * (ATTENUATION_DB - 8.7);
        let cutoff = PI / factor as f64;
        let weight = |index: usize| {
            let distance = index as f64;
            let sinc =
                if index == 0 { cutoff / PI } else { (cutoff * distance).sin() / (PI * distance) };
            sinc * bessel_i0(shape * (1.0 - (distance / margin as f64).powi(2)).max(0.0).sqrt())
        };
        let mut weights: Vec<f64> = (0..=margin).map(weight).collect();
        let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
        weights.iter_mut().for_each(|weight| *weight /= sum);
        Self { factor, weights }
    }

    /// Samples that are lost at either end.
    pub(crate) fn margin(&self) -> usize {
        self.weights.len() - 1
    }

    /// The filtered samples `margin`, `margin + factor` and so on; none if the signal is shorter than the filter.
    pub(crate) fn decimate(&self, signal: &[f64]) -> Vec<f64> {
        let margin = self.margin();
        let filtered = |window: &[f64]| {
            let (before, after) = window.split_at(margin);
            let pairs = before.iter().rev().zip(&after[1..]).zip(&self.weights[1..]);
            after[0] * self.weights[0] + pairs.map(|((a, b), weight)| (a + b) * weight).sum::<f64>()
        };
        signal.windows(2 * margin + 1).step_by(self.factor).map(filtered).collect()
    }
}

/// Samples that the filter of a factor takes for its first result.
pub(crate) fn length(factor: NonZero<usize>) -> usize {
    margin(factor).saturating_mul(2).saturating_add(1)
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "what is too large stays the largest number there is"
)]
fn margin(factor: NonZero<usize>) -> usize {
    if factor == NonZero::<usize>::MIN {
        return 0;
    }
    let transition = 2.0 * (1.0 - PASS) * PI / factor.get() as f64;
    ((ATTENUATION_DB - 8.0) / (2.285 * transition) / 2.0).ceil() as usize
}

/// The modified Bessel function of order zero, by its power series.
pub(super) fn bessel_i0(x: f64) -> f64 {
    let quarter = x * x / 4.0;
    let (mut sum, mut term, mut k) = (1.0, 1.0, 1.0);
    while term > 1e-17 * sum {
        term *= quarter / (k * k);
        sum += term;
        k += 1.0;
    }
    sum
}

#[cfg(test)]
mod tests;
