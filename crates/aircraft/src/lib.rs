//! Lateral aircraft dynamics: the linear model from stability derivatives, a catalog, and the names of the modes.
//!
//! # What is here
//!
//! | item | what it does |
//! |---|---|
//! | [`LateralDerivatives`], [`Inertia`] | the numbers of an aircraft, units in the names |
//! | [`LateralModel`] | checked numbers to `A`, `B` and a [`lti::StateSpace`] |
//! | [`catalog`] | aircraft with their sources |
//! | [`name_system_modes`], [`name_modes`], [`name_eigenvalues`] | roll subsidence, spiral, Dutch roll and what becomes of them |
//! | [`name_neutrally`] | oscillatory, real, integrator, for a system that is no aircraft |
//! | [`level`] | how good the modes are to fly, after MIL-F-8785C |
//!
//! Conventions: states are sideslip, roll rate, yaw rate and bank angle, in that order; angles in radians, time in seconds,
//! lengths in feet. The crate knows nothing of how a model was found.
//!
//! # Example
//!
//! ```
//! use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog, name_system_modes};
//!
//! let entry = catalog::PAPER_AIRCRAFT;
//! let model = LateralModel::new(entry.derivatives, entry.inertia)?;
//! let system = model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL)?;
//! let mut names: Vec<String> = name_system_modes(&system)?.iter().map(|mode| mode.name.to_string()).collect();
//! names.sort();
//! assert_eq!(names, ["Dutch roll", "roll subsidence", "spiral"]);
//! # Ok::<(), aircraft::AircraftError>(())
//! ```
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "tests compare with exact values where they use ==")
)]

mod agreement;
mod assignment;
pub mod catalog;
mod coefficients;
mod derivatives;
mod error;
mod flying_qualities;
mod lateral;
mod mode_name;
mod naming;
mod shape;

pub use coefficients::{By, Geometry, nondimensional};
pub use derivatives::{Inertia, LateralDerivatives};
pub use error::AircraftError;
pub use flying_qualities::{
    AircraftClass, FlightPhaseCategory, FlyingQualityLevel, UnknownWord, level,
};
pub use lateral::{LateralModel, LateralState, SideForceScaling, Surface};
pub use mode_name::{ModeName, WhyUnnamed};
pub use naming::{
    Eigenpair, Evidence, NamedMode, name_eigenvalues, name_modes, name_neutrally, name_system_modes,
};
pub use shape::ModeShape;
