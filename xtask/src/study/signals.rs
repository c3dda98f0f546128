//! Random signals, each from a stream of its own, and what moves the surfaces.

pub(super) use flight::{Stream, autoregressive, normal};
use nalgebra::DMatrix;

/// Independent streams of one seed.
pub(super) fn stream(seed: u64, number: u64) -> Stream {
    Stream::new(seed, number)
}

/// Samples of a multistep's single step: 0.7 s.
const STEP: usize = 7;

/// Puts a 3-2-1-1 of this size, whose sign is the side of its first step, at this sample.
pub(super) fn multistep(signal: &mut DMatrix<f64>, first: usize, size: f64) {
    flight::add_multistep(signal, first, STEP, size);
}
