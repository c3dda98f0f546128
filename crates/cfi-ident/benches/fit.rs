//! Composite fits: from the Gram matrix and by QR.
//!
//! `cargo bench -p cfi-ident`; docs/benchmarks.md has the figures beside those of other libraries.

use cfi_ident::{ConstantTerm, Engine, Fit, FitOptions, Orders, Segment, Structure, fit};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

fn main() {
    divan::main();
}

/// A pseudo input of white noise; the pseudo output is its fading sum with noise of its own, so that all parameters are determined.
fn record(samples: usize) -> [Vec<f64>; 2] {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut noise = || -> f64 { StandardNormal.sample(&mut random) };
    let input: Vec<f64> = (0..samples).map(|_| noise()).collect();
    let mut sum = 0.0;
    let mut fading = |x: &f64| {
        sum = 0.95 * sum + x;
        sum + 0.01 * noise()
    };
    let output = input.iter().map(&mut fading).collect();
    [input, output]
}

fn identify(record: &[Vec<f64>; 2], options: &FitOptions) -> Fit {
    let structure =
        Structure::new(Orders::new(4, 25, 25).expect("54 parameters"), ConstantTerm::Omitted);
    let [input, output] = black_box(record);
    let segment = Segment::new(input, output).expect("finite samples of one length");
    fit(&[segment], &structure, options).expect("more samples than parameters")
}

/// From the Gram matrix, by samples; 2000 are those of the paper's example.
#[divan::bench(args = [2000, 20_000])]
fn gram(bencher: Bencher<'_, '_>, samples: usize) {
    let record = record(samples);
    bencher.counter(ItemsCount::new(samples)).bench(|| identify(&record, &FitOptions::default()));
}

/// By Householder QR and refinement, by samples.
#[divan::bench(args = [2000, 20_000])]
fn qr(bencher: Bencher<'_, '_>, samples: usize) {
    let record = record(samples);
    let options = FitOptions { engine: Engine::Qr, ..FitOptions::default() };
    bencher.counter(ItemsCount::new(samples)).bench(|| identify(&record, &options));
}
