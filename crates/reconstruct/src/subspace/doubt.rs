//! Why an intersection of signal subspaces should not be trusted.

use num_complex::Complex;

use super::order::WEAK_GAP;

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
        excitation_snr: f64,
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
            Self::HardlyExcited { pole, record, excitation_snr } => write!(
                f,
                "record {record} shows next to nothing of the mode at z = {:.4} {} {:.4}i: {excitation_snr:.2} of the noise's variance",
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
