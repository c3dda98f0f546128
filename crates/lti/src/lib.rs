//! Linear time-invariant systems: state space in continuous and discrete time, responses, poles, zeros, modes and
//! transmissibilities.
//!
//! # What is here
//!
//! | item | what it is |
//! |---|---|
//! | [`StateSpace`] | a system A, B, C, D in [`Continuous`] or [`Discrete`] time; checked once, when it is built |
//! | [`SamplePeriod`], [`s_to_z`], [`z_to_s`] | sampling, and the map z = exp(s T) |
//! | `zoh`, `inverse_zoh` | the zero-order hold and the way back, by [`exponential`] and [`logarithm`] |
//! | `simulate`, `markov_parameters`, `frequency_response`, `evaluate` | responses |
//! | `poles`, `modes`, `invariant_zeros` | [`Pole`], [`Mode`] and [`InvariantZero`] with their condition numbers |
//! | `transfer_function`, [`resolvent_numerators`] | polynomials, exact over any ring |
//! | [`Transmissibility`], [`ExcitationPair`] | how one output follows from another, for one excitation and for two |
//! | `series`, `parallel`, `difference`, `feedback` | connections |
//!
//! # Conventions
//!
//! Frequencies and continuous-time eigenvalues are in rad/s, times in s. Inputs, outputs and states count from 0.
//! Lists of poles and zeros are sorted by real part, then by modulus of the imaginary part, positive imaginary part
//! first; conjugate pairs are exactly conjugate. Polynomials store the coefficient of the lowest power first.
//!
//! # Accuracy
//!
//! Scaling is by powers of two and costs nothing. Polynomial coefficients are computed in double-double arithmetic
//! and rounded once. Simple poles, zeros of square systems and frequency responses are refined with double-double
//! residuals; where they are well conditioned, they are correct to the last digit of what A, B, C, D say.
//! Condition numbers and residuals come with the results and say where that ends.
//!
//! # Example
//!
//! A mass on a spring, force in, position and velocity out. Whatever the force was, the velocity is p times the
//! position.
//!
//! ```
//! use lti::{Channels, Continuous, SamplePeriod, StateSpace, Transmissibility};
//! use nalgebra::{DMatrix, dmatrix};
//!
//! let system = StateSpace::<Continuous>::new(
//!     dmatrix![0.0, 1.0; -4.0, 0.0], // 4 1/s^2 of stiffness per mass, no damping
//!     dmatrix![0.0; 1.0],
//!     DMatrix::identity(2, 2),
//!     DMatrix::zeros(2, 1),
//! )?;
//! let mode = &system.modes()?[0];
//! assert_eq!((mode.natural_frequency_rad_s, mode.damping_ratio), (2.0, 0.0));
//!
//! let t = Transmissibility::between(&system, Channels { excitation: 0, from_output: 0, to_output: 1 })?;
//! assert_eq!(t.numerator().coefficients(), [0.0, 1.0]);
//! assert_eq!(t.denominator().coefficients(), [1.0]);
//!
//! let sampled = system.zoh(SamplePeriod::new(0.1)?)?;
//! assert!((sampled.poles()?[0].norm() - 1.0).abs() < 1e-15); // on the unit circle
//! # Ok::<(), lti::LtiError>(())
//! ```

mod complex_schur;
mod dense;
mod doubled_product;
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
pub use resolvent::{ResolventNumerators, resolvent_numerators};
pub use simulation::Simulation;
pub use state_space::StateSpace;
pub use time::{Continuous, Discrete, SamplePeriod, TimeDomain, s_to_z, z_to_s};
pub use transmissibility::{Channels, Transmissibility};
