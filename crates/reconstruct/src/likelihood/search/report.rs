//! How the search went: over all, and from each start.

use super::levenberg_marquardt::SearchStatus;

/// How a search went.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SearchReport {
    /// How it ended.
    pub status: SearchStatus,
    /// Steps that lowered the cost.
    pub steps: usize,
    /// Evaluations of the likelihood with its derivatives.
    pub evaluations: usize,
    /// Updates of the noise levels.
    pub level_updates: usize,
    /// Whether the noise levels settled; true where they were not estimated.
    pub levels_settled: bool,
    /// The length of the step that was not taken any more, in standard deviations of the estimate.
    pub remaining_step: f64,
}

/// Where one start led.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StartReport {
    /// The cost at the start, with its own directions.
    pub cost_at_start: f64,
    /// For each record, whether the direction that was estimated from the spectra fits better than the start's.
    pub direction_replaced: Vec<bool>,
    /// What was compared between the starts, with many frequencies on some of them: the cost, plus the logarithms of determinants where noise levels were estimated.
    pub objective: f64,
    /// How its search went; `None` where the start has no finite cost.
    pub search: Option<SearchReport>,
}
