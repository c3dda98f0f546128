//! What the runs of one kind say together.

use super::kind::Kind;
use super::one_run::Outcome;
use crate::shared::modes::PerMode;
use crate::study::statistics::{FitSummary, MethodSummary, mean_deviation};

/// The runs of one kind.
#[derive(Clone, Debug)]
pub(super) struct Summary {
    pub(super) kind: Kind,
    pub(super) runs: usize,
    /// As printed, subspace, maximum likelihood.
    pub(super) methods: [MethodSummary; 3],
    /// The information bound as a standard deviation: spiral, roll, Dutch roll.
    pub(super) bound: PerMode,
    /// What maximum likelihood states about itself.
    pub(super) fits: FitSummary,
    /// Runs with chi-squared per degree of freedom above [`BAD_FIT`].
    pub(super) bad_fits: usize,
    /// Runs whose search ended at a lower likelihood than one from the true system.
    pub(super) missed: usize,
    /// Runs in which the gap shows four states.
    pub(super) right_order: usize,
}

/// Above this a fit leaves more than noise unexplained.
pub(super) const BAD_FIT: f64 = 1.1;

impl Summary {
    pub(super) fn of(kind: Kind, outcomes: &[Outcome]) -> Self {
        let likelihoods = || outcomes.iter().filter_map(|run| run.likelihood.as_ref());
        let fits = FitSummary::of(likelihoods().map(|likelihood| &likelihood.fit));
        Self {
            kind,
            runs: outcomes.len(),
            methods: [
                MethodSummary::of(outcomes.iter().map(|run| run.as_printed)),
                MethodSummary::of(outcomes.iter().map(|run| run.subspace)),
                MethodSummary::of(
                    outcomes.iter().map(|run| run.likelihood.as_ref().map(|x| x.fit.errors)),
                ),
            ],
            bound: mean_deviation(&outcomes.iter().map(|run| run.bound).collect::<Vec<_>>()),
            bad_fits: fits.chi_squared.iter().filter(|x| x.is_nan() || **x > BAD_FIT).count(),
            fits,
            missed: likelihoods().filter(|likelihood| likelihood.missed).count(),
            right_order: outcomes.iter().filter(|run| run.order_found == Some(4)).count(),
        }
    }

    /// Error of maximum likelihood over the information bound.
    pub(super) fn ratio(&self) -> Option<PerMode> {
        let rms = self.methods[2].rms?;
        Some([0, 1, 2].map(|mode| rms[mode] / self.bound[mode]))
    }
}

#[cfg(test)]
mod tests;
