//! Names of the lateral modes, from what moves and how fast.

use lti::{Continuous, StateSpace};
use num_complex::Complex;

use crate::assignment::Candidate;
use crate::shape::{Character, ModeShape};
use crate::{AircraftError, ModeName, assignment};

/// An eigenvalue in continuous time and, where it is known, its eigenvector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eigenpair {
    /// Eigenvalue, rad/s.
    pub eigenvalue: Complex<f64>,
    /// Components of the eigenvector.
    pub shape: Option<ModeShape>,
}

/// On what a name rests.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Evidence {
    /// On the eigenvector.
    Shape {
        /// `|lambda beta| / (|lambda beta| + |r + lambda beta|)`: 1 where the flight path stays straight while the nose
        /// swings, 0 where the aircraft turns without slipping.
        slip_fraction: f64,
        /// `|p| / (|p| + |r|)`: 1 for rolling without yawing, 0 for turning at a steady bank.
        roll_fraction: f64,
        /// `|phi| / |beta|`, if it is defined.
        bank_to_sideslip: Option<f64>,
        /// How well the shape agrees with the name, 0 to 1. At 1/2 and below the name rests on the other modes more than
        /// on this one. Zero where there is no name.
        agreement: f64,
    },
    /// On the pattern and the order of the eigenvalues alone.
    EigenvaluePattern,
    /// On nothing.
    None,
}

/// A mode with its name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NamedMode {
    /// The name.
    pub name: ModeName,
    /// Eigenvalue, rad/s; of a complex pair the one with the positive imaginary part.
    pub eigenvalue: Complex<f64>,
    /// What the name rests on.
    pub evidence: Evidence,
}

/// Names lateral modes by their eigenvectors and speeds, or by their eigenvalues where a vector is missing.
///
/// At most one mode gets each name; there may be more modes than names, since filters, actuators and integrators bring
/// their own. With `lambda` the eigenvalue,
///
/// ```text
/// s = |lambda beta| / (|lambda beta| + |r + lambda beta|)    nose swings about a straight path
/// t = |p| / (|p| + |r|)                                      rolls more than it yaws
/// b = 1 / (1 + (|beta / phi| / 0.2)^2)                       banks without slipping
/// k = |r + lambda beta| / |phi|                              turn rate per bank angle, about g/U0 (rad/s)
/// q = |lambda| / w                                           speed, w the frequency of the Dutch roll (rad/s)
/// ```
///
/// where `r + lambda beta` is the turn rate of the flight path, and `phi = p / lambda` unless it is given.
/// Agreement of a mode with a name, in shape and in speed:
///
/// | name | kind | shape | speed |
/// |---|---|---|---|
/// | Dutch roll | pair | `s` | `|Im(lambda)| / |lambda|` |
/// | coupled roll-spiral | pair | `1 - s` | `1 / (1 + q^2)` |
/// | roll subsidence | real | `b t` | `1 / (1 + ln(q / 0.8)^2)` |
/// | spiral | real | `b k / (k + 0.003)` | `1 / (1 + q / 0.3)` |
/// | Dutch roll, real root | real | `(1 - b) s` | any |
///
/// Every assignment has the product of its agreements: a Dutch roll, a roll subsidence and a spiral, with
///
/// - 0.1 if the spiral decays faster than the roll subsidence,
/// - 0.1 for each of the three that no mode bears (0.001 where the modes have four states together),
/// - a coupled roll-spiral in place of roll subsidence and spiral, times one minus what each real mode has as either,
/// - two real roots in place of a Dutch roll, where there is no pair at all.
///
/// The largest product wins, and what it leaves over is [`ModeName::Unnamed`]. Stability plays no part but in the
/// order of roll subsidence and spiral: an unstable spiral is a spiral. If any shape is missing, all names come
/// from [`name_eigenvalues`].
///
/// A pair may be given by both members or by one. Modes come in the order in which they are given.
///
/// # Errors
///
/// An eigenvalue or a component that is not finite.
///
/// # Example
///
/// Two real modes of the same speed: one rolls, the other turns.
///
/// ```
/// use aircraft::{Eigenpair, ModeName, ModeShape, name_modes};
/// use num_complex::Complex;
///
/// let real = |value: f64| Complex::new(value, 0.0);
/// let rolling = ModeShape::from_sensors(real(0.0), real(1.0), real(0.1));
/// let turning = ModeShape::from_sensors(real(0.0), real(0.1), real(1.0));
/// let modes = name_modes(&[
///     Eigenpair { eigenvalue: real(-0.5), shape: Some(rolling) },
///     Eigenpair { eigenvalue: real(-0.5), shape: Some(turning) },
/// ])?;
/// assert_eq!([modes[0].name, modes[1].name], [ModeName::RollSubsidence, ModeName::Spiral]);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
pub fn name_modes(pairs: &[Eigenpair]) -> Result<Vec<NamedMode>, AircraftError> {
    for pair in pairs {
        check_finite("eigenvalue", pair.eigenvalue)?;
        if pair.shape.is_some_and(|shape| !shape.is_finite()) {
            return Err(AircraftError::NotFinite {
                name: "a component of the mode shape",
                value: f64::NAN,
            });
        }
    }
    let modes = one_of_each_pair(pairs);
    let shapes: Option<Vec<Option<Character>>> =
        modes.iter().map(|mode| mode.shape.map(|shape| shape.character(mode.eigenvalue))).collect();
    let Some(characters) = shapes else {
        return Ok(by_eigenvalue(&modes));
    };
    let candidates: Vec<Candidate> = modes
        .iter()
        .zip(&characters)
        .map(|(&Eigenpair { eigenvalue, .. }, &character)| Candidate {
            eigenvalue,
            oscillatory: is_oscillatory(eigenvalue),
            character,
        })
        .collect();
    let names = assignment::by_shape(&candidates);
    Ok(modes
        .iter()
        .zip(characters)
        .zip(names)
        .map(|((mode, character), (name, agreement))| NamedMode {
            name,
            eigenvalue: mode.eigenvalue,
            evidence: character.map_or(Evidence::None, |character| Evidence::Shape {
                slip_fraction: character.slip_fraction,
                roll_fraction: character.roll_fraction,
                bank_to_sideslip: character.bank_to_sideslip,
                agreement,
            }),
        })
        .collect())
}

