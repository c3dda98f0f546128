//! What moves a surface, held from sample to sample.

use nalgebra::DMatrix;

/// The signal u(k+1) = 0.9 u(k) + sqrt(1 - 0.9^2) w(k+1) for white noise w: its variance stays that of w.
#[must_use]
pub fn autoregressive(mut signal: DMatrix<f64>) -> DMatrix<f64> {
    const POLE: f64 = 0.9;
    for k in 1..signal.len() {
        signal[k] = POLE * signal[k - 1] + (1.0 - POLE * POLE).sqrt() * signal[k];
    }
    signal
}

/// Lengths of the steps of a 3-2-1-1, and their sides.
const MULTISTEP: [(usize, f64); 4] = [(3, 1.0), (2, -1.0), (1, 1.0), (1, -1.0)];
/// The same of a doublet.
const DOUBLET: [(usize, f64); 2] = [(1, 1.0), (1, -1.0)];

/// Puts a 3-2-1-1 at sample `first`: steps of three, two, one and one times `step` samples with alternating sides, the first on the side of `size`.
///
/// What reaches beyond the signal's end is cut off.
pub fn add_multistep(signal: &mut DMatrix<f64>, first: usize, step: usize, size: f64) {
    add(signal, first, step, size, &MULTISTEP);
}

/// Puts a doublet at sample `first`: `step` samples to the side of `size`, and as many to the other.
///
/// What reaches beyond the signal's end is cut off.
pub fn add_doublet(signal: &mut DMatrix<f64>, first: usize, step: usize, size: f64) {
    add(signal, first, step, size, &DOUBLET);
}

fn add(signal: &mut DMatrix<f64>, first: usize, step: usize, size: f64, steps: &[(usize, f64)]) {
    let sides = steps.iter().flat_map(|(length, side)| std::iter::repeat_n(*side, length * step));
    for (place, side) in signal.iter_mut().skip(first).zip(sides) {
        *place = size * side;
    }
}

#[cfg(test)]
mod tests;
