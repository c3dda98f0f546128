//! What is varied: the excitation, the signal to noise ratio, the seed.

use serde::{Deserialize, Serialize};

/// How the surface moves. Every record is of the paper's aircraft, sampled at 10 Hz.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Excitation {
    /// White Gaussian noise, held between samples.
    White,
    /// u(k+1) = 0.9 u(k) + white Gaussian noise, held between samples.
    Autoregressive,
    /// Gaussian noise below 1 Hz that moves on between samples.
    BandLimited,
    /// Steps of 3, 2, 1 and 1 times 0.7 s to alternating sides, the same in every record.
    Multistep,
}

impl Excitation {
    pub(crate) const ALL: [Self; 4] =
        [Self::White, Self::Autoregressive, Self::BandLimited, Self::Multistep];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::White => "white",
            Self::Autoregressive => "AR(1), 0.9",
            Self::BandLimited => "band-limited",
            Self::Multistep => "3-2-1-1",
        }
    }

    /// Samples of each record: 200 s, or 30 s of a multistep.
    pub(crate) fn samples(self) -> usize {
        match self {
            Self::White | Self::Autoregressive | Self::BandLimited => 2000,
            Self::Multistep => 300,
        }
    }
}

/// Root mean square of each sensor's signal over that of its noise, see [`Pair`](super::flights::Pair).
pub(crate) const SIGNAL_TO_NOISE: [u32; 4] = [1000, 100, 30, 10];

/// One pair of records. Ordered by excitation, from little noise to much, by seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Case {
    pub(crate) excitation: Excitation,
    pub(crate) signal_to_noise: u32,
    pub(crate) seed: u64,
}

impl Case {
    fn place(&self) -> (Excitation, std::cmp::Reverse<u32>, u64) {
        (self.excitation, std::cmp::Reverse(self.signal_to_noise), self.seed)
    }
}

impl PartialOrd for Case {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Case {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.place().cmp(&other.place())
    }
}

/// All cases with seeds from 1 on. Seeds vary slowest, so that a study that was stopped has seen every kind of record.
pub(crate) fn cases(seeds: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for seed in 1..=seeds {
        for excitation in Excitation::ALL {
            let levels = SIGNAL_TO_NOISE.into_iter();
            cases.extend(levels.map(|signal_to_noise| Case { excitation, signal_to_noise, seed }));
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
        assert_eq!(all.len(), 3 * 4 * 4);
        assert!(all[..16].iter().all(|case| case.seed == 1));
        all.sort();
        all.dedup();
        assert_eq!(all.len(), 48);
        let case =
            |signal_to_noise, seed| Case { excitation: Excitation::White, signal_to_noise, seed };
        assert_eq!(all[..4], [case(1000, 1), case(1000, 2), case(1000, 3), case(100, 1)]);
    }
}
