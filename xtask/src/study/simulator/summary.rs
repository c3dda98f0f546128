//! What the flights of one kind say together.

use super::kind::Kind;
use super::one_run::{Found, Outcome};
use crate::shared::averages::median;
use crate::shared::modes::PerMode;

/// A result counts as wrong where roll or Dutch roll are off by more than this part of |s|. The
/// spiral's |s| is so small that no record of two minutes tells it to a tenth.
pub(super) const WRONG: f64 = 0.1;

/// A score within this counts as right: 95 % of normal ones are.
pub(super) const FAR: f64 = 2.0;

/// One flight.
#[derive(Clone, Debug)]
pub(super) struct Case {
    pub(super) kind: Kind,
    pub(super) outcome: Outcome,
    /// True |s| of spiral, roll, Dutch roll.
    pub(super) sizes: PerMode,
}

impl Case {
    pub(super) fn found(&self) -> Option<&Found> {
        self.outcome.result.as_ref().ok()
    }

    /// Errors that can be compared: of the spiral in 1/s, of roll and Dutch roll as parts of |s|.
    /// Infinite where there is no result.
    pub(super) fn errors(&self) -> PerMode {
        let [spiral, roll, dutch_roll] =
            self.found().map_or([f64::INFINITY; 3], |found| found.modes.map(|mode| mode.error));
        [spiral, roll / self.sizes[1], dutch_roll / self.sizes[2]]
    }

    /// Whether there is a result that leaves nothing to doubt.
    pub(super) fn trusted(&self) -> bool {
        self.found().is_some_and(|found| found.doubts.is_empty())
    }

    /// Whether roll or Dutch roll are off by more than [`WRONG`].
    pub(super) fn wrong(&self) -> bool {
        self.errors()[1..].iter().any(|error| *error > WRONG)
    }
}

/// Several flights.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Summary {
    pub(super) flights: usize,
    /// As [`Case::errors`].
    pub(super) median: PerMode,
    pub(super) worst: PerMode,
    /// Scores of all modes, and how many are within [`FAR`].
    pub(super) scores: usize,
    pub(super) within: usize,
    /// Flights that leave nothing to doubt.
    pub(super) trusted: usize,
    /// Flights that are wrong, and those of them that are trusted.
    pub(super) wrong: usize,
    pub(super) wrong_and_trusted: usize,
}

impl Summary {
    pub(super) fn of<'a>(cases: impl IntoIterator<Item = &'a Case>) -> Self {
        let cases: Vec<&Case> = cases.into_iter().collect();
        let of = |part: fn(&[f64]) -> f64| {
            [0, 1, 2]
                .map(|mode| part(&cases.iter().map(|case| case.errors()[mode]).collect::<Vec<_>>()))
        };
        let found = cases.iter().filter_map(|case| case.found());
        let scores: Vec<f64> =
            found.flat_map(|found| found.modes).filter_map(|mode| mode.score()).collect();
        let number = |counts: fn(&Case) -> bool| cases.iter().filter(|case| counts(case)).count();
        Self {
            flights: cases.len(),
            median: of(median),
            worst: of(|errors| errors.iter().copied().fold(0.0, f64::max)),
            scores: scores.len(),
            within: scores.iter().filter(|score| score.abs() < FAR).count(),
            trusted: number(Case::trusted),
            wrong: number(Case::wrong),
            wrong_and_trusted: number(|case| case.wrong() && case.trusted()),
        }
    }
}

#[cfg(test)]
mod tests;
