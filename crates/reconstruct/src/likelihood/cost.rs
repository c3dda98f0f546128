//! What is minimised? Records in the frequency domain; cost, gradient and Gram matrix of the likelihood, the parts that known signals explain taken out.
//!
//! | file | what it does |
//! |---|---|
//! | `spectrum.rs` | records to the frequency domain; offsets, trends, bands, known inputs |
//! | `fourier.rs` | the transform behind it, of any signal |
//! | `noise.rs` | variances of the noise: units, starts, floors; the power that a model error is a part of |
//! | `parameters.rs` | the unknowns, and where each of them stands in the vector of parameters |
//! | `first_order_hold.rs` | d_j of an excitation that moves between samples |
//! | `feedback.rs`, `record_system.rs`, `schur_form.rs` | the system as one record sees it, prepared for the loop over frequencies |
//! | `resolvent.rs` | (zI - A)^-1 at one frequency, for the input directions |
//! | `frequency_block.rs`, `simd.rs` | everything at eight frequencies |
//! | `sums.rs`, `accumulate.rs` | the sums over frequencies |
//! | `missing.rs` | missing samples as unknowns, eliminated exactly |
//! | `inverse_factor.rs` | unknowns eliminated from a Gram matrix, within what it determines |
//! | `lateral.rs` | derivatives as parameters, and the system that they make |
//! | `evaluation.rs` | cost, gradient and Gram matrix of all records; t_j eliminated |

pub(crate) mod accumulate;
pub(crate) mod evaluation;
pub(crate) mod feedback;
pub(crate) mod first_order_hold;
pub(crate) mod fourier;
mod frequency_block;
pub(crate) mod inverse_factor;
pub(crate) mod lateral;
pub(crate) mod missing;
pub(crate) mod noise;
pub(crate) mod parameters;
pub(crate) mod record_system;
pub(crate) mod resolvent;
mod schur_form;
mod simd;
pub(crate) mod spectrum;
pub(crate) mod sums;
