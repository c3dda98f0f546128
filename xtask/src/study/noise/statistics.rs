//! What many runs of one kind say together.

use super::case::Excitation;
use super::outcome::Outcome;
use crate::study::averages::{MethodSummary, root_mean_square};
use crate::study::modes::PerMode;
use crate::study::verdict::LOST;

/// A kind of record: an excitation and a signal to noise ratio.
pub(crate) type Kind = (Excitation, u32);

/// The runs of one kind.
#[derive(Clone, Debug)]
pub(crate) struct Summary {
    pub(crate) kind: Kind,
    pub(crate) runs: usize,
    /// As printed, subspace, maximum likelihood.
    pub(crate) methods: [MethodSummary; 3],
    /// The information bound as a standard deviation: spiral, roll, Dutch roll.
    pub(crate) bound: PerMode,
    /// All scores: spiral, roll, and both parts of the Dutch roll; without those of modes that were lost.
    pub(crate) scores: [Vec<f64>; 3],
    /// Part of the runs whose interval or ellipse holds the truth.
    pub(crate) coverage: PerMode,
    /// Runs with chi-squared per degree of freedom above 1.1.
    pub(crate) bad_fits: usize,
    /// Runs in which a real eigenvalue has taken the Dutch roll's place.
    pub(crate) lost: usize,
    /// Runs whose search did not converge.
    pub(crate) unconverged: usize,
    /// Runs whose search ended at a lower likelihood than one from the true system.
    pub(crate) missed: usize,
    /// Runs in which the gap shows four states.
    pub(crate) right_order: usize,
}

/// Above this a fit leaves more than noise unexplained.
pub(crate) const BAD_FIT: f64 = 1.1;

/// One summary for each kind, in the order of the outcomes.
pub(crate) fn summaries(outcomes: &[Outcome]) -> Vec<Summary> {
    let kind = |outcome: &Outcome| (outcome.case.excitation, outcome.case.signal_to_noise);
    outcomes
        .chunk_by(|a, b| kind(a) == kind(b))
        .filter_map(|runs| runs.first().map(|first| summary(kind(first), runs)))
        .collect()
}

fn summary(kind: Kind, outcomes: &[Outcome]) -> Summary {
    let fits: Vec<_> = outcomes.iter().filter_map(|run| run.likelihood.as_ref()).collect();
    let scores = |parts: &[usize]| {
        fits.iter()
            .flat_map(|fit| parts.iter().map(|part| fit.scores[*part]))
            .filter(|score| score.abs() < LOST)
            .collect()
    };
    let part_of = |number: usize, all: usize| number as f64 / all.max(1) as f64;
    Summary {
        kind,
        runs: outcomes.len(),
        methods: [
            MethodSummary::of(outcomes.iter().map(|run| run.as_printed).collect()),
            MethodSummary::of(outcomes.iter().map(|run| run.subspace).collect()),
            MethodSummary::of(
                outcomes.iter().map(|run| run.likelihood.as_ref().map(|fit| fit.errors)).collect(),
            ),
        ],
        bound: [0, 1, 2].map(|mode| {
            let sum: f64 = outcomes.iter().map(|run| run.bound[mode]).sum();
            (sum / outcomes.len() as f64).sqrt()
        }),
        scores: [scores(&[0]), scores(&[1]), scores(&[2, 3])],
        coverage: [0, 1, 2]
            .map(|mode| part_of(fits.iter().filter(|fit| fit.covered[mode]).count(), fits.len())),
        bad_fits: fits
            .iter()
            .filter(|fit| fit.chi_squared.is_nan() || fit.chi_squared > BAD_FIT)
            .count(),
        lost: fits.iter().filter(|fit| fit.scores.iter().any(|z| z.abs() >= LOST)).count(),
        unconverged: fits.iter().filter(|fit| !fit.converged).count(),
        missed: fits.iter().filter(|fit| fit.missed).count(),
        right_order: outcomes.iter().filter(|run| run.order_found == Some(4)).count(),
    }
}

impl Summary {
    /// Error of maximum likelihood over the information bound.
    pub(crate) fn ratio(&self) -> Option<PerMode> {
        let rms = self.methods[2].rms?;
        Some([0, 1, 2].map(|mode| rms[mode] / self.bound[mode]))
    }

    /// Root mean square of the scores: 1 where deviations are honest.
    pub(crate) fn score_deviation(&self) -> PerMode {
        [0, 1, 2].map(|mode| root_mean_square(&self.scores[mode]))
    }
}

#[cfg(test)]
mod tests;
