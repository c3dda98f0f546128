//! Random signals, each from a stream of its own.

use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Independent streams of one seed.
pub(super) fn stream(seed: u64, number: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(number);
    random
}

/// White Gaussian noise of unit variance.
pub(super) fn normal(rows: usize, columns: usize, random: &mut ChaCha8Rng) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| StandardNormal.sample(random))
}

/// u(k+1) = 0.9 u(k) + white Gaussian noise, for which the signal is taken; its variance stays what it was.
pub(super) fn autoregressive(mut signal: DMatrix<f64>) -> DMatrix<f64> {
    const POLE: f64 = 0.9;
    for k in 1..signal.ncols() {
        signal[k] = POLE * signal[k - 1] + (1.0 - POLE * POLE).sqrt() * signal[k];
    }
    signal
}

/// Samples of a multistep's single step (0.7 s), lengths of its steps and their sides.
const STEP: usize = 7;
const STEPS: [(usize, f64); 4] = [(3, 1.0), (2, -1.0), (1, 1.0), (1, -1.0)];

/// Puts a 3-2-1-1 of this size, whose sign is the side of its first step, at this sample.
pub(super) fn multistep(signal: &mut DMatrix<f64>, first: usize, size: f64) {
    let mut at = first;
    for (length, side) in STEPS {
        for _ in 0..length * STEP {
            signal[at] = size * side;
            at += 1;
        }
    }
}

#[cfg(test)]
mod tests;
