//! Times of repeated runs: their median, and how far they spread.

use std::time::{Duration, Instant};

use report::format_significant;

use crate::TaskError;
use crate::shared::averages::median;

/// How often to repeat a measurement. One run before the first is not counted: it warms the caches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    /// Runs wanted, at least one.
    pub(crate) count: usize,
    /// No further run begins once this much time is spent.
    pub(crate) patience: Duration,
}

impl Runs {
    /// For what takes less than a second or so.
    pub(crate) const MANY: Self = Self { count: 21, patience: Duration::from_secs(10) };
    /// For what takes seconds.
    pub(crate) const FEW: Self = Self { count: 5, patience: Duration::from_secs(30) };
}

/// The times of several runs of the same work, ascending; at least one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timing {
    seconds: Vec<f64>,
}

impl Timing {
    /// `None` without a single finite, positive time.
    pub(crate) fn new(mut seconds: Vec<f64>) -> Option<Self> {
        seconds.retain(|time| time.is_finite() && *time > 0.0);
        seconds.sort_by(f64::total_cmp);
        (!seconds.is_empty()).then_some(Self { seconds })
    }

    pub(crate) fn runs(&self) -> usize {
        self.seconds.len()
    }

    /// The times, ascending.
    pub(crate) fn seconds(&self) -> &[f64] {
        &self.seconds
    }

    pub(crate) fn median(&self) -> f64 {
        median(&self.seconds)
    }

    /// What the work takes when nothing gets in its way.
    pub(crate) fn fastest(&self) -> f64 {
        self.seconds[0]
    }

    /// The times that a quarter of the runs stay below, and that a quarter exceed.
    pub(crate) fn quartiles(&self) -> (f64, f64) {
        let quarter = self.seconds.len() / 4;
        (self.seconds[quarter], self.seconds[self.seconds.len() - 1 - quarter])
    }

    /// The median with its unit.
    pub(crate) fn shown(&self) -> String {
        show_seconds(self.median())
    }

    /// The quartiles with their unit, and the number of runs.
    pub(crate) fn shown_spread(&self) -> String {
        let (low, high) = self.quartiles();
        format!("{} .. {} ({} runs)", show_seconds(low), show_seconds(high), self.runs())
    }
}

/// Times `work`; what it returns is dropped outside the measured time.
pub(crate) fn measure<T>(
    runs: Runs,
    mut work: impl FnMut() -> Result<T, TaskError>,
) -> Result<Timing, TaskError> {
    let begin = Instant::now();
    drop(std::hint::black_box(work()?));
    let mut seconds = Vec::with_capacity(runs.count);
    while seconds.is_empty() || (seconds.len() < runs.count && begin.elapsed() < runs.patience) {
        let start = Instant::now();
        let result = std::hint::black_box(work()?);
        // A clock too coarse for the work says 0; no time is shorter than its step.
        seconds.push(start.elapsed().as_secs_f64().max(1e-9));
        drop(result);
    }
    Timing::new(seconds).ok_or(TaskError::Computation {
        part: "bench",
        message: "the clock gave no time".to_owned(),
    })
}

/// A time with three digits and the unit that suits it.
pub(crate) fn show_seconds(seconds: f64) -> String {
    let (scaled, unit) = if seconds >= 1.0 {
        (seconds, "s")
    } else if seconds >= 1e-3 {
        (seconds * 1e3, "ms")
    } else {
        (seconds * 1e6, "us")
    };
    format!("{} {unit}", format_significant(scaled, 3))
}

#[cfg(test)]
mod tests;
