//! Records that no linear system with white noise explains: a fit with a relative model error, at the order and in the band that the records show.
//!
//! Real flights are not quite linear, couple into other motions, and are held between samples in no textbook way. Their misfit follows the signal
//! ([`Noise::ModelError`]), and with white noise alone every order that fits more of it is more likely than the last. With it the likelihood tells
//! the order (`orders.rs`), from starts in several signal subspaces (`starts.rs`).

mod orders;
mod starts;

use orders::{OrderSearch, Orders};
use starts::{Subspaces, subspace_options};

use super::options::Options;
use super::result::ComparedOrder;
use super::starts::FirstStage;
use crate::likelihood::{Fit, FrequencyBand, Noise};
use crate::subspace::OrderEvidence;
use crate::{Measurement, ReconstructError, Record, Trend, likelihood};

/// The fit with a model error.
pub(super) struct WithModelError {
    pub(super) fit: Fit,
    /// Other orders, by Schwarz's criterion.
    pub(super) compared: Vec<ComparedOrder>,
}

/// A mode whose standard error is below this part of its size says how fast the system is.
const KNOWN: f64 = 0.1;

/// Fits the records with a relative model error.
pub(super) fn fitted(
    records: &[Record],
    options: &Options,
    stage: &FirstStage,
) -> Result<WithModelError, ReconstructError> {
    let period = records[0].period();
    let first_band = FrequencyBand::before_the_modes(period);
    let second = likelihood::Options {
        noise: Noise::ModelError { first_guess: None },
        measurement: options.measurement.clone(),
        band: Some(options.band.unwrap_or(first_band)),
        hold: options.hold,
        search: options.search.without_restarts(),
        threads: options.threads,
    };
    let all = subspace_options(records, options, &stage.intersection);
    let subspaces = Subspaces::new(records, &all, options.threads)?;
    let (found, second) = with_drift_as_needed(records, options, &subspaces, &stage.order, second)?;
    let (start, compared) = found.into_best();
    let chosen = || first_band.reaching_beyond(fastest(&start)?, period);
    let band = Some(options.band.or_else(chosen).unwrap_or(first_band));
    let second = likelihood::Options { band, ..second };
    let fit = likelihood::identify(records, std::slice::from_ref(&start.model), &second)?;
    Ok(WithModelError { fit, compared })
}

/// The orders that the records show, and the options with the drift of sensors that they call for, where that was left open.
fn with_drift_as_needed(
    records: &[Record],
    options: &Options,
    subspaces: &Subspaces<'_>,
    evidence: &OrderEvidence,
    second: likelihood::Options,
) -> Result<(Orders, likelihood::Options), ReconstructError> {
    let with = |trend: Trend| {
        let measurement = Measurement { trend, ..second.measurement.clone() };
        likelihood::Options { measurement, ..second.clone() }
    };
    let search = |options| OrderSearch { records, subspaces, options, also_from: &[] };
    if options.measurement.trend != Trend::AsNeeded {
        return Ok((search(&second).run(options.order, evidence)?, second));
    }
    let (still, drifting) = (with(Trend::Absent), with(Trend::Linear));
    let found = search(&still).run(options.order, evidence)?;
    if calls_for_drift(&found, &search(&drifting)) {
        let again = OrderSearch { also_from: &found.fits, ..search(&drifting) };
        return Ok((again.run(options.order, evidence)?, drifting));
    }
    Ok((found, still))
}

/// Whether the records are more likely with sensors that drift: at the order found, or at one or two fewer, since states can stand in for drift.
fn calls_for_drift(found: &Orders, drifting: &OrderSearch<'_>) -> bool {
    /// A likelihood ratio of e^5.
    const DECISIVE: f64 = 10.0;
    const FEWER: usize = 2;
    let best = found.best();
    let order = |fit: &Fit| fit.model.a.nrows();
    let near = |fit: &&Fit| order(fit) <= order(best) && order(fit) + FEWER >= order(best);
    found.fits.iter().filter(near).any(|fit| {
        let again = drifting.refined(fit);
        again.is_ok_and(|again| again.bayesian_criterion() < best.bayesian_criterion() - DECISIVE)
    })
}

/// The largest |s| of the modes that the records determine.
fn fastest(fit: &Fit) -> Option<f64> {
    let known = fit.modes.iter().filter(|mode| {
        mode.continuous.covariance.trace().sqrt() < KNOWN * mode.continuous.value.norm()
    });
    known.map(|mode| mode.continuous.value.norm()).max_by(f64::total_cmp)
}
