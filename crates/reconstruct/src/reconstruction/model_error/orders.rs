//! How many states: the order with the lowest Schwarz criterion, among orders from two upwards as far as it falls.

use std::f64::consts::TAU;

use super::starts::Subspaces;
use crate::likelihood::{Fit, Hold};
use crate::reconstruction::result::ComparedOrder;
use crate::subspace::{OrderChoice, OrderEvidence};
use crate::{ReconstructError, Record, SharedModel, likelihood};

/// More states are worth it where they are e^10 times as likely: a few that fit little are what is left of a small nonlinearity.
const DECISIVE: f64 = 20.0;
/// Where the search for the order starts, if the gaps show no lower one.
const LOWEST_ORDER: usize = 2;
/// A first look that leaves the criterion so far above the lowest one is enough.
const HOPELESS: f64 = 1000.0;
/// So many orders in a row that are less likely than the best end the search upwards.
const MISSES: usize = 2;

/// The orders that were fitted, and which is used.
pub(super) struct Orders {
    pub(super) fits: Vec<Fit>,
    best: usize,
}

impl Orders {
    pub(super) fn best(&self) -> &Fit {
        &self.fits[self.best]
    }

    /// The fit of the order that is used, and what the criteria of the others lie above its own.
    pub(super) fn into_best(mut self) -> (Fit, Vec<ComparedOrder>) {
        let best = self.fits.remove(self.best);
        let lowest = best.bayesian_criterion();
        let compared = self.fits.iter().map(|fit| ComparedOrder {
            order: order(fit),
            above: fit.bayesian_criterion() - lowest,
        });
        let compared = compared.collect();
        (best, compared)
    }
}

/// Fits of one order after another.
pub(super) struct OrderSearch<'a> {
    pub(super) records: &'a [Record],
    pub(super) subspaces: &'a Subspaces<'a>,
    pub(super) options: &'a likelihood::Options,
    /// Fits under other options, from which those of their order start as well.
    pub(super) also_from: &'a [Fit],
}

impl OrderSearch<'_> {
    /// Fits orders until more states explain nothing that matters.
    pub(super) fn run(
        &self,
        choice: OrderChoice,
        evidence: &OrderEvidence,
    ) -> Result<Orders, ReconstructError> {
        let criterion = |fit: &Fit| fit.bayesian_criterion();
        let lowest = |fits: &[Fit]| fits.iter().map(criterion).fold(f64::INFINITY, f64::min);
        let (first, last) = match choice {
            OrderChoice::Fixed(order) => (order, order),
            OrderChoice::Gap { largest } => (LOWEST_ORDER.min(evidence.order), largest),
        };
        let (mut fits, mut misses, mut error): (Vec<Fit>, _, _) = (Vec::new(), 0, None);
        for order in first..=last {
            if misses == MISSES || explains_enough(&fits, self.records).is_some() {
                break;
            }
            match self.at_order(order, lowest(&fits) + HOPELESS) {
                Ok(fit) => {
                    misses = if criterion(&fit) < lowest(&fits) { 0 } else { misses + 1 };
                    fits.push(fit);
                }
                // Nothing can be evaluated at the starts of this order.
                Err(other @ ReconstructError::Start { .. }) => {
                    misses += 1;
                    error = Some(other);
                }
                // The records are too short for it, say.
                Err(other) => {
                    error = Some(other);
                    break;
                }
            }
        }
        let decisive = lowest(&fits) + DECISIVE;
        let enough = explains_enough(&fits, self.records);
        let best = enough.or_else(|| fits.iter().position(|fit| criterion(fit) <= decisive));
        match best {
            Some(best) => Ok(Orders { fits, best }),
            None => Err(error.unwrap_or(ReconstructError::InvalidOrder { order: first })),
        }
    }

    /// A fit at one order that is close to its optimum: from each start to where a few steps lead, and on from the best of these.
    fn at_order(&self, order: usize, hopeless: f64) -> Result<Fit, ReconstructError> {
        let mut starts = self.subspaces.starts(order, self.options.threads);
        let of_order = self.also_from.iter().map(|fit| &fit.model).filter(|m| m.a.nrows() == order);
        starts.extend(of_order.cloned());
        let first = self.search(&starts, FIRST_LOOK)?;
        if first.bayesian_criterion() > hopeless { Ok(first) } else { self.refined(&first) }
    }

    /// The fit that another one leads to.
    pub(super) fn refined(&self, fit: &Fit) -> Result<Fit, ReconstructError> {
        self.search(std::slice::from_ref(&fit.model), REFINED)
    }

    fn search(&self, starts: &[SharedModel], effort: Effort) -> Result<Fit, ReconstructError> {
        /// Of a variance.
        const LEVEL_TOLERANCE: f64 = 0.1;
        let search = self.options.search.at_most(effort.steps, effort.updates);
        let options = likelihood::Options {
            hold: Some(self.options.hold.unwrap_or(Hold::ZeroOrder)),
            search: search.no_finer_than(effort.tolerance, LEVEL_TOLERANCE),
            ..self.options.clone()
        };
        likelihood::identify(self.records, starts, &options)
    }
}

