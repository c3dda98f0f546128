//! Plants a noncausal, unstable transmissibility, simulates a record of it and identifies it again.
//!
//! `cargo run --example identify`

use std::io::Write;

use cfi_ident::{ConstantTerm, FitOptions, Orders, Segment, Structure, ZerosAndPoles, fit};
use nalgebra::Complex;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // T(q) = 2 (q - 1.5) / ((q - 1) (q - 0.5)): a pole on the unit circle, which D(q) takes, and one inside.
    let real = |re| Complex::new(re, 0.0);
    let planted = ZerosAndPoles::new(&[real(1.5)], &[real(1.0), real(0.5)], 2.0)?;

    // l = 2 as printed keeps one pole in D(q). The pole at 1/2 decays below rounding within r = 60 samples.
    let structure = Structure::new(Orders::new(2, 60, 3)?, ConstantTerm::Omitted);
    let truth = planted.cfi(structure)?;

    // Any input that keeps varying will do.
    let input: Vec<f64> = (0..600_u32).map(|k| f64::from(k * k % 101) / 50.0 - 1.0).collect();
    let mut output = vec![0.0; 62];
    let simulated = truth.pseudo_output(&input, &[0.0])?;
    output.extend(&simulated.values);
    // The record starts where the simulation does.
    let (from, to) = (simulated.first, output.len());
    let segment = Segment::new(&input[from..to], &output[from..to])?;

    let found = fit(&[segment], &structure, &FitOptions::default())?;
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "{} equations, rank {}, condition {:.1e}",
        found.equations, found.rank, found.condition
    )?;
    writeln!(out, "relative residual {:.1e}", found.relative_residual)?;
    writeln!(out, "{:>6} {:>22} {:>22} {:>9}", "", "planted", "identified", "deviation")?;
    let covariance = &found.parameter_covariance;
    let rows = structure.parameters().zip(truth.theta()).zip(found.model.theta()).enumerate();
    for (i, ((name, planted), identified)) in rows.take(8) {
        let deviation = covariance[(i, i)].sqrt();
        writeln!(
            out,
            "{:>6} {planted:>22.15} {identified:>22.15} {deviation:>9.1e}",
            name.to_string()
        )?;
    }
    Ok(())
}
