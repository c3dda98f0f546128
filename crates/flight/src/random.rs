//! Random numbers: independent streams of one seed.

use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// A stream of random numbers. Streams of one seed are independent of each other.
///
/// The bits are those of ChaCha with 8 rounds, so that they do not depend on the machine.
#[derive(Debug, Clone)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// Stream `number` of a seed.
    #[must_use]
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number);
        Self(random)
    }

    /// A normal deviate: mean 0, variance 1.
    pub fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}

/// White Gaussian noise of unit variance, drawn column by column.
pub fn normal(rows: usize, columns: usize, random: &mut Stream) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| random.normal())
}
