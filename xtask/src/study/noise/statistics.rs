//! What many runs of one kind say together.

use super::case::Excitation;
use super::flights::count;
use super::outcome::{LOST, Outcome, PerMode};

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
    /// Runs in which the gap shows four states.
    pub(crate) right_order: usize,
}

/// The errors of one method.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MethodSummary {
    /// Root mean square error in 1/s; `None` where no run gave anything.
    pub(crate) rms: Option<PerMode>,
    pub(crate) median: Option<PerMode>,
    /// Runs that gave nothing.
    pub(crate) failed: usize,
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
    let collected = |errors: Vec<Option<PerMode>>| {
        let failed = errors.iter().filter(|errors| errors.is_none()).count();
        let errors: Vec<PerMode> = errors.into_iter().flatten().collect();
        let of = |part: fn(&[f64]) -> f64| {
            (!errors.is_empty()).then(|| {
                [0, 1, 2].map(|mode| part(&errors.iter().map(|run| run[mode]).collect::<Vec<_>>()))
            })
        };
        MethodSummary { rms: of(root_mean_square), median: of(median), failed }
    };
    let scores = |parts: &[usize]| {
        fits.iter()
            .flat_map(|fit| parts.iter().map(|part| fit.scores[*part]))
            .filter(|score| score.abs() < LOST)
            .collect()
    };
    let part_of = |number: usize, all: usize| count(number) / count(all.max(1));
    Summary {
        kind,
        runs: outcomes.len(),
        methods: [
            collected(outcomes.iter().map(|run| run.as_printed).collect()),
            collected(outcomes.iter().map(|run| run.subspace).collect()),
            collected(
                outcomes.iter().map(|run| run.likelihood.as_ref().map(|fit| fit.errors)).collect(),
            ),
        ],
        bound: [0, 1, 2].map(|mode| {
            let sum: f64 = outcomes.iter().map(|run| run.bound[mode]).sum();
            (sum / count(outcomes.len())).sqrt()
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

pub(crate) fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / count(values.len())).sqrt()
}

/// The middle value, or the mean of the two in the middle; not a number where there is none.
pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => sorted[n / 2],
        n => f64::midpoint(sorted[n / 2 - 1], sorted[n / 2]),
    }
}

/// Density in bins of equal width between two ends; what lies beyond counts in the outermost bins. (left end, right end, density)
pub(crate) fn histogram(values: &[f64], ends: (f64, f64), bins: u32) -> Vec<(f64, f64, f64)> {
    let width = (ends.1 - ends.0) / f64::from(bins);
    (0..bins)
        .map(|bin| {
            let left = ends.0 + width * f64::from(bin);
            let right = left + width;
            let inside =
                |value: f64| (value >= left || bin == 0) && (value < right || bin + 1 == bins);
            let number = values.iter().filter(|value| inside(**value)).count();
            (left, right, count(number) / (count(values.len().max(1)) * width))
        })
        .collect()
}

#[cfg(test)]
mod tests;
