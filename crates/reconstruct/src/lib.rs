//! Reconstruction of a system from sensor records alone, without knowing what excited it.
//!
//! Three methods, each a module with its own `Options`, `Mode` and `Doubt`, and one entry point above them:
//!
//! | item | the question it answers |
//! |---|---|
//! | [`reconstruct`] | which modes do these records show, how certain are they, and what is there to doubt? The entry point to all methods |
//! | [`paper`] | the paper's method, for records without noise: transmissibilities, their differences, the zeros that these share |
//! | [`subspace`] | which directions do the signal subspaces of noisy records share? Closed form, any excitation, no standard errors |
//! | [`likelihood`] | which system is the most likely one, and how certain is it? |
//! | [`output_error`] | which system turns recorded inputs into what the sensors read? |
//! | [`Record`], [`Measurement`], [`NoiseModel`] | what goes in: records, how they were measured, what is known about their noise |
//! | [`SharedModel`] | what the records have in common |
//! | [`spectral_fits`] | response, noise and residuals of every record at each frequency |
//!
//! Each stage can be called by itself. Results carry ranks, residuals, condition numbers and spreads; what makes a result
//! untrustworthy is in its [`Doubt`]s: a doubt is a reason, found in the data, not to trust a result, with a stable
//! [`code`](Doubt::code) and a sentence that can be printed.
//!
//! # Example
//!
//! See [`reconstruct`].

mod error;
pub mod likelihood;
mod model;
pub mod output_error;
pub mod paper;
mod reconstruction;
#[cfg(test)]
mod shipped;
pub mod subspace;

pub use error::ReconstructError;
pub use model::{Channel, Measurement, NoiseModel, Offsets, Record, SharedModel, Trend};
pub use reconstruction::{
    ComparedForm, ComparedOrder, Details, Doubt, Excitation, FoundMode, Method, Options,
    Reconstruction, RecordCondition, reconstruct, spectral_fits,
};

/// The README's example compiles.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
