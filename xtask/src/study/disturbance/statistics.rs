//! What many flights of one kind say together.

use std::collections::BTreeMap;

use super::case::Excitation;
use super::outcome::{Likelihood, Outcome, Subspace};
use crate::study::averages::{MethodSummary, median, quantile, root_mean_square};
use crate::study::modes::PerMode;
use crate::study::verdict::LOST;

/// A kind of flight: how the controls move, and the size of the gusts' motion in percent of the response.
pub(crate) type Kind = (Excitation, u32);

/// A result counts as wrong where roll or Dutch roll are off by more than this part of |s|. The spiral's |s| is so small that no record of three
/// minutes tells it to a tenth.
pub(crate) const WRONG: f64 = 0.1;

/// A search missed where another start found a sum of squares that is smaller by this much: a tenth of what one parameter gains by chance.
pub(crate) const MISSED: f64 = 0.1;

/// The flights of one kind.
#[derive(Clone, Debug)]
pub(crate) struct Summary {
    pub(crate) kind: Kind,
    pub(crate) runs: usize,
    /// In the order of [`ESTIMATES`].
    pub(crate) errors: [MethodSummary; 7],
    /// The information bound as a standard deviation: spiral, roll, Dutch roll.
    pub(crate) bound: PerMode,
    /// Its median.
    pub(crate) middle_bound: PerMode,
    /// In the order of [`FITS`].
    pub(crate) fits: [Fits; 4],
    /// In the order of [`RESULTS`].
    pub(crate) trust: [Trust; 4],
    /// Runs in which the fit with the quiet record is worse than the one from the true system.
    pub(crate) missed: usize,
}

/// Everything that has errors.
pub(crate) const ESTIMATES: [&str; 7] = [
    "subspace, alone",
    "likelihood, alone",
    "subspace, quiet record",
    "likelihood, quiet record",
    "likelihood, quiet record, true start",
    "likelihood, true spectrum and start",
    "inputs known",
];

/// What also states deviations.
pub(crate) const FITS: [&str; 4] = [ESTIMATES[1], ESTIMATES[3], ESTIMATES[4], ESTIMATES[5]];

/// What can carry doubts.
pub(crate) const RESULTS: [&str; 4] = [ESTIMATES[0], ESTIMATES[1], ESTIMATES[2], ESTIMATES[3]];

/// What several fits state about themselves.
#[derive(Clone, Debug)]
pub(crate) struct Fits {
    /// Chi-squared per degree of freedom: fifth percentile, median, ninety-fifth percentile.
    pub(crate) chi_squared: [f64; 3],
    /// Part of the fits whose 95 % interval or ellipse holds the truth.
    pub(crate) coverage: PerMode,
    /// Root mean square of the scores, without those of modes that were lost: 1 where deviations are honest.
    pub(crate) score_deviation: PerMode,
    pub(crate) unconverged: usize,
}

/// Whether results that cannot be trusted say so.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Trust {
    pub(crate) results: usize,
    pub(crate) doubted: usize,
    pub(crate) wrong: usize,
    pub(crate) wrong_and_not_doubted: usize,
    /// How many results carry each doubt.
    pub(crate) doubts: BTreeMap<String, usize>,
}

/// One summary for each kind, in the order of the outcomes. `sizes` are |s| of spiral, roll, Dutch roll.
pub(crate) fn summaries(outcomes: &[Outcome], sizes: PerMode) -> Vec<Summary> {
    let kind = |outcome: &Outcome| (outcome.case.excitation, outcome.case.gust_percent);
    outcomes
        .chunk_by(|a, b| kind(a) == kind(b))
        .filter_map(|runs| runs.first().map(|first| summary(kind(first), runs, sizes)))
        .collect()
}

fn summary(kind: Kind, outcomes: &[Outcome], sizes: PerMode) -> Summary {
    let subspace = |run: &Outcome| [run.alone.subspace.clone(), run.quiet.subspace.clone()];
    let fits = |run: &Outcome| {
        [&run.alone.likelihood, &run.quiet.likelihood, &run.true_start, &run.true_spectrum]
            .map(Option::clone)
    };
    let subspaces: [Vec<Option<Subspace>>; 2] =
        [0, 1].map(|which| outcomes.iter().map(|run| subspace(run)[which].clone()).collect());
    let likelihoods: [Vec<Option<Likelihood>>; 4] =
        [0, 1, 2, 3].map(|which| outcomes.iter().map(|run| fits(run)[which].clone()).collect());
    let of_subspace = |which: usize| {
        MethodSummary::of(
            subspaces[which].iter().map(|run| run.as_ref().map(|x| x.errors)).collect(),
        )
    };
    let of_fit = |which: usize| {
        MethodSummary::of(
            likelihoods[which].iter().map(|run| run.as_ref().map(|x| x.errors)).collect(),
        )
    };
    let closed = |which: usize| {
        trust(subspaces[which].iter().flatten().map(|x| (x.errors, x.doubts.as_slice())), sizes)
    };
    let likely = |which: usize| {
        trust(likelihoods[which].iter().flatten().map(|x| (x.errors, x.doubts.as_slice())), sizes)
    };
    Summary {
        kind,
        runs: outcomes.len(),
        errors: [
            of_subspace(0),
            of_fit(0),
            of_subspace(1),
            of_fit(1),
            of_fit(2),
            of_fit(3),
            MethodSummary::of(outcomes.iter().map(|run| run.inputs_known).collect()),
        ],
        bound: [0, 1, 2].map(|mode| {
            let sum: f64 = outcomes.iter().map(|run| run.bound[mode]).sum();
            (sum / outcomes.len() as f64).sqrt()
        }),
        middle_bound: [0, 1, 2].map(|mode| {
            median(&outcomes.iter().map(|run| run.bound[mode].sqrt()).collect::<Vec<_>>())
        }),
        fits: [0, 1, 2, 3].map(|which| fits_of(&likelihoods[which])),
        trust: [closed(0), likely(0), closed(1), likely(1)],
        missed: outcomes.iter().filter(|run| run.missed.is_some_and(|gain| gain > MISSED)).count(),
    }
}

fn fits_of(runs: &[Option<Likelihood>]) -> Fits {
    let fits: Vec<&Likelihood> = runs.iter().flatten().collect();
    let chi_squared: Vec<f64> = fits.iter().map(|fit| fit.chi_squared).collect();
    let scores = |parts: &[usize]| {
        let all = fits.iter().flat_map(|fit| parts.iter().map(|part| fit.scores[*part]));
        root_mean_square(&all.filter(|score| score.abs() < LOST).collect::<Vec<_>>())
    };
    Fits {
        chi_squared: [0.05, 0.5, 0.95].map(|part| quantile(&chi_squared, part)),
        coverage: [0, 1, 2].map(|mode| {
            fits.iter().filter(|fit| fit.covered[mode]).count() as f64 / fits.len().max(1) as f64
        }),
        score_deviation: [scores(&[0]), scores(&[1]), scores(&[2, 3])],
        unconverged: fits.iter().filter(|fit| !fit.converged).count(),
    }
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
