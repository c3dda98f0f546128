//! Prints the roots of a polynomial with multiplicities and condition numbers.
//!
//! `cargo run -p poly --example roots -- 1 3 -22 39 -21` takes the coefficients, highest degree first.
//! Without arguments it shows three polynomials: a well conditioned one, one with multiple roots that were rounded
//! away, and one whose six roots crowd around 1.

use poly::{MrootsOptions, Poly, mroots};
use std::io::{self, Write};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut out = io::stdout().lock();
    let arguments: Vec<f64> =
        std::env::args().skip(1).map(|text| text.parse()).collect::<Result<_, _>>()?;
    if !arguments.is_empty() {
        return show(&mut out, "given", &Poly::from_descending(&arguments));
    }
    show(
        &mut out,
        "(p - 1)(p + 7)(p^2 - 3p + 3)",
        &Poly::from_descending(&[1.0, 3.0, -22.0, 39.0, -21.0]),
    )?;
    let roots = [vec![0.1; 5], vec![0.3; 3], vec![0.7; 2]].concat();
    show(&mut out, "(q - 0.1)^5 (q - 0.3)^3 (q - 0.7)^2", &Poly::from_roots(&roots))?;
    let crowded = [
        0.6906440710552105,
        -4.05982359385132,
        9.962354672244818,
        -13.062468527299336,
        9.651879761575605,
        -3.8105190830713336,
        0.6279326993463553,
    ];
    show(
        &mut out,
        "lateral dynamics of an aircraft, sampled at 10 Hz",
        &Poly::from_descending(&crowded),
    )
}

fn show(out: &mut impl Write, name: &str, p: &Poly<f64>) -> Result<(), Box<dyn std::error::Error>> {
    let found = mroots(p, &MrootsOptions::default())?;
    writeln!(out, "{name}\n  {:.5}", p.display("x"))?;
    writeln!(out, "  {:>22} {:>22}  times  condition  error", "real part", "imaginary part")?;
    for root in &found.roots {
        writeln!(
            out,
            "  {:>22.17} {:>22.17} {:>6} {:>10.1e} {:>6.0e}",
            root.value.re, root.value.im, root.multiplicity, root.condition, root.error_estimate
        )?;
    }
    writeln!(out, "  backward error {:.0e}, {} sweeps\n", found.backward_error, found.iterations)?;
    Ok(())
}
