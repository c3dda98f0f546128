//! Linear time-invariant systems: state space in continuous and discrete time, responses, poles, zeros, modes and
//! transmissibilities.
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "tests compare with exact values where they use ==")
)]

mod double_double;
mod eigen;
mod error;
mod exponential;
mod frequency_response;
mod interconnection;
mod inverse_zoh;
mod logarithm;
mod modes;
mod poles;
mod scaling;
mod simulation;
mod state_space;
mod time;
mod zoh;

pub use error::LtiError;
pub use exponential::exponential;
pub use inverse_zoh::InverseZoh;
pub use logarithm::{Logarithm, logarithm};
pub use modes::{Mode, ModeKind};
pub use poles::Pole;
pub use simulation::Simulation;
pub use state_space::StateSpace;
pub use time::{Continuous, Discrete, SamplePeriod, TimeDomain, s_to_z, z_to_s};
