//! Why an intersection of signal subspaces should not be trusted.

use nalgebra::DMatrix;
use num_complex::Complex;

use super::dense::{Eigen, eigenvalues};
use super::limits::Setting;
use super::order::{OrderEvidence, WEAK_GAP};
use super::{Mode, NoiseEvidence, NoiseOrigin, RecordEvidence};
use crate::ReconstructError;

/// A reason to doubt an [`Intersection`](super::Intersection). Each can be printed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The eigenvalues show no gap behind the order.
    WeakOrder {
        /// The order used.
        order: usize,
        /// The ratio of the eigenvalues after and before it.
        gap: f64,
    },
    /// Another order has the larger gap.
    ContestedOrder {
        /// The order used.
        order: usize,
        /// Its gap.
        gap: f64,
        /// The other order.
        other: usize,
        /// Its gap.
        other_gap: f64,
    },
    /// More than one independent excitation in a record.
    SeveralExcitations {
        /// The record.
        record: String,
        /// How many are seen.
        rank: usize,
        /// The growth of the signal's rank for each block row.
        growth: f64,
    },
    /// Free motion, or motion hidden by noise: the record shows no excitation.
    NoExcitation {
        /// The record.
        record: String,
    },
    /// Noise directions with more variance than white noise of these levels has.
    NoiseNotWhite {
        /// The record.
        record: String,
        /// The largest eigenvalue among them, in units of the noise's variance.
        largest: f64,
        /// What it may be by chance.
        edge: f64,
    },
    /// Two records have far more directions in common than the states.
    SameExcitation {
        /// The first record.
        first: String,
        /// The second record.
        second: String,
        /// How many directions they have in common.
        common: usize,
        /// How many they may have.
        expected: usize,
    },
    /// A mode of which a record shows next to nothing.
    HardlyExcited {
        /// The mode's eigenvalue in the z plane.
        pole: Complex<f64>,
        /// The record.
        record: String,
        /// The variance along the mode that nothing else explains, in units of the noise's variance: 1 is noise.
        strength: f64,
    },
    /// The direction of a record's excitation is hardly determined: do not start anything from it.
    UncertainDirection {
        /// The record.
        record: String,
        /// How well the next direction fits in comparison: 1 is equally well.
        ambiguity: f64,
    },
    /// The noise levels did not settle.
    NoiseNotConverged {
        /// The rounds made.
        rounds: usize,
    },
    /// Block rows that hardly tell the states apart.
    IllConditioned {
        /// Condition number of the observability matrix.
        condition: f64,
    },
}

/// Above this, the next direction of excitation fits nearly as well.
const AMBIGUOUS: f64 = 0.7;

/// Variance along a mode, in units of the noise's, below which a record shows next to nothing of it.
const HARDLY: f64 = 6.0;

/// Above this, half of the digits of A are lost.
const LARGEST_CONDITION: f64 = 1e8;

impl Doubt {
    /// A short name for programs, which stays what it is; the program's documentation lists all of them.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::WeakOrder { .. } => "weak-order",
            Self::ContestedOrder { .. } => "contested-order",
            Self::SeveralExcitations { .. } => "several-excitations",
            Self::NoExcitation { .. } => "no-excitation",
            Self::NoiseNotWhite { .. } => "noise-not-white",
            Self::SameExcitation { .. } => "same-excitation",
            Self::HardlyExcited { .. } => "hardly-excited",
            Self::UncertainDirection { .. } => "uncertain-direction",
            Self::NoiseNotConverged { .. } => "noise-not-converged",
            Self::IllConditioned { .. } => "observability-ill-conditioned",
        }
    }
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::WeakOrder { order, gap } => write!(
                f,
                "the order {order} is weakly supported: the next eigenvalue is {gap:.1} times larger, at least {WEAK_GAP} would be evidence"
            ),
            Self::ContestedOrder { order, gap, other, other_gap } => write!(
                f,
                "the order {order} has a gap of {gap:.1}, but {other} has one of {other_gap:.1}: records may show that many modes only"
            ),
            Self::SeveralExcitations { record, rank, growth } => write!(
                f,
                "record {record}: the signal's rank grows by {growth:.2} for each block row, so that at least {rank} independent excitations \
                 act; one is assumed"
            ),
            Self::NoExcitation { record } => write!(
                f,
                "record {record}: the signal's rank does not grow with the block rows: nothing but free motion is seen above the noise"
            ),
            Self::NoiseNotWhite { record, largest, edge } => write!(
                f,
                "record {record}: what should be white noise has a variance of {largest:.2} in some direction, up to {edge:.2} would be chance: \
                 disturbances, more excitations, another noise level or too low an order"
            ),
            Self::SameExcitation { first, second, common, expected } => write!(
                f,
                "records {first} and {second} have {common} directions in common, {expected} would be expected: they were excited in the \
                 same way, so that states and excitation cannot be told apart"
            ),
            Self::HardlyExcited { pole, record, strength } => write!(
                f,
                "record {record} shows next to nothing of the mode at z = {:.4} {} {:.4}i: {strength:.2} of the noise's variance",
                pole.re,
                if pole.im < 0.0 { '-' } else { '+' },
                pole.im.abs()
            ),
            Self::UncertainDirection { record, ambiguity } => write!(
                f,
                "record {record}: the direction of its excitation is hardly determined, another one fits {:.0} % as well",
                100.0 * ambiguity
            ),
            Self::NoiseNotConverged { rounds } => {
                write!(f, "the noise levels did not settle in {rounds} rounds")
            }
            Self::IllConditioned { condition } => write!(
                f,
                "the observability matrix has condition number {condition:.1e}: more block rows or a lower order are needed"
            ),
        }
    }
}

