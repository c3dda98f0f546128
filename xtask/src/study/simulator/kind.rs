//! What is varied: how the aircraft is moved and measured, and which one it is. Names are those of
//! the files.

use serde::{Deserialize, Serialize};

/// How a flight was moved and measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Motion {
    Clean,
    Large,
    Col05,
    Actlag10,
    Multistep,
    Noise,
    Bias,
    Quantised,
    Delay,
    Turb1,
    Turb2,
    Both,
}

impl Motion {
    /// In the order of the page.
    pub(crate) const ALL: [Self; 12] = [
        Self::Clean,
        Self::Large,
        Self::Col05,
        Self::Actlag10,
        Self::Multistep,
        Self::Noise,
        Self::Bias,
        Self::Quantised,
        Self::Delay,
        Self::Turb1,
        Self::Turb2,
        Self::Both,
    ];

    /// Flights that are reconstructed without what the surfaces did.
    pub(crate) const RECONSTRUCTED: &[Self] = Self::ALL.split_at(9).0;

    /// Flights whose surfaces were recorded.
    pub(crate) const RECORDED: [Self; 6] =
        [Self::Clean, Self::Noise, Self::Delay, Self::Turb1, Self::Turb2, Self::Both];

    /// As in the names of the files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Clean => "clean",
            Self::Large => "large",
            Self::Col05 => "col05",
            Self::Actlag10 => "actlag10",
            Self::Multistep => "multistep",
            Self::Noise => "noise",
            Self::Bias => "bias",
            Self::Quantised => "quantised",
            Self::Delay => "delay",
            Self::Turb1 => "turb1",
            Self::Turb2 => "turb2",
            Self::Both => "both",
        }
    }

    /// So short that nine stand side by side in a figure.
    pub(crate) fn short_name(self) -> &'static str {
        match self {
            Self::Actlag10 => "lag",
            Self::Multistep => "3-2-1-1",
            Self::Quantised => "12 bits",
            other => other.name(),
        }
    }

    /// In a few words.
    pub(crate) fn about(self) -> &'static str {
        match self {
            Self::Clean => "white motion of the surface, held between samples, small; no noise",
            Self::Large => "three times as large, visibly nonlinear; no noise",
            Self::Col05 => "small, low-passed at 0.5 Hz, held; no noise",
            Self::Actlag10 => {
                "small, behind an actuator of 10 rad/s, so that it moves on between samples; no noise"
            }
            Self::Multistep => "3-2-1-1 with steps of 1 s in 30 s, with noise",
            Self::Noise => "large, with white noise of 0.1 deg in beta and 0.05 deg/s in p and r",
            Self::Bias => "the same noise, offsets and a slow drift of every sensor",
            Self::Quantised => "large, read with 12 bits over wide ranges",
            Self::Delay => "large, with the same noise, beta late by 0.1 s",
            Self::Turb1 => "large, in turbulence; no noise",
            Self::Turb2 => "the same in other turbulence",
            Self::Both => {
                "large, with the same noise, both surfaces moved in one record, which is all there is"
            }
        }
    }
}

/// Which aircraft flies, in the order of the files' `truth.json`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Aircraft {
    #[serde(rename = "787-8")]
    Boeing787,
    #[serde(rename = "J3Cub")]
    Cub,
    #[serde(rename = "MD11")]
    Md11,
    #[serde(rename = "A4")]
    Skyhawk,
    Concorde,
    #[serde(rename = "737")]
    Boeing737,
}

impl Aircraft {
    pub(crate) const ALL: [Self; 6] =
        [Self::Boeing787, Self::Cub, Self::Md11, Self::Skyhawk, Self::Concorde, Self::Boeing737];

    /// As in the names of the files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Boeing787 => "787-8",
            Self::Cub => "J3Cub",
            Self::Md11 => "MD11",
            Self::Skyhawk => "A4",
            Self::Concorde => "Concorde",
            Self::Boeing737 => "737",
        }
    }
}

/// A pair of records: one moved through the aileron, one through the rudder; or one record of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Kind {
    pub(crate) motion: Motion,
    pub(crate) aircraft: Aircraft,
    /// Whether what the surfaces did is given.
    pub(crate) recorded: bool,
}

impl Kind {
    /// The heading of its section.
    pub(crate) fn title(self) -> &'static str {
        if !self.recorded {
            return self.motion.name();
        }
        match self.motion {
            Motion::Clean => "clean, inputs recorded",
            Motion::Noise => "noise, inputs recorded",
            Motion::Delay => "delay, inputs recorded",
            Motion::Turb1 => "turb1, inputs recorded",
            Motion::Turb2 => "turb2, inputs recorded",
            _ => "both, inputs recorded",
        }
    }
}