/// How far a search goes: steps, updates of the noise levels, and the last step in standard errors.
#[derive(Clone, Copy)]
struct Effort {
    steps: usize,
    updates: usize,
    tolerance: f64,
}

const FIRST_LOOK: Effort = Effort { steps: 8, updates: 2, tolerance: 0.5 };
/// Leaves a tenth of a unit of the criterion.
const REFINED: Effort = Effort { steps: 60, updates: 10, tolerance: 0.3 };

fn order(fit: &Fit) -> usize {
    fit.model.a.nrows()
}

/// Whether all that is left over is below the floors of levels and model error: then more states explain what means nothing.
fn explains_all(fit: &Fit) -> bool {
    /// Residuals make it 1 unless the floors are above them.
    const BELOW_THE_FLOORS: f64 = 0.95;
    fit.chi_squared.per_degree_of_freedom() < BELOW_THE_FLOORS && fit.has_least_model_error()
}

/// The lowest order beyond which more states change nothing that matters: it explains all, or is followed by a more likely one that leaves its modes where they are.
fn explains_enough(fits: &[Fit], records: &[Record]) -> Option<usize> {
    /// A model error as small leaves no mode out.
    const SMALL: f64 = 1e-2;
    let seconds = records.iter().map(|record| record.period().seconds() * record.samples() as f64);
    let slowest = TAU / seconds.fold(0.0, f64::max);
    fits.iter().enumerate().find_map(|(place, fit)| {
        let small = fit.model_error.is_some_and(|error| error.value < SMALL);
        let higher = fits[place + 1..]
            .iter()
            .filter(|other| other.bayesian_criterion() < fit.bayesian_criterion());
        let best = higher.min_by(|x, y| x.bayesian_criterion().total_cmp(&y.bayesian_criterion()));
        let stable = small
            && best.is_some_and(|best| keeps_modes(fit, best, slowest) && keeps_levels(fit, best));
        (explains_all(fit) || stable).then_some(place)
    })
}

/// Whether no sensor is noisier than the other fit has it: a mode that is missing may hide in the noise.
fn keeps_levels(fit: &Fit, other: &Fit) -> bool {
    const NOISIER: f64 = 1.5;
    let levels = fit.noise_levels.iter().flatten().zip(other.noise_levels.iter().flatten());
    levels.into_iter().all(|(own, other)| own.value < NOISIER * other.value)
}

/// Whether each mode that a record can resolve, |s| above `slowest`, is where it is among those of the other fit, too.
fn keeps_modes(fit: &Fit, other: &Fit, slowest: f64) -> bool {
    /// Part of |s|.
    const UNMOVED: f64 = 5e-3;
    /// A mode is as good as unmoved within its standard error, but one that is hardly known stands for nothing.
    const HARDLY_KNOWN: f64 = 5e-2;
    fit.modes.iter().map(|mode| &mode.continuous).filter(|s| s.value.norm() > slowest).all(|s| {
        let unmoved = (UNMOVED * s.value.norm())
            .max(s.covariance.trace().sqrt().min(HARDLY_KNOWN * s.value.norm()));
        other.modes.iter().any(|mode| (mode.continuous.value - s.value).norm() < unmoved)
    })
}