/// What a doubt may come from.
pub(super) struct Findings<'a> {
    pub(super) order: &'a OrderEvidence,
    pub(super) noise: &'a NoiseEvidence,
    pub(super) records: &'a [RecordEvidence],
    pub(super) modes: &'a [Mode],
    pub(super) condition: f64,
}

/// All doubts but that of equal excitations.
pub(super) fn doubts(findings: &Findings<'_>) -> Vec<Doubt> {
    let mut doubts = Vec::new();
    let OrderEvidence { order, gap, gaps, .. } = findings.order;
    if *gap < WEAK_GAP {
        doubts.push(Doubt::WeakOrder { order: *order, gap: *gap });
    }
    let largest = gaps.iter().max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some(&(other, other_gap)) = largest
        && other != *order
        && other_gap > *gap
    {
        doubts.push(Doubt::ContestedOrder { order: *order, gap: *gap, other, other_gap });
    }
    if let NoiseOrigin::Estimated { rounds, converged: false } = findings.noise.origin {
        doubts.push(Doubt::NoiseNotConverged { rounds });
    }
    for found in findings.records {
        let (record, excitation) = (&found.record, &found.excitation);
        let (rank, growth) = (excitation.rank, excitation.growth);
        match rank {
            0 => doubts.push(Doubt::NoExcitation { record: record.clone() }),
            1 => {}
            _ => doubts.push(Doubt::SeveralExcitations { record: record.clone(), rank, growth }),
        }
        if excitation.largest_noise > excitation.noise_edge {
            let (largest, edge) = (excitation.largest_noise, excitation.noise_edge);
            doubts.push(Doubt::NoiseNotWhite { record: record.clone(), largest, edge });
        }
        if found.ambiguity > AMBIGUOUS {
            let ambiguity = found.ambiguity;
            doubts.push(Doubt::UncertainDirection { record: record.clone(), ambiguity });
        }
    }
    for mode in findings.modes.iter().filter(|mode| mode.pole.im >= 0.0) {
        for (found, &strength) in findings.records.iter().zip(&mode.excitation_snr) {
            if strength < HARDLY {
                let record = found.record.clone();
                doubts.push(Doubt::HardlyExcited { pole: mode.pole, record, strength });
            }
        }
    }
    if findings.condition > LARGEST_CONDITION {
        doubts.push(Doubt::IllConditioned { condition: findings.condition });
    }
    doubts
}

/// Pairs of records whose signal spaces meet in more directions than the states account for.
///
/// With equal directions of excitation all of `T_L(b)` is common, n + L - 1 directions. Different ones meet in n, or in as many as the
/// dimensions force them to, 2 (n + L - 1) - m L.
pub(super) fn same_excitation(
    setting: Setting<'_>,
    spectra: &[Eigen],
    evidence: &OrderEvidence,
    block_rows: usize,
) -> Result<Vec<Doubt>, ReconstructError> {
    /// An eigenvalue of the sum of two projectors is 1 - cos of the angle between the spaces: this is 8 degrees.
    const COMMON: f64 = 0.01;
    /// So many further directions can be common by chance, where excitations have little power beyond low frequencies.
    const CHANCE: usize = 3;
    /// A gap as noise does not leave among the directions of equal excitations.
    const TOLD_APART: f64 = 100.0;
    if spectra.len() == 2 && evidence.gap >= TOLD_APART {
        return Ok(Vec::new());
    }
    let (rows, order) = (block_rows * setting.sensors, evidence.order);
    let signal = setting.signal_dimension(block_rows, order, 1);
    let expected = order.max((2 * signal).saturating_sub(rows));
    let enough = expected + CHANCE.max(block_rows / 8);
    let mut doubts = Vec::new();
    for (first, second) in (0..spectra.len()).flat_map(|b| (0..b).map(move |a| (a, b))) {
        let mut sum = DMatrix::zeros(rows, rows);
        for spectrum in [&spectra[first], &spectra[second]] {
            let directions = spectrum.vectors.columns(0, rows - signal);
            sum.gemm(1.0, &directions, &directions.transpose(), 1.0);
        }
        let values = eigenvalues(&sum)?;
        let common = values.iter().filter(|value| **value < COMMON).count();
        // Nearly equal directions that records of little noise still tell apart leave a gap behind those that have to be common.
        let gap = values[expected] / values[expected - 1].max(f64::EPSILON);
        if common >= enough && gap < TOLD_APART {
            let name = |record: usize| setting.records[record].name().to_owned();
            let (first, second) = (name(first), name(second));
            doubts.push(Doubt::SameExcitation { first, second, common, expected });
        }
    }
    Ok(doubts)
}

#[cfg(test)]
mod tests;
