//! Linear time-invariant systems: state space in continuous and discrete time, responses, poles, zeros, modes and
//! transmissibilities.

mod complex_schur;
mod dense;
mod double_double;
mod eigen;
mod error;
mod excitation_pair;
mod exponential;
mod frequency_response;
mod interconnection;
mod invariant_zeros;
mod inverse_zoh;
mod logarithm;
mod magnitude;
mod modes;
mod poles;
mod resolvent;
mod rosenbrock;
mod scaling;
mod simulation;
mod state_space;
mod time;
mod transfer_function;
mod transmissibility;
mod zoh;

pub use error::LtiError;
pub use excitation_pair::{ExcitationPair, PairChannels};
pub use exponential::exponential;
pub use invariant_zeros::{InvariantZero, InvariantZeros, ZerosOptions};
pub use inverse_zoh::InverseZoh;
pub use logarithm::{Logarithm, logarithm};
pub use modes::{Mode, ModeKind};
pub use poles::Pole;
pub use resolvent::{ResolventNumerators, resolvent_numerator, resolvent_numerators};
pub use simulation::Simulation;
pub use state_space::StateSpace;
pub use time::{Continuous, Discrete, SamplePeriod, TimeDomain, s_to_z, z_to_s};
pub use transmissibility::{Channels, Transmissibility};
