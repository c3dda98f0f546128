//! The names of the lateral modes, and why a mode has none.

use std::fmt;

/// The name of a lateral mode, or what is to be said of a mode of another system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ModeName {
    /// Real, fast: the roll rate settles.
    RollSubsidence,
    /// Real, slow: a coordinated turn tightens or opens. Often unstable.
    Spiral,
    /// Oscillation of sideslip against heading, the flight path almost straight.
    DutchRoll,
    /// Roll subsidence and spiral merged into a slow oscillation of bank angle and flight path, the lateral phugoid.
    CoupledRollSpiral,
    /// One of two real roots into which the Dutch roll has split: sideslip against heading without oscillation.
    DutchRollRealRoot,
    /// A complex pair of a system that is no aircraft.
    Oscillatory,
    /// A real mode of a system that is no aircraft.
    Real,
    /// A real mode that hardly changes, of a system that is no aircraft.
    Integrator,
    /// No name, and why.
    Unnamed(WhyUnnamed),
}

/// Why a mode has no name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum WhyUnnamed {
    /// Eigenvalues alone tell only a complete set apart: a pair and two real ones, or two pairs.
    IncompleteSet {
        /// Real eigenvalues found.
        real: usize,
        /// Complex pairs found.
        pairs: usize,
    },
    /// Two eigenvalues are equal, and nothing else tells their modes apart.
    EqualEigenvalues,
    /// Other modes fit the names better, or none fits this one: a filter, an actuator, an integrator, noise.
    BetterClaim,
    /// The eigenvector has neither sideslip, roll, yaw nor bank.
    NoLateralMotion,
    /// Its sampled eigenvalue is real and negative, so that it alternates from sample to sample, as no motion of an aircraft does.
    Alternating,
}

impl fmt::Display for ModeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::RollSubsidence => "roll subsidence",
            Self::Spiral => "spiral",
            Self::DutchRoll => "Dutch roll",
            Self::CoupledRollSpiral => "coupled roll-spiral",
            Self::DutchRollRealRoot => "Dutch roll, real root",
            Self::Oscillatory => "oscillatory",
            Self::Real => "real",
            Self::Integrator => "integrator",
            Self::Unnamed(_) => "unnamed",
        })
    }
}
