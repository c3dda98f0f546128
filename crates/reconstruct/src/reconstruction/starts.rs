//! The first stage with several numbers of block rows: the order that they agree on, and where the likelihood starts.

use super::doubt::Doubt;
use super::options::Options;
use crate::subspace::{Intersection, NoiseOrigin, OrderChoice, OrderEvidence, best, of_order};
use crate::{NoiseModel, ReconstructError, Record, SharedModel, subspace};

/// What the first stage says.
#[derive(Clone)]
pub(super) struct FirstStage {
    /// The intersection with the block rows of its rule.
    pub(super) intersection: Intersection,
    /// The evidence for the order, over all numbers of block rows.
    pub(super) order: OrderEvidence,
    /// Its doubts, those about the order from that evidence.
    pub(super) doubts: Vec<Doubt>,
    /// The models found, that of the rule first.
    pub(super) starts: Vec<SharedModel>,
}

/// Beside a gap of this size nothing else counts: gaps of orders that are too high stay below its root, and that far above the noise
/// one number of block rows starts the likelihood as well as three.
const CLEAR_GAP: f64 = 1000.0;

/// Where disturbances are as large as the response, which number of block rows comes close is hard to foresee; these parts of the rule's start the
/// likelihood, too.
const FOR_DISTURBANCES: [(usize, usize); 4] = [(1, 5), (1, 4), (3, 8), (3, 4)];

/// Intersections with the block rows of the rule, half and one and a half times as many, where the records allow them.
///
/// A gap that noise makes appears with one number of block rows, the one at the true order with all of them: the geometric mean of an order's
/// gaps decides. Which number comes closest to the system differs from record to record, too; the likelihood sorts that out. Records without noise or with
/// a clear gap, and a number that was asked for, need no other.
pub(super) fn first_stage(
    records: &[Record],
    options: &Options,
) -> Result<FirstStage, ReconstructError> {
    let own = options.subspace();
    let mut first = subspace::identify(records, &own)?;
    let (mut order, mut starts) = (first.order.clone(), Vec::new());
    let quiet = matches!(options.noise, NoiseModel::Quiet(_));
    let clear = first.noise.origin == NoiseOrigin::Rounding || (order.gap >= CLEAR_GAP && !quiet);
    if options.block_rows.is_none() && !clear {
        let mut other = own.clone();
        if options.noise.is_estimated() {
            other.noise = NoiseModel::Levels(first.noise.deviations.clone());
        }
        let found = |other: &subspace::Options, block_rows: usize| {
            let other = subspace::Options { block_rows: Some(block_rows), ..other.clone() };
            // An error says that the records are too short for so many, or that so few cannot tell the order.
            subspace::identify(records, &other).ok()
        };
        let numbers = [first.block_rows / 2, first.block_rows * 3 / 2];
        let mut others: Vec<_> = numbers.iter().filter_map(|&rows| found(&other, rows)).collect();
        if !order.asked {
            order.gaps = means(&first, &others);
            order.order = best(&order.gaps);
            order.gap = gap_of(&order.gaps, order.order);
        }
        let fixed = OrderChoice::Fixed(order.order);
        if first.order.order != order.order {
            first = subspace::identify(records, &subspace::Options { order: fixed, ..own })?;
            order.eigenvalues.clone_from(&first.order.eigenvalues);
        }
        other.order = fixed;
        others.retain_mut(|intersection| {
            let agrees = intersection.order.order == order.order;
            let again = if agrees { None } else { found(&other, intersection.block_rows) };
            let usable = agrees || again.is_some();
            if let Some(again) = again {
                *intersection = again;
            }
            usable
        });
        starts.extend(others.into_iter().map(|intersection| intersection.model));
        if quiet {
            let rows = |(part, of)| first.block_rows * part / of;
            let more = FOR_DISTURBANCES.into_iter().filter_map(|part| found(&other, rows(part)));
            starts.extend(more.map(|intersection| intersection.model));
        }
    }
    starts.insert(0, first.model.clone());
    let doubts = doubts(&first, &order);
    Ok(FirstStage { intersection: first, order, doubts, starts })
}

/// The first stage at this order, with the evidence that speaks for and against it.
pub(super) fn at_order(
    records: &[Record],
    options: &Options,
    stage: &FirstStage,
    order: usize,
) -> Result<FirstStage, ReconstructError> {
    let evidence = &stage.order;
    if evidence.order == order {
        return Ok(stage.clone());
    }
    let fixed = Options { order: OrderChoice::Fixed(order), ..options.clone() };
    let stage = first_stage(records, &fixed)?;
    let evidence = OrderEvidence {
        order,
        asked: false,
        eigenvalues: stage.order.eigenvalues.clone(),
        gap: gap_of(&evidence.gaps, order),
        gaps: evidence.gaps.clone(),
    };
    let doubts = doubts(&stage.intersection, &evidence);
    Ok(FirstStage { order: evidence, doubts, ..stage })
}

/// The geometric mean of each order's gaps, for the orders that all numbers of block rows can tell.
fn means(first: &Intersection, others: &[Intersection]) -> Vec<(usize, f64)> {
    let all: Vec<_> = std::iter::once(first).chain(others).map(|found| &found.order.gaps).collect();
    let known = |order: &usize| all.iter().all(|gaps| gaps.iter().any(|(other, _)| other == order));
    let mean = |order: usize| {
        let number = all.len() as f64;
        let sum: f64 = all.iter().map(|gaps| gap_of(gaps, order).ln()).sum();
        (order, (sum / number).exp())
    };
    first.order.gaps.iter().map(|(order, _)| *order).filter(known).map(mean).collect()
}

fn gap_of(gaps: &[(usize, f64)], order: usize) -> f64 {
    gaps.iter().find(|(other, _)| *other == order).map_or(1.0, |(_, gap)| *gap)
}

/// The intersection's own doubts, but for those about the order.
fn doubts(first: &Intersection, order: &OrderEvidence) -> Vec<Doubt> {
    let combined = !order.asked;
    let about_order = |doubt: &subspace::Doubt| {
        matches!(doubt, subspace::Doubt::WeakOrder { .. } | subspace::Doubt::ContestedOrder { .. })
    };
    let mut doubts = if combined { of_order(order) } else { Vec::new() };
    doubts.extend(first.doubts.iter().filter(|doubt| !combined || !about_order(doubt)).cloned());
    doubts.into_iter().map(Doubt::Subspace).collect()
}
