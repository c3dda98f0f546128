//! Gram matrices in doubled precision: a composite model's columns, block-Hankel matrices, and what is solved afterwards.
//!
//! `cargo bench -p hankel`; docs/benchmarks.md has the figures beside those of other libraries.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use hankel::{Column, Gram, Layout, Options, gram};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

fn main() {
    divan::main();
}

/// Samples of each channel.
const LENGTHS: [usize; 2] = [10_000, 100_000];

/// White noise.
fn record(channels: u64, samples: usize) -> Vec<Vec<f64>> {
    let channel = |seed| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        (0..samples).map(|_| StandardNormal.sample(&mut random)).collect()
    };
    (0..channels).map(channel).collect()
}

/// The columns of a composite model with l = 4 and r = d, and its target: 2 r + 5.
fn composite(reach: isize) -> Layout {
    let output = (1..=4).map(|lag| Column::new(1, lag));
    let input = (-reach..=reach).map(|lag| Column::new(0, lag));
    Layout::new(2, output.chain(input).collect()).expect("the columns differ")
}

fn sum(layout: &Layout, record: &[Vec<f64>], threads: usize) -> Gram {
    let channels: Vec<&[f64]> = record.iter().map(Vec::as_slice).collect();
    let options = Options { threads, ..Options::default() };
    gram(layout, black_box(&channels), &options).expect("finite samples, more than the lags")
}

/// By samples.
#[divan::bench(args = LENGTHS)]
fn composite_54(bencher: Bencher<'_, '_>, samples: usize) {
    let (layout, record) = (composite(25), record(2, samples));
    bencher.counter(ItemsCount::new(samples)).bench(|| sum(&layout, &record, 1));
}

/// By r = d, at 10 000 samples.
#[divan::bench(args = [5, 25, 100])]
fn composite_reach(bencher: Bencher<'_, '_>, reach: isize) {
    let (layout, record) = (composite(reach), record(2, LENGTHS[0]));
    bencher.bench(|| sum(&layout, &record, 1));
}

/// By threads, at 100 000 samples.
#[divan::bench(args = [1, 2])]
fn composite_threads(bencher: Bencher<'_, '_>, threads: usize) {
    let (layout, record) = (composite(25), record(2, LENGTHS[1]));
    bencher.bench(|| sum(&layout, &record, threads));
}

/// Three channels, 20 block rows, by samples.
#[divan::bench(args = LENGTHS)]
fn block_hankel(bencher: Bencher<'_, '_>, samples: usize) {
    let layout = Layout::block_hankel(3, 20).expect("a small layout");
    let record = record(3, samples);
    bencher.counter(ItemsCount::new(samples)).bench(|| sum(&layout, &record, 1));
}

/// Pivoted Cholesky factor in doubled precision, by r = d.
#[divan::bench(args = [5, 25, 100])]
fn cholesky(bencher: Bencher<'_, '_>, reach: isize) {
    let gram = sum(&composite(reach), &record(2, LENGTHS[0]), 1);
    bencher.bench(|| black_box(&gram).cholesky(None).expect("a symmetric matrix"));
}