/// Names lateral modes by their eigenvalues alone.
///
/// A pair and two real ones: the pair is the Dutch roll, the more negative real one the roll subsidence, the other the
/// spiral. Two pairs: the faster one (larger modulus) is the Dutch roll, the other the coupled roll-spiral.
/// No other set has names, nor have equal eigenvalues. The rule is a habit of aircraft, not a law: with eigenvectors at
/// hand use [`name_modes`].
///
/// # Errors
///
/// An eigenvalue that is not finite.
///
/// # Example
///
/// ```
/// use aircraft::name_eigenvalues;
/// use num_complex::Complex;
///
/// let found = [Complex::new(-0.07, 1.69), Complex::new(-0.07, -1.69), Complex::new(-0.0016, 0.0), Complex::new(-0.546, 0.0)];
/// let names: Vec<String> = name_eigenvalues(&found)?.iter().map(|mode| mode.name.to_string()).collect();
/// assert_eq!(names, ["Dutch roll", "spiral", "roll subsidence"]);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
pub fn name_eigenvalues(eigenvalues: &[Complex<f64>]) -> Result<Vec<NamedMode>, AircraftError> {
    let pairs: Vec<Eigenpair> =
        eigenvalues.iter().map(|&eigenvalue| Eigenpair { eigenvalue, shape: None }).collect();
    name_modes(&pairs)
}

/// Names the modes of a system that is no aircraft, by the kind of their eigenvalues.
///
/// | name | eigenvalue |
/// |---|---|
/// | oscillatory | complex pair |
/// | integrator | real, `|lambda| T <= 0.01`: it changes by one per cent at most in a record of `T` seconds |
/// | real | any other |
///
/// A pair may be given by both members or by one. Modes come in the order in which they are given.
///
/// # Errors
///
/// An eigenvalue that is not finite, a record that is not of positive length.
///
/// # Example
///
/// ```
/// use aircraft::name_neutrally;
/// use num_complex::Complex;
///
/// let found = [Complex::new(-0.07, 1.69), Complex::new(-1e-5, 0.0), Complex::new(-0.546, 0.0)];
/// let names: Vec<String> = name_neutrally(&found, 60.0)?.iter().map(|mode| mode.name.to_string()).collect();
/// assert_eq!(names, ["oscillatory", "integrator", "real"]);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
pub fn name_neutrally(
    eigenvalues: &[Complex<f64>],
    record_length_s: f64,
) -> Result<Vec<NamedMode>, AircraftError> {
    check_finite("record length", Complex::new(record_length_s, 0.0))?;
    if record_length_s <= 0.0 {
        return Err(AircraftError::NotPositive { name: "record length", value: record_length_s });
    }
    let mut modes = name_eigenvalues(eigenvalues)?;
    for mode in &mut modes {
        mode.name = if is_oscillatory(mode.eigenvalue) {
            ModeName::Oscillatory
        } else if mode.eigenvalue.norm() * record_length_s <= INTEGRATOR_CHANGE {
            ModeName::Integrator
        } else {
            ModeName::Real
        };
        mode.evidence = Evidence::EigenvaluePattern;
    }
    Ok(modes)
}

