//! Simulated flights: what moves the surfaces, gusts, and what the sensors then read.
//!
//! | item | what it is |
//! |---|---|
//! | [`Stream`] | random numbers of one seed, the same on every machine |
//! | [`normal`], [`autoregressive`], [`add_multistep`], [`add_doublet`] | signals that are held from sample to sample |
//! | [`behind_low_pass`] | a system behind a low-pass filter in continuous time, for signals that are not held |
//! | [`in_side_gust`] | an aircraft in a side gust |
//! | [`ContinuousNoise`] | the motion of a system that white noise in continuous time drives, sampled |
//!
//! Nothing here knows an aircraft's numbers, and nothing reads a clock: the seed is an argument.
//!
//! # Example
//!
//! ```
//! use flight::{Stream, add_multistep, normal};
//! use nalgebra::DMatrix;
//!
//! let mut aileron = DMatrix::zeros(1, 100);
//! add_multistep(&mut aileron, 10, 7, 0.05);
//! assert_eq!(aileron.iter().filter(|angle| **angle > 0.0).count(), 28); // three steps and one, seven samples each
//!
//! // The same seed, the same numbers.
//! assert_eq!(normal(2, 3, &mut Stream::new(1, 0)), normal(2, 3, &mut Stream::new(1, 0)));
//! ```
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "tests compare with exact values where they use ==")
)]

mod continuous_noise;
mod error;
mod gust;
mod low_pass;
mod random;
mod signals;

pub use continuous_noise::{ContinuousNoise, SUBSTEPS};
pub use error::FlightError;
pub use gust::in_side_gust;
pub use low_pass::behind_low_pass;
pub use random::{Stream, normal};
pub use signals::{add_doublet, add_multistep, autoregressive};
