mod bad_input;
mod disturbed;
mod oracle;
mod planted;

use super::*;
use crate::Channel;
use lti::SamplePeriod;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// A pair of records of the paper's aircraft from tests/data/records: sideslip, roll rate, yaw rate.
fn pair(name: &str) -> [Record; 2] {
    ["aileron", "rudder"].map(|surface| record(&format!("{name}_{surface}")))
}

fn record(name: &str) -> Record {
    let file = format!("{}/../../tests/data/records/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|field| field.parse().unwrap()).collect()).collect();
    let channel =
        |column: usize| Channel::new(names[column], rows.iter().map(|row| row[column]).collect());
    Record::new(name, SamplePeriod::new(0.1).unwrap(), (1..4).map(channel).collect()).unwrap()
}

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
