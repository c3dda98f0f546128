//! The names of the lateral modes, and why a mode has none.

use std::fmt;

/// The name of a lateral mode.
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
    /// Another mode fits the name better, and nothing else fits this one.
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
            Self::Unnamed(_) => "unnamed",
        })
    }
}
