//! What is varied.

use serde::{Deserialize, Serialize};

/// How the controls move, for 180 s at 10 Hz. White motion, which no surface can follow, is left to
/// the study of noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Excitation {
    /// u(k+1) = 0.9 u(k) + white Gaussian noise, held between samples: a pilot who never rests,
    /// with his power where the modes are.
    Autoregressive,
    /// A 3-2-1-1 with steps of 0.7 s every 15 s, each to a random side: a test programme.
    Multisteps,
}

impl Excitation {
    pub(crate) const ALL: [Self; 2] = [Self::Autoregressive, Self::Multisteps];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Autoregressive => "AR(1), 0.9",
            Self::Multisteps => "3-2-1-1 every 15 s",
        }
    }
}

/// A kind of record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Kind {
    pub(crate) excitation: Excitation,
    /// Size of the gusts' motion in percent of that of the response to the controls.
    pub(crate) gust_percent: u32,
}