/// Relative change over a record that counts as none: less than noise of a hundredth shows.
const INTEGRATOR_CHANGE: f64 = 0.01;

/// Names the modes of a lateral model whose states are sideslip, roll rate, yaw rate and bank angle.
///
/// # Errors
///
/// Another number of states, or eigenvalues that could not be found.
///
/// # Example
///
/// ```
/// use aircraft::{LateralModel, LateralState, ModeName, SideForceScaling, Surface, catalog, name_system_modes};
///
/// let model = LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
/// let system = model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL)?;
/// let modes = name_system_modes(&system)?;
/// let dutch_roll = modes.iter().find(|mode| mode.name == ModeName::DutchRoll);
/// assert!(dutch_roll.is_some_and(|mode| (mode.eigenvalue.im - 1.6917).abs() < 1e-4));
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
pub fn name_system_modes(system: &StateSpace<Continuous>) -> Result<Vec<NamedMode>, AircraftError> {
    if system.order() != 4 {
        return Err(AircraftError::WrongOrder { found: system.order() });
    }
    let modes = system
        .modes()
        .map_err(|error| AircraftError::InvalidModel { reason: error.to_string() })?;
    let pairs: Vec<Eigenpair> = modes
        .iter()
        .map(|mode| {
            let shape =
                mode.eigenvector.as_ref().map(|v| ModeShape::from_state([v[0], v[1], v[2], v[3]]));
            Eigenpair { eigenvalue: mode.eigenvalue, shape }
        })
        .collect();
    name_modes(&pairs)
}

fn check_finite(name: &'static str, value: Complex<f64>) -> Result<(), AircraftError> {
    match [value.re, value.im].into_iter().find(|part| !part.is_finite()) {
        Some(value) => Err(AircraftError::NotFinite { name, value }),
        None => Ok(()),
    }
}

/// Relative size of an imaginary part that counts as rounding, and relative distance of two members of one pair.
/// Eigenvalues of real matrices come in exact pairs; those of an estimate may carry the rounding of a few operations.
const PAIR_TOLERANCE: f64 = 1e-8;

fn is_oscillatory(eigenvalue: Complex<f64>) -> bool {
    eigenvalue.im.abs() > PAIR_TOLERANCE * eigenvalue.norm()
}

/// Every real eigenvalue, and of every pair the member with the positive imaginary part.
fn one_of_each_pair(pairs: &[Eigenpair]) -> Vec<Eigenpair> {
    let lower = |pair: &&Eigenpair| is_oscillatory(pair.eigenvalue) && pair.eigenvalue.im < 0.0;
    let mut upper: Vec<Complex<f64>> = pairs
        .iter()
        .filter(|pair| is_oscillatory(pair.eigenvalue) && pair.eigenvalue.im > 0.0)
        .map(|pair| pair.eigenvalue)
        .collect();
    let mut kept = Vec::with_capacity(pairs.len());
    for pair in pairs {
        if !lower(&pair) {
            kept.push(*pair);
            continue;
        }
        let conjugate = pair.eigenvalue.conj();
        let partner = upper
            .iter()
            .position(|other| (other - conjugate).norm() <= PAIR_TOLERANCE * conjugate.norm());
        match partner {
            Some(index) => {
                upper.swap_remove(index);
            }
            None => kept.push(Eigenpair {
                eigenvalue: conjugate,
                shape: pair.shape.map(|shape| shape.conj()),
            }),
        }
    }
    kept
}

fn by_eigenvalue(modes: &[Eigenpair]) -> Vec<NamedMode> {
    let eigenvalues: Vec<Complex<f64>> = modes.iter().map(|mode| mode.eigenvalue).collect();
    let kinds: Vec<bool> =
        eigenvalues.iter().map(|&eigenvalue| is_oscillatory(eigenvalue)).collect();
    let names = assignment::by_eigenvalue(&kinds, &eigenvalues, PAIR_TOLERANCE);
    let evidence = |name| {
        if matches!(name, ModeName::Unnamed(_)) {
            Evidence::None
        } else {
            Evidence::EigenvaluePattern
        }
    };
    eigenvalues
        .into_iter()
        .zip(names)
        .map(|(eigenvalue, name)| NamedMode { name, eigenvalue, evidence: evidence(name) })
        .collect()
}

#[cfg(test)]
mod tests;
