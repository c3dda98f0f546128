//! What do the records hold, and what do they have in common? Records and how they were measured, the system that they
//! share, what is known about their noise, and the frequencies that are used. `matching.rs` pairs points of the complex plane for whoever compares two lists of them.

mod frequency_band;
mod gap_filling;
mod hold;
pub(crate) mod lateral_equations;
pub(crate) mod matching;
mod measurement;
mod noise_model;
pub(crate) mod noise_spectrum;
pub(crate) mod record;
mod shared_model;
pub(crate) mod triangle_hold;
mod vector_autoregression;

pub use frequency_band::FrequencyBand;
pub use hold::Hold;
pub use measurement::{Measurement, Offsets, Trend};
pub use noise_model::NoiseModel;
pub use noise_spectrum::NoiseSpectrum;
pub use record::{Channel, Record};
pub use shared_model::SharedModel;
pub use vector_autoregression::{AutoregressionOrder, VectorAutoregression};
