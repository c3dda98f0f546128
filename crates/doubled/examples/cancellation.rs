//! Prints `sqrt(b^2 + 1) - b` for growing b: in plain floats, in doubled precision, and by a formula without cancellation.
//!
//! `cargo run -p doubled --example cancellation`

use std::io::{self, Write};

use doubled::DoubleDouble;

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    writeln!(out, "{:>6} {:>23} {:>23} {:>23}", "b", "floats", "doubled", "1 / (sqrt + b)")?;
    for exponent in 0..=14 {
        let b = 10f64.powi(exponent);
        let plain = (b * b + 1.0).sqrt() - b;
        let root = (DoubleDouble::product(b, b) + DoubleDouble::ONE).sqrt();
        let difference = root - DoubleDouble::from(b);
        let stable = DoubleDouble::ONE / (root + DoubleDouble::from(b));
        writeln!(
            out,
            "{b:>6.0e} {plain:>23.16e} {:>23.16e} {:>23.16e}",
            difference.value(),
            stable.value()
        )?;
    }
    Ok(())
}
