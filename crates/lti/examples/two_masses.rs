//! Two masses joined by a spring, the first tied to the ground: modes, zeros, sampling, and the transmissibility
//! from the first mass to the second.
//!
//! `cargo run -p lti --example two_masses`

use std::error::Error;
use std::io::Write;

use lti::{Channels, Continuous, SamplePeriod, StateSpace, Transmissibility};
use nalgebra::{DMatrix, dmatrix};

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    // States: positions x1, x2 in m and their rates. Stiffness 20 N/m, damping 0.4 N s/m, masses 1 kg.
    let (k, d) = (20.0, 0.4);
    let system = StateSpace::<Continuous>::new(
        dmatrix![
            0.0, 0.0, 1.0, 0.0;
            0.0, 0.0, 0.0, 1.0;
            -2.0 * k, k, -2.0 * d, d;
            k, -k, d, -d],
        dmatrix![0.0; 0.0; 1.0; 0.0], // a force on the first mass, in N
        dmatrix![1.0, 0.0, 0.0, 0.0; 0.0, 1.0, 0.0, 0.0],
        DMatrix::zeros(2, 1),
    )?;

    writeln!(out, "mode   frequency [rad/s]   damping   period [s]   condition")?;
    for (i, mode) in system.modes()?.iter().enumerate() {
        writeln!(
            out,
            "{i:4}   {:17.4}   {:7.4}   {:10.4}   {:9.2}",
            mode.natural_frequency_rad_s,
            mode.damping_ratio,
            mode.period_s.unwrap_or(f64::INFINITY),
            mode.condition.unwrap_or(f64::NAN),
        )?;
    }
    for (output, name) in [(0, "x1"), (1, "x2")] {
        let zeros = system.subsystem(&[output], &[0])?.invariant_zeros()?;
        let list: Vec<String> = zeros.values().iter().map(|z| format!("{z:.4}")).collect();
        writeln!(out, "zeros from the force to {name}: {}", list.join(", "))?;
    }

    // The force isn't needed to get from one mass to the other.
    let sampled = system.zoh(SamplePeriod::new(0.05)?)?;
    let t = Transmissibility::between(
        &sampled,
        Channels { excitation: 0, from_output: 0, to_output: 1 },
    )?;
    writeln!(
        out,
        "x2 = T x1 with T = ({}) / ({})",
        t.numerator().display("q"),
        t.denominator().display("q")
    )?;
    let force = DMatrix::from_fn(1, 400, |_, k| f64::from(u8::from(k % 37 < 11)));
    let response = sampled.simulate(&force, None)?.outputs;
    let record = |i: usize| response.row(i).iter().copied().collect::<Vec<f64>>();
    let residual = t.relation_residual(&record(0), &record(1));
    let worst = residual.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    writeln!(out, "largest violation over 400 samples: {worst:.1e} m")?;

    let back = sampled.inverse_zoh_with_residual()?;
    writeln!(
        out,
        "back in continuous time, A is off by {:.1e}",
        (back.system.a() - system.a()).amax()
    )?;
    Ok(())
}
