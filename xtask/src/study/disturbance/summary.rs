//! What many flights of one kind say together.

use std::array::from_fn;
use std::collections::BTreeMap;

use super::kind::Kind;
use super::one_run::{Both, Likelihood, Outcome};
use crate::shared::averages::median;
use crate::shared::modes::PerMode;
use crate::study::statistics::{FitSummary, MethodSummary, mean_deviation};

/// A result counts as wrong where roll or Dutch roll are off by more than this part of |s|. The
/// spiral's |s| is so small that no record of three minutes tells it to a tenth.
pub(super) const WRONG: f64 = 0.1;

/// A search missed where another start found a sum of squares that is smaller by this much: a tenth
/// of what one parameter gains by chance.
pub(super) const MISSED: f64 = 0.1;

/// The flights of one kind.
#[derive(Clone, Debug)]
pub(super) struct Summary {
    pub(super) kind: Kind,
    pub(super) runs: usize,
    /// In the order of [`ESTIMATES`].
    pub(super) errors: [MethodSummary; 7],
    /// The information bound as a standard deviation: spiral, roll, Dutch roll.
    pub(super) bound: PerMode,
    /// Its median.
    pub(super) middle_bound: PerMode,
    /// In the order of [`FITS`].
    pub(super) fits: [FitSummary; 4],
    /// In the order of [`RESULTS`].
    pub(super) trust: [Trust; 4],
    /// Runs in which the fit with the quiet record is worse than the one from the true system.
    pub(super) missed: usize,
}

/// Everything that has errors.
pub(super) const ESTIMATES: [&str; 7] = [
    "subspace, alone",
    "likelihood, alone",
    "subspace, quiet record",
    "likelihood, quiet record",
    "likelihood, quiet record, true start",
    "likelihood, true spectrum and start",
    "inputs known",
];

/// What also states deviations.
pub(super) const FITS: [&str; 4] = [ESTIMATES[1], ESTIMATES[3], ESTIMATES[4], ESTIMATES[5]];

/// What can carry doubts.
pub(super) const RESULTS: [&str; 4] = [ESTIMATES[0], ESTIMATES[1], ESTIMATES[2], ESTIMATES[3]];

/// Whether results that cannot be trusted say so.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Trust {
    pub(super) results: usize,
    pub(super) doubted: usize,
    pub(super) wrong: usize,
    pub(super) wrong_and_not_doubted: usize,
    /// How many results carry each doubt.
    pub(super) doubts: BTreeMap<String, usize>,
}

impl Summary {
    /// `sizes` are |s| of spiral, roll, Dutch roll.
    pub(super) fn of(kind: Kind, outcomes: &[Outcome], sizes: PerMode) -> Self {
        let bounds: Vec<PerMode> = outcomes.iter().map(|run| run.bound).collect();
        let missed = |run: &&Outcome| run.missed.is_some_and(|gain| gain > MISSED);
        Self {
            kind,
            runs: outcomes.len(),
            errors: from_fn(|i| MethodSummary::of(outcomes.iter().map(|run| estimates(run)[i]))),
            bound: mean_deviation(&bounds),
            middle_bound: from_fn(|mode| {
                median(&bounds.iter().map(|bound| bound[mode].sqrt()).collect::<Vec<_>>())
            }),
            fits: from_fn(|i| {
                let runs = outcomes.iter().filter_map(|run| fits(run)[i]);
                FitSummary::of(runs.map(|likelihood| &likelihood.fit))
            }),
            trust: from_fn(|i| trust(outcomes.iter().filter_map(|run| results(run)[i]), sizes)),
            missed: outcomes.iter().filter(missed).count(),
        }
    }
}

/// The errors of [`ESTIMATES`].
fn estimates(run: &Outcome) -> [Option<PerMode>; 7] {
    let [first, second, third, fourth] = results(run).map(|result| result.map(|(e, _)| e));
    let [.., start, spectrum] = fits(run).map(|found| found.map(|found| found.fit.errors));
    [first, second, third, fourth, start, spectrum, run.inputs_known]
}

/// Those of [`FITS`].
fn fits(run: &Outcome) -> [Option<&Likelihood>; 4] {
    [&run.alone.likelihood, &run.quiet.likelihood, &run.true_start, &run.true_spectrum]
        .map(Option::as_ref)
}

/// Errors and doubts of [`RESULTS`].
fn results(run: &Outcome) -> [Option<(PerMode, &[String])>; 4] {
    let [alone, quiet] = [&run.alone, &run.quiet].map(|Both { subspace, likelihood }| {
        [
            subspace.as_ref().map(|found| (found.errors, found.doubts.as_slice())),
            likelihood.as_ref().map(|found| (found.fit.errors, found.doubts.as_slice())),
        ]
    });
    [alone[0], alone[1], quiet[0], quiet[1]]
}

fn trust<'a>(results: impl Iterator<Item = (PerMode, &'a [String])>, sizes: PerMode) -> Trust {
    let mut trust = Trust::default();
    for (errors, doubts) in results {
        let wrong = [1, 2].into_iter().any(|mode| errors[mode] > WRONG * sizes[mode]);
        trust.results += 1;
        trust.doubted += usize::from(!doubts.is_empty());
        trust.wrong += usize::from(wrong);
        trust.wrong_and_not_doubted += usize::from(wrong && doubts.is_empty());
        for doubt in doubts {
            *trust.doubts.entry(doubt.clone()).or_default() += 1;
        }
    }
    trust
}

#[cfg(test)]
mod tests;
