use std::collections::BTreeSet;

use super::*;
use crate::likelihood::SearchStatus;

/// One of each kind that the library has today.
fn all() -> Vec<Doubt> {
    let text = || "x".to_owned();
    let printed = [
        paper::Doubt::NoSharedZero,
        paper::Doubt::Noise { record: text(), output: text(), relative_residual: 1.0, level: 1.0 },
        paper::Doubt::NothingAboveNoise { record: text(), output: text() },
        paper::Doubt::RankDeficient { record: text(), output: text(), rank: 1, parameters: 2 },
        paper::Doubt::IllConditioned { record: text(), output: text(), condition: 1.0, limit: 1.0 },
        paper::Doubt::Spread { eigenvalue: Complex::default(), relative: 1.0 },
    ];
    let subspace = [
        subspace::Doubt::WeakOrder { order: 1, gap: 1.0 },
        subspace::Doubt::ContestedOrder { order: 1, gap: 1.0, other: 2, other_gap: 2.0 },
        subspace::Doubt::SeveralExcitations { record: text(), rank: 2, growth: 2.0 },
        subspace::Doubt::NoExcitation { record: text() },
        subspace::Doubt::NoiseNotWhite { record: text(), largest: 1.0, edge: 1.0 },
        subspace::Doubt::SameExcitation { first: text(), second: text(), common: 9, expected: 4 },
        subspace::Doubt::HardlyExcited {
            pole: Complex::default(),
            record: text(),
            excitation_snr: 1.0,
        },
        subspace::Doubt::UncertainDirection { record: text(), ambiguity: 1.0 },
        subspace::Doubt::NoiseNotConverged { rounds: 1 },
        subspace::Doubt::IllConditioned { condition: 1.0 },
    ];
    let of_likelihood = [
        likelihood::Doubt::OptimumNotReached {
            status: SearchStatus::Converged,
            remaining_step: 1.0,
        },
        likelihood::Doubt::LevelsNotSettled { updates: 1 },
        likelihood::Doubt::PoorFit { per_degree_of_freedom: 1.0, probability: 1.0 },
        likelihood::Doubt::UnequalFit {
            record: text(),
            per_degree_of_freedom: 1.0,
            deviations: 1.0,
        },
        likelihood::Doubt::ResidualsNotWhite { record: text(), p_value: 1.0 },
        likelihood::Doubt::Offset { p_value: 1.0 },
        likelihood::Doubt::AnotherSystem { likelihood_ratio: 1.0, eigenvalues: Vec::new() },
        likelihood::Doubt::TooShort { degrees_of_freedom: 1.0, parameters: 1 },
        likelihood::Doubt::Undetermined { determined: 1, identifiable: 2 },
    ];
    let printed = printed.into_iter().map(Doubt::Paper);
    let subspace = subspace.into_iter().map(Doubt::Subspace);
    let of_likelihood = of_likelihood.into_iter().map(Doubt::Likelihood);
    let both = Doubt::LevelsDisagree { sensor: text(), subspace: 1.0, likelihood: 1.0 };
    printed.chain(subspace).chain(of_likelihood).chain([both]).collect()
}

#[test]
fn every_doubt_has_a_code_of_its_own_that_the_documents_list() {
    let schema = include_str!("../../../../../docs/identify.schema.json");
    let document = include_str!("../../../../../docs/program.md");
    let all = all();
    let codes: BTreeSet<_> = all.iter().map(Doubt::code).collect();
    assert_eq!(codes.len(), all.len());
    for code in codes {
        assert!(schema.contains(&format!("\"{code}\"")), "{code} is missing in the schema");
        assert!(document.contains(&format!("`{code}`")), "{code} is missing in docs/program.md");
    }
}
