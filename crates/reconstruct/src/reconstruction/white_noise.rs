//! The fit with white noise or noise that is known, and the number of states where the gaps leave it open: orders that compete are fitted, too, and the
//! likelihood decides.
//!
//! Samples that follow each other quickly, and excitation of few frequencies, make the gap behind the slow modes the smaller one. Disturbances make orders that are too high
//! more likely, so a higher order is used only if it leaves nothing of the fit to doubt.

use super::doubt::{self, Doubt};
use super::options::Options;
use super::result::ComparedOrder;
use super::starts::{self, FirstStage};
use crate::likelihood::Fit;
use crate::subspace::{OrderEvidence, WEAK_GAP};
use crate::{ReconstructError, Record, likelihood, subspace};

/// A criterion that is lower by so much decides: a likelihood ratio of e^5.
const DECISIVE: f64 = 10.0;

/// The most higher orders that are tried.
const MOST_HIGHER: usize = 2;

/// The right order is found in about five steps and five updates; one that needs more than these is not it.
const STEPS: usize = 40;
const UPDATES: usize = 10;

/// Both stages at one order.
pub(super) struct Fitted {
    pub(super) stage: FirstStage,
    pub(super) fit: Fit,
    /// Those of both stages.
    pub(super) doubts: Vec<Doubt>,
    pub(super) compared: Vec<ComparedOrder>,
}

/// Fits the records, at the order that was asked for or at the one that gaps and likelihood show.
pub(super) fn fitted(
    records: &[Record],
    options: &Options,
    second: &likelihood::Options,
    stage: FirstStage,
) -> Result<Fitted, ReconstructError> {
    let mut found = fit(records, options, second, stage)?;
    if found.stage.order.asked {
        return Ok(found);
    }
    let search = second.search.at_most(STEPS, UPDATES);
    let short = likelihood::Options { search, ..second.clone() };
    for order in open(&found) {
        // An error says that the records are too short for it, or allow no search there.
        let other = starts::at_order(records, options, &found.stage, order)
            .and_then(|stage| fit(records, options, &short, stage));
        let Ok(mut other) = other else { continue };
        let above = other.fit.criterion - found.fit.criterion;
        let is_better = above < -DECISIVE && fits(&other.doubts) && !fits(&found.doubts);
        if order > found.stage.order.order && is_better {
            let compared = ComparedOrder { order: found.stage.order.order, above: -above };
            other.compared.push(compared);
            found = other;
        } else {
            found.compared.push(ComparedOrder { order, above });
        }
    }
    if fits(&found.doubts) {
        let decided = |order: usize| {
            found.compared.iter().any(|other| other.order == order && other.above > DECISIVE)
        };
        found.doubts.retain(|doubt| match doubt {
            Doubt::Subspace(subspace::Doubt::ContestedOrder { other, .. }) => !decided(*other),
            _ => true,
        });
    }
    Ok(found)
}

/// The fit at the order of the first stage.
pub(super) fn fit(
    records: &[Record],
    options: &Options,
    second: &likelihood::Options,
    stage: FirstStage,
) -> Result<Fitted, ReconstructError> {
    let fit = likelihood::identify(records, &stage.starts, second)?;
    let of_first = stage.doubts.clone();
    let doubts = doubt::doubts(records, &stage.intersection, of_first, &fit, &options.noise);
    Ok(Fitted { stage, fit, doubts, compared: Vec::new() })
}

/// The orders that compete: the one with the largest gap and, where the fit is doubtful, higher ones whose gap is some evidence.
fn open(found: &Fitted) -> Vec<usize> {
    let OrderEvidence { order, gaps, .. } = &found.stage.order;
    let by_gap = |x: &&(usize, f64), y: &&(usize, f64)| y.1.total_cmp(&x.1);
    let largest = gaps.iter().min_by(by_gap).map(|(order, _)| *order);
    let mut higher: Vec<_> =
        gaps.iter().filter(|(other, gap)| other > order && *gap >= WEAK_GAP).collect();
    higher.sort_by(by_gap);
    higher.truncate(if fits(&found.doubts) { 0 } else { MOST_HIGHER });
    let contesting = largest.filter(|largest| largest != order);
    contesting.into_iter().chain(higher.into_iter().map(|(order, _)| *order)).collect()
}

/// Whether the fit itself leaves nothing to doubt.
pub(super) fn fits(doubts: &[Doubt]) -> bool {
    use likelihood::Doubt as OfFit;
    !doubts.iter().any(|doubt| {
        matches!(
            doubt,
            Doubt::Likelihood(
                OfFit::OptimumNotReached { .. }
                    | OfFit::LevelsNotSettled { .. }
                    | OfFit::PoorFit { .. }
                    | OfFit::UnequalFit { .. }
                    | OfFit::ResidualsNotWhite { .. }
            )
        )
    })
}

/// Whether a doubt says that the gaps leave the order open.
pub(super) fn is_about_order(doubt: &Doubt) -> bool {
    use subspace::Doubt as OfGaps;
    matches!(doubt, Doubt::Subspace(OfGaps::WeakOrder { .. } | OfGaps::ContestedOrder { .. }))
}
