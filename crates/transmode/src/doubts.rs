//! Stable short names of the reasons not to trust a result, for other programs.

use reconstruct::{Doubt, ReconstructionDoubt, SubspaceDoubt};

/// The short name of a doubt. It stays what it is; docs/program.md lists them all.
pub(crate) fn code(doubt: &ReconstructionDoubt) -> &'static str {
    match doubt {
        ReconstructionDoubt::Printed(doubt) => of_printed(doubt),
        ReconstructionDoubt::Subspace(doubt) => of_subspace(doubt),
        ReconstructionDoubt::OptimumNotReached { .. } => "optimum-not-reached",
        ReconstructionDoubt::LevelsNotSettled { .. } => "levels-not-settled",
        ReconstructionDoubt::PoorFit { .. } => "poor-fit",
        ReconstructionDoubt::UnequalFit { .. } => "unequal-fit",
        ReconstructionDoubt::ResidualsNotWhite { .. } => "residuals-not-white",
        ReconstructionDoubt::LevelsDisagree { .. } => "levels-disagree",
        ReconstructionDoubt::AnotherSystem { .. } => "another-system",
        ReconstructionDoubt::TooShort { .. } => "too-short",
        ReconstructionDoubt::Undetermined { .. } => "undetermined",
        _ => "other",
    }
}

fn of_printed(doubt: &Doubt) -> &'static str {
    match doubt {
        Doubt::NoSharedZero => "no-shared-zero",
        Doubt::Noise { .. } => "noise",
        Doubt::NothingAboveNoise { .. } => "nothing-above-noise",
        Doubt::RankDeficient { .. } => "rank-deficient",
        Doubt::IllConditioned { .. } => "ill-conditioned",
        Doubt::Spread { .. } => "spread",
        _ => "other",
    }
}

fn of_subspace(doubt: &SubspaceDoubt) -> &'static str {
    match doubt {
        SubspaceDoubt::WeakOrder { .. } => "weak-order",
        SubspaceDoubt::ContestedOrder { .. } => "contested-order",
        SubspaceDoubt::SeveralExcitations { .. } => "several-excitations",
        SubspaceDoubt::NoExcitation { .. } => "no-excitation",
        SubspaceDoubt::NoiseNotWhite { .. } => "noise-not-white",
        SubspaceDoubt::SameExcitation { .. } => "same-excitation",
        SubspaceDoubt::HardlyExcited { .. } => "hardly-excited",
        SubspaceDoubt::UncertainDirection { .. } => "uncertain-direction",
        SubspaceDoubt::NoiseNotConverged { .. } => "noise-not-converged",
        SubspaceDoubt::IllConditioned { .. } => "observability-ill-conditioned",
        _ => "other",
    }
}

#[cfg(test)]
mod tests;
