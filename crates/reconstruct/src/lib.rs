//! Reconstruction of a system from sensor records alone, through pairs of transmissibilities.
//!
//! # What is here
//!
//! | item | what it does |
//! |---|---|
//! | [`reconstruct`] | records to modes with confidence and doubts: the entry point to all methods |
//! | [`Record`] | sensor signals of one system under one unknown excitation |
//! | [`TransmissibilityPair`], [`Theorem`], [`containment`] | Theorem 3.1, exact over integers and rationals |
//! | [`identify`] | one rational transmissibility from one record |
//! | [`difference_zeros`] | where the transmissibilities of two records agree |
//! | [`shared_zeros`] | the zeros that several differences of transmissibilities have in common |
//! | [`as_printed`] | the whole method: records to eigenvalues |
//! | [`intersect`] | eigenvalues, shapes and excitations of noisy records, by the intersection of their signal subspaces |
//! | [`maximise`] | maximum likelihood from noisy records: the system, its modes and how certain they are |
//! | [`profile_intervals`] | intervals of real modes that need not be symmetric, for short or noisy records |
//! | [`bootstrap`] | deviations of the modes from repeated noise, as a cross-check |
//! | [`fitted_transmissibilities`] | response, zeros and poles of every pair of sensors as fitted, with their uncertainty |
//! | [`spectral_fits`] | response, noise and residuals of every record at each frequency |
//! | [`SharedModel`], [`NoiseModel`] | what records have in common, and what is known about their noise |
//! | [`VectorAutoregression`], [`NoiseSpectrum`] | the disturbance's spectrum from a quiet record |
//!
//! Each stage can be called by itself. Results carry ranks, residuals, condition numbers and spreads; what makes a result
//! untrustworthy is in its [`Doubt`]s.
//!
//! # Example
//!
//! Two transmissibilities of one system disagree everywhere but at its eigenvalues, here -1 and -2:
//!
//! ```
//! use lti::Transmissibility;
//! use poly::Poly;
//! use reconstruct::TransmissibilityPair;
//!
//! let p = |descending: &[i64]| Poly::from_descending(descending);
//! let first = Transmissibility::from_polynomials(p(&[1, 1]), p(&[1, 2]))?;
//! let second = Transmissibility::from_polynomials(p(&[-1, -1]), p(&[1, 2]))?;
//! let determinant = TransmissibilityPair::new(first, second).determinant();
//! assert_eq!((determinant.eval(&-1), determinant.eval(&-2), determinant.eval(&0)), (0, 0, -4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod as_printed;
mod difference;
mod error;
mod fitted_transmissibility;
mod identification;
mod likelihood;
mod matching;
mod noise_model;
mod noise_spectrum;
mod pair;
mod reconstruction;
mod record;
mod shared;
mod shared_model;
mod subspace;
mod vector_autoregression;

pub use as_printed::{
    AsPrinted, AsPrintedOptions, Difference, Doubt, ReconstructedMode, as_printed,
};
pub use difference::{Zero, difference_zeros};
pub use error::ReconstructError;
pub use fitted_transmissibility::{FittedTransmissibility, fitted_transmissibilities};
pub use identification::{Identification, IdentificationOptions, identify};
pub use likelihood::{
    Bootstrap, BootstrapMode, ChiSquared, ComplexEstimate, Directions, Ellipse, Estimate,
    FrequencyBand, Hold, LikelihoodFit, LikelihoodNoise, LikelihoodOptions, ModeEstimate,
    OffsetTest, Offsets, Rival, SearchReport, SearchStatus, SensorSpectrum, SpectralFit,
    StartReport, Trend, Whiteness, bootstrap, maximise, profile_intervals,
};
pub use noise_model::NoiseModel;
pub use noise_spectrum::NoiseSpectrum;
pub use pair::{Containment, Statement, Theorem, TransmissibilityPair, containment};
pub use reconstruction::{
    ComparedOrder, FoundMode, Method, Options, Reconstruction, ReconstructionDoubt, reconstruct,
    spectral_fits,
};
pub use record::{Channel, Record};
pub use shared::{SharedZero, SharedZeros, shared_zeros};
pub use shared_model::SharedModel;
pub use subspace::{
    Centring, DirectPath, ExcitationRank, Intersection, NoiseEvidence, NoiseOrigin, OrderChoice,
    OrderEvidence, RecordEvidence, SubspaceDoubt, SubspaceMode, SubspaceOptions, intersect,
};
pub use vector_autoregression::{AutoregressionOrder, VectorAutoregression};

/// The README's example compiles.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
