//! What many runs of one kind say together.

use super::fit::{JudgedFit, LOST};
use crate::shared::averages::{median, root_mean_square};
use crate::shared::modes::PerMode;

/// The errors of one method.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MethodSummary {
    /// Root mean square error in 1/s; `None` where no run gave anything.
    pub(super) rms: Option<PerMode>,
    pub(super) median: Option<PerMode>,
    /// Runs that gave nothing.
    pub(super) failed: usize,
}

impl MethodSummary {
    /// Of the errors of all runs; `None` where a run gave nothing.
    pub(super) fn of(errors: impl IntoIterator<Item = Option<PerMode>>) -> Self {
        let runs: Vec<Option<PerMode>> = errors.into_iter().collect();
        let failed = runs.iter().filter(|errors| errors.is_none()).count();
        let errors: Vec<PerMode> = runs.into_iter().flatten().collect();
        let of = |part: fn(&[f64]) -> f64| {
            (!errors.is_empty()).then(|| {
                [0, 1, 2].map(|mode| part(&errors.iter().map(|run| run[mode]).collect::<Vec<_>>()))
            })
        };
        Self { rms: of(root_mean_square), median: of(median), failed }
    }
}

/// What several fits state about themselves.
#[derive(Clone, Debug)]
pub(super) struct FitSummary {
    /// Chi-squared per degree of freedom of each fit.
    pub(super) chi_squared: Vec<f64>,
    /// Part of the fits whose 95 % interval or ellipse holds the truth.
    pub(super) coverage: PerMode,
    /// All scores: spiral, roll, and both parts of the Dutch roll; without those of modes that were
    /// lost.
    pub(super) scores: [Vec<f64>; 3],
    /// Fits in which a real eigenvalue has taken the Dutch roll's place.
    pub(super) lost: usize,
    /// Fits whose search did not converge.
    pub(super) unconverged: usize,
}

impl FitSummary {
    pub(super) fn of<'a>(fits: impl IntoIterator<Item = &'a JudgedFit>) -> Self {
        let fits: Vec<&JudgedFit> = fits.into_iter().collect();
        let scores = |parts: &[usize]| {
            fits.iter()
                .flat_map(|fit| parts.iter().map(|part| fit.scores[*part]))
                .filter(|score| score.abs() < LOST)
                .collect()
        };
        let covered = |mode: usize| fits.iter().filter(|fit| fit.covered[mode]).count();
        Self {
            chi_squared: fits.iter().map(|fit| fit.chi_squared).collect(),
            coverage: [0, 1, 2].map(|mode| covered(mode) as f64 / fits.len().max(1) as f64),
            scores: [scores(&[0]), scores(&[1]), scores(&[2, 3])],
            lost: fits.iter().filter(|fit| fit.scores.iter().any(|z| z.abs() >= LOST)).count(),
            unconverged: fits.iter().filter(|fit| !fit.converged).count(),
        }
    }

    /// Root mean square of the scores: 1 where deviations are honest.
    pub(super) fn score_deviation(&self) -> PerMode {
        self.scores.each_ref().map(|scores| root_mean_square(scores))
    }
}

/// The standard deviations that go with the mean of several bounds on the variance.
pub(super) fn mean_deviation(bounds: &[PerMode]) -> PerMode {
    [0, 1, 2].map(|mode| {
        let sum: f64 = bounds.iter().map(|bound| bound[mode]).sum();
        (sum / bounds.len() as f64).sqrt()
    })
}
