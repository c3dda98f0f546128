//! The eigensystem realization algorithm: Markov parameters to a state-space model, in both directions of time.
//!
//! # What is here
//!
//! | item | what it does |
//! |---|---|
//! | [`realize()`], [`realize_siso`] | a causal sequence `H_0, H_1, ..` to a balanced discrete-time model |
//! | [`realize_composite`] | a noncausal sequence to a causal model and one in reversed time |
//! | [`CompositeRealization::transfer_function`] | both halves as one rational function of `q` |
//! | [`Order`], [`OrderReason`], [`Floor`] | how many states, why, and the level that they must exceed |
//!
//! Conventions: `H_0 = D` and `H_k = C A^(k-1) B`; `q` advances by one sample and `w = 1/q` goes back by one.
//! Nothing is realized below rounding level, or below the uncertainty that the caller states. What the numbers do not
//! support is data in the result, not an error.
//!
//! # Example
//!
//! The noncausal response `h_i = 2^-|i|` has a stable pole at 1/2 and an unstable one at 2.
//!
//! ```
//! use era::{CompositeOptions, NoncausalMarkov, realize_composite};
//! use lti::SamplePeriod;
//!
//! let halves: Vec<f64> = (0..8).map(|i| 0.5_f64.powi(i)).collect();
//! let h = NoncausalMarkov::siso(&halves[1..], &halves)?;
//! let realization = realize_composite(&h, SamplePeriod::new(1.0)?, &CompositeOptions::default())?;
//! let transfer = realization.transfer_function()?;
//!
//! // sum 2^-|i| q^-i = -3 q / (2 q^2 - 5 q + 2), so that the value at q = 1 is 3.
//! assert_eq!(transfer.rational.denominator().degree(), Some(2));
//! assert!((transfer.rational.eval_complex(1.0.into()).re - 3.0).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "tests compare with exact values where they use ==")
)]

mod balanced;
mod composite;
mod error;
#[cfg(test)]
mod fixtures;
mod hankel;
mod markov;
mod options;
mod order;
mod realize;
mod transfer;

pub use composite::{CompositeOptions, CompositeRealization, CompositeTransfer, realize_composite};
pub use error::EraError;
pub use markov::NoncausalMarkov;
pub use options::EraOptions;
pub use order::{Floor, FloorOrigin, Order, OrderReason};
pub use realize::{Realization, realize, realize_siso};
pub use transfer::{Dropped, HalfTransfer};
