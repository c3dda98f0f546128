//! Realizes a noncausal impulse response and prints both halves and the transfer function.

use std::io::Write;

use era::{CompositeOptions, EraOptions, NoncausalMarkov, Order, realize_composite};
use lti::SamplePeriod;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // (q^2 + 2 q) + 5 + sum_(i>=1) (3/4)^(i-1) q^-i
    let mut anticausal = vec![2.0, 1.0];
    anticausal.resize(25, 0.0);
    let mut causal = vec![5.0];
    causal.extend((0..25).map(|i| 0.75_f64.powi(i)));
    let markov = NoncausalMarkov::siso(&anticausal, &causal)?;

    let options = CompositeOptions::both(EraOptions::with_order(Order::Fixed(6)));
    let realization = realize_composite(&markov, SamplePeriod::new(0.1)?, &options)?;
    let transfer = realization.transfer_function()?;

    let mut out = std::io::stdout().lock();
    for (name, half) in [("causal", &realization.causal), ("anticausal", &realization.anticausal)] {
        writeln!(out, "{name}: order {}, {:?}", half.order, half.reason)?;
        writeln!(out, "  condition {:.1}, residual {:.1e}", half.condition, half.residual)?;
    }
    let dropped = transfer.anticausal.dropped;
    writeln!(
        out,
        "anticausal denominator: {} coefficients of at most {:.1e} dropped",
        dropped.denominator, dropped.largest_denominator
    )?;
    writeln!(out, "numerator   {:.6}", transfer.rational.numerator().display("q"))?;
    writeln!(out, "denominator {:.6}", transfer.rational.denominator().display("q"))?;
    Ok(())
}
