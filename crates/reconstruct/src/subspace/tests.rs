mod bad_input;
mod disturbed;
mod oracle;
mod planted;

use super::*;
use crate::shipped::pair;
use crate::{Channel, Measurement, NoiseModel, Offsets, SharedModel};
use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

pub(super) fn from_rows(name: &str, rows: &DMatrix<f64>) -> Record {
    let channels = rows
        .row_iter()
        .enumerate()
        .map(|(i, row)| Channel::new(format!("y{i}"), row.iter().copied().collect()));
    Record::new(name, SamplePeriod::new(0.1).unwrap(), channels.collect()).unwrap()
}

pub(super) fn normal(rng: &mut ChaCha8Rng, rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| StandardNormal.sample(rng))
}

pub(super) fn generator(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

fn fixed(order: usize) -> Options {
    Options { order: OrderChoice::Fixed(order), ..Options::default() }
}
