//! What is varied: how the controls move, how strong the gusts are, the seed.

use serde::{Deserialize, Serialize};

/// How the controls move, for 180 s at 10 Hz. White motion, which no surface can follow, is left to the study of noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Excitation {
    /// u(k+1) = 0.9 u(k) + white Gaussian noise, held between samples: a pilot who never rests, with his power where the modes are.
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

/// Size of the gusts' motion in percent of that of the response to the controls.
pub(crate) const GUST_PERCENT: [u32; 4] = [0, 10, 30, 100];

/// One flight. Ordered by excitation, from still air to rough, by seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) struct Case {
    pub(crate) excitation: Excitation,
    pub(crate) gust_percent: u32,
    pub(crate) seed: u64,
}

/// All cases with seeds from 1 on.
pub(crate) fn cases(seeds: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for seed in 1..=seeds {
        for excitation in Excitation::ALL {
            let gusts = GUST_PERCENT.into_iter();
            cases.extend(gusts.map(|gust_percent| Case { excitation, gust_percent, seed }));
        }
    }
    cases
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_comes_with_every_seed() {
        let mut all = cases(3);
        assert!(all[..8].iter().all(|case| case.seed == 1));
        all.sort();
        all.dedup();
        assert_eq!(all.len(), 3 * 2 * 4);
        let still = |seed| Case { excitation: Excitation::Autoregressive, gust_percent: 0, seed };
        assert_eq!(all[..3], [still(1), still(2), still(3)]);
    }
}
