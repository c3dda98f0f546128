//! Which system turns the recorded inputs into what the sensors read? Output error in the frequency domain, whatever the disturbance.
//!
//! # The problem
//!
//! At each frequency of a record's discrete Fourier transform, z = exp(j w T),
//!
//! Y = H [(C (zI - A)^-1 B + D) V + z C (zI - A)^-1 t] + E,
//!
//! with V the recorded inputs, H and V turned by the lags of sensors and inputs, t the difference between initial and final state, and E a disturbance of any
//! spectrum: gusts, sensor noise, what no linear model explains. The fit minimises E^H S^-1 E over all frequencies and records, S the cross-spectral matrix of
//! the residuals averaged over neighbouring frequencies; fit and S in turns until both stand still (sample maximum likelihood). Nothing is assumed about the disturbance, and
//! nothing has to be projected out, so that one record is enough.
//!
//! Forms of different size compare by Schwarz's criterion: systems of so many states of which nothing else is known, and the lateral equations of an aircraft, whose
//! parameters are stability and control derivatives.
//!
//! | file | the question it answers |
//! |---|---|
//! | `spectra.rs` | what do sensors and inputs hold at each frequency? |
//! | `parametrisation.rs`, `black_box.rs`, `lateral.rs`, `cells.rs` | which matrices may be, and what is free in them? |
//! | `residuals.rs`, `known_signals.rs` | what do matrices leave unexplained, and how does that change with them? |
//! | `disturbance.rs`, `model_error.rs` | what is the disturbance? |
//! | `observer.rs`, `regression.rs` | where does the search start? |
//! | `search.rs`, `candidate.rs`, `forms.rs`, `identify.rs` | how is it searched, and which form is used? |
//! | `explained.rs` | how much of what a sensor reads does it explain? |
//! | `coherence.rs`, `lag_test.rs` | is something tied to the inputs that the model does not have? |
//! | `simulation.rs` | what would sensors read under these inputs? |
//! | `fit.rs`, `doubt.rs` | what came out, how certain is it, and what is there to doubt? |

mod black_box;
mod candidate;
mod cells;
mod coherence;
mod disturbance;
mod doubt;
mod explained;
mod fit;
mod forms;
mod identify;
mod known_signals;
mod lag_test;
mod model_error;
mod observer;
mod options;
mod parametrisation;
mod regression;
mod residuals;
mod search;
mod simulation;
mod spectra;

pub use crate::likelihood::Derivative;
pub use doubt::Doubt;
pub use fit::{Compared, Fit, RecordFit};
pub use identify::identify;
pub use options::{Lag, Options, RecordedInputs, Structure};
pub use simulation::{InputModel, Simulation, simulate};

#[cfg(test)]
mod tests;
