//! A resonance in a signal that comes in pieces, with a gap, and that nobody keeps.
//!
//! `cargo run --example in_pieces`

use std::io::Write;

use hankel::{Accumulator, Layout, Missing, Options};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A damped oscillation that is struck again and again: x(k+2) = a x(k+1) + b x(k) + w(k).
    let (a, b) = (1.95, -0.98);
    let mut state = [0.0, 0.0];
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut sample = move || {
        let strike: f64 = StandardNormal.sample(&mut random);
        state = [state[1], a * state[1] + b * state[0] + strike];
        state[1]
    };

    // Rows [x(k), x(k+1), x(k+2)]: one Gram matrix of three shifted copies, whatever the length.
    let layout = Layout::block_hankel(1, 3)?;
    let options = Options { missing: Missing::Gap, ..Options::default() };
    let mut sums = Accumulator::new(&layout, &options)?;
    for piece in 0..100 {
        let mut samples: Vec<f64> = (0..10_000).map(|_| sample()).collect();
        if piece == 50 {
            samples[1234] = f64::NAN; // No row reaches across it.
        }
        sums.push(&[&samples])?;
    }

    let gram = sums.gram()?;
    let found = gram.least_squares(2, None)?;
    let mut out = std::io::stdout().lock();
    writeln!(out, "{} rows, rounding {:.0e}", gram.rows(), gram.rounding())?;
    writeln!(out, "condition {:.1}", found.factor.condition())?;
    writeln!(
        out,
        "a = {:.4} ({a}), b = {:.4} ({b})",
        found.coefficients[1], found.coefficients[0]
    )?;
    Ok(())
}
