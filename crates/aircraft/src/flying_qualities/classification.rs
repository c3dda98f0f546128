//! Classes of aircraft, categories of flight phases and levels: what the standard tells apart, and the words for it.

use std::fmt;
use std::str::FromStr;

/// Size and manoeuvrability of an aircraft (MIL-F-8785C, paragraph 1.3).
///
/// Class II is told apart where the tables do so, in Category C: by land and by carrier. [`AircraftClass`] is read from and shown as
/// `I`, `II-L`, `II-C`, `III` and `IV`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AircraftClass {
    /// Small and light: utility, primary trainer, observation.
    I,
    /// Medium weight, low to medium manoeuvrability, operated from land: transport, tanker, reconnaissance.
    #[doc(alias = "II-L")]
    IILand,
    /// The same, operated from a carrier.
    #[doc(alias = "II-C")]
    IICarrier,
    /// Large and heavy, low to medium manoeuvrability: heavy transport, bomber, patrol.
    III,
    /// Highly manoeuvrable: fighter, attack.
    IV,
}

/// What is being flown (MIL-F-8785C, paragraph 1.4). Read from and shown as `A-CO`, `A`, `B` and `C`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FlightPhaseCategory {
    /// Category A, air-to-air combat (CO) or ground attack (GA): Table VI asks more damping of Class IV there.
    #[doc(alias("CO", "GA"))]
    ACombat,
    /// Rapid manoeuvring, precise tracking or precise control of the flight path, other than CO and GA.
    A,
    /// Gradual manoeuvres without precise tracking: climb, cruise, loiter, descent.
    B,
    /// Terminal: takeoff, approach, landing.
    C,
}

/// How well an aircraft suits its mission (MIL-F-8785C, paragraph 1.5); the better level is the smaller one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FlyingQualityLevel {
    /// Clearly adequate.
    One,
    /// Adequate, with more work for the pilot or a less effective mission.
    Two,
    /// Safe to control, but with too much work or too little effect.
    Three,
    /// The limits of Level 3 are not met.
    Worse,
}

/// A word that names no class or category of MIL-F-8785C.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{found:?} is no {kind}; there are {known}")]
pub struct UnknownWord {
    found: String,
    kind: &'static str,
    known: &'static str,
}

impl AircraftClass {
    /// All classes, in the order of the standard.
    pub const ALL: [Self; 5] = [Self::I, Self::IILand, Self::IICarrier, Self::III, Self::IV];
}

impl FlightPhaseCategory {
    /// All categories, the most demanding first.
    pub const ALL: [Self; 4] = [Self::ACombat, Self::A, Self::B, Self::C];
}

impl fmt::Display for AircraftClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::I => "I",
            Self::IILand => "II-L",
            Self::IICarrier => "II-C",
            Self::III => "III",
            Self::IV => "IV",
        })
    }
}

impl fmt::Display for FlightPhaseCategory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::ACombat => "A-CO",
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
        })
    }
}

impl fmt::Display for FlyingQualityLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::One => "1",
            Self::Two => "2",
            Self::Three => "3",
            Self::Worse => "worse than 3",
        })
    }
}

impl FromStr for AircraftClass {
    type Err = UnknownWord;

    /// Reads what [`Display`](fmt::Display) writes, in capitals or not.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        one_of(&Self::ALL, word).ok_or_else(|| UnknownWord {
            found: word.to_owned(),
            kind: "class of aircraft",
            known: "I, II-L, II-C, III and IV",
        })
    }
}

impl FromStr for FlightPhaseCategory {
    type Err = UnknownWord;

    /// Reads what [`Display`](fmt::Display) writes, in capitals or not.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        one_of(&Self::ALL, word).ok_or_else(|| UnknownWord {
            found: word.to_owned(),
            kind: "category of flight phases",
            known: "A-CO, A, B and C",
        })
    }
}

fn one_of<T: Copy + fmt::Display>(all: &[T], word: &str) -> Option<T> {
    all.iter().copied().find(|known| known.to_string().eq_ignore_ascii_case(word.trim()))
}
