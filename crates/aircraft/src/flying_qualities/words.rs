//! Classes, categories and levels as people write them.

use std::fmt;
use std::str::FromStr;

use super::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel};

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
