use std::collections::BTreeSet;

use num_complex::Complex;
use reconstruct::SearchStatus;

use super::*;

/// One of each kind that the library has today.
fn all() -> Vec<ReconstructionDoubt> {
    let text = || "x".to_owned();
    let printed = [
        Doubt::NoSharedZero,
        Doubt::Noise { record: text(), output: text(), relative_residual: 1.0, level: 1.0 },
        Doubt::NothingAboveNoise { record: text(), output: text() },
        Doubt::RankDeficient { record: text(), output: text(), rank: 1, parameters: 2 },
        Doubt::IllConditioned { record: text(), output: text(), condition: 1.0, limit: 1.0 },
        Doubt::Spread { eigenvalue: Complex::default(), relative: 1.0 },
    ];
    let subspace = [
        SubspaceDoubt::WeakOrder { order: 1, gap: 1.0 },
        SubspaceDoubt::ContestedOrder { order: 1, gap: 1.0, other: 2, other_gap: 2.0 },
        SubspaceDoubt::SeveralExcitations { record: text(), rank: 2, growth: 2.0 },
        SubspaceDoubt::NoExcitation { record: text() },
        SubspaceDoubt::NoiseNotWhite { record: text(), largest: 1.0, edge: 1.0 },
        SubspaceDoubt::SameExcitation { first: text(), second: text(), common: 9, expected: 4 },
        SubspaceDoubt::HardlyExcited { pole: Complex::default(), record: text(), strength: 1.0 },
        SubspaceDoubt::UncertainDirection { record: text(), ambiguity: 1.0 },
        SubspaceDoubt::NoiseNotConverged { rounds: 1 },
        SubspaceDoubt::IllConditioned { condition: 1.0 },
    ];
    let of_likelihood = [
        ReconstructionDoubt::OptimumNotReached {
            status: SearchStatus::Converged,
            remaining_step: 1.0,
        },
        ReconstructionDoubt::LevelsNotSettled { updates: 1 },
        ReconstructionDoubt::PoorFit { per_degree_of_freedom: 1.0, probability: 1.0 },
        ReconstructionDoubt::UnequalFit {
            record: text(),
            per_degree_of_freedom: 1.0,
            deviations: 1.0,
        },
        ReconstructionDoubt::ResidualsNotWhite { record: text(), p_value: 1.0 },
        ReconstructionDoubt::LevelsDisagree { sensor: text(), subspace: 1.0, likelihood: 1.0 },
        ReconstructionDoubt::AnotherSystem { likelihood_ratio: 1.0, eigenvalues: Vec::new() },
        ReconstructionDoubt::TooShort { degrees_of_freedom: 1.0, parameters: 1 },
        ReconstructionDoubt::Undetermined { determined: 1, identifiable: 2 },
    ];
    let printed = printed.into_iter().map(ReconstructionDoubt::Printed);
    let subspace = subspace.into_iter().map(ReconstructionDoubt::Subspace);
    printed.chain(subspace).chain(of_likelihood).collect()
}

#[test]
fn every_doubt_has_a_code_of_its_own_that_the_documents_list() {
    let schema = include_str!("../../../../docs/identify.schema.json");
    let document = include_str!("../../../../docs/program.md");
    let all = all();
    let codes: BTreeSet<_> = all.iter().map(code).collect();
    assert_eq!(codes.len(), all.len());
    for code in codes {
        assert_ne!(code, "other");
        assert!(schema.contains(&format!("\"{code}\"")), "{code} is missing in the schema");
        assert!(document.contains(&format!("`{code}`")), "{code} is missing in docs/program.md");
    }
}
