//! Which noise do the records show? White noise alone where its residuals do not follow the signal, otherwise a relative model error beside it.

use super::doubt;
use super::model_error::{self, WithModelError};
use super::options::Options;
use super::starts;
use super::white_noise::{self, Fitted};
use crate::likelihood::{Estimate, Fit, Hold, model_error_test};
use crate::model::record::deviation;
use crate::subspace::NoiseOrigin;
use crate::{NoiseModel, Offsets, ReconstructError, Record, SharedModel, likelihood};

/// Fits the records, with the noise model that was asked for or the one that they show.
pub(super) fn fitted(records: &[Record], options: &Options) -> Result<Fitted, ReconstructError> {
    let stage = starts::first_stage(records, options)?;
    let second = options.likelihood(records, &stage.intersection)?;
    let open = options.noise == NoiseModel::Estimated
        && matches!(stage.intersection.noise.origin, NoiseOrigin::Estimated { .. });
    if !open {
        return white_noise::fitted(records, options, &second, stage);
    }
    let levels = &stage.intersection.noise.deviations;
    let mut white = None;
    if is_white(records, &stage.starts[0], levels, &second)? {
        let found = white_noise::fit(records, options, &second, stage.clone())?;
        let settled = stage.order.asked || !found.doubts.iter().any(white_noise::is_about_order);
        if white_noise::fits(&found.doubts) && settled {
            return Ok(found);
        }
        white = Some(found);
    }
    let WithModelError { fit, compared } = model_error::fitted(records, options, &stage)?;
    let order = fit.model.a.nrows();
    white = white.filter(|white| white.stage.order.order == order);
    if white.is_none()
        && floors_bind(records, &fit)
        && is_white(records, &fit.model, levels, &second)?
    {
        // Too few states had left something that follows the signal; with these nothing does.
        let stage = starts::at_order(records, options, &stage, order)?;
        white = Some(white_noise::fit(records, options, &second, stage)?);
    }
    if let Some(mut white) = white.filter(|white| white_noise::fits(&white.doubts)) {
        if !white.stage.order.asked {
            white.doubts.retain(|doubt| !white_noise::is_about_order(doubt));
        }
        white.compared = compared;
        return Ok(white);
    }
    let stage = starts::at_order(records, options, &stage, order)?;
    let of_first = stage.doubts.clone();
    let doubts = doubt::doubts(records, &stage.intersection, of_first, &fit, &options.noise);
    Ok(Fitted { stage, fit, doubts, compared })
}

/// Whether less noise or a smaller model error would be found if they had no floors: only then can white noise alone do better.
fn floors_bind(records: &[Record], fit: &Fit) -> bool {
    /// Noise above this part of a sensor's size hides a model error of 1e-3.
    const QUIET: f64 = 5e-3;
    let quiet =
        |(sensor, level): (usize, &Estimate)| level.value < QUIET * deviation(records, sensor);
    let levels = fit.noise_levels.iter().flatten();
    fit.has_least_model_error() && levels.enumerate().any(quiet)
}

/// Whether a short search with white noise, from this start, leaves residuals that do not follow the signal, under one hold or the other.
fn is_white(
    records: &[Record],
    start: &SharedModel,
    levels: &[f64],
    second: &likelihood::Options,
) -> Result<bool, ReconstructError> {
    let holds = match second.hold {
        Some(hold) => vec![hold],
        None => vec![Hold::ZeroOrder, Hold::FirstOrder],
    };
    for hold in holds {
        if is_white_under(hold, records, start, levels, second)? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn is_white_under(
    hold: Hold,
    records: &[Record],
    start: &SharedModel,
    levels: &[f64],
    second: &likelihood::Options,
) -> Result<bool, ReconstructError> {
    const STEPS: usize = 15;
    const UPDATES: usize = 4;
    const TOLERANCE: f64 = 0.1;
    /// A level below this part of what the signal subspaces show is none: one sensor explains the excitation exactly.
    const COLLAPSED: f64 = 0.1;
    /// Residuals that follow the signal by so many standard deviations are no white noise.
    const SIGNIFICANT: f64 = 4.0;
    let search = second.search.at_most(STEPS, UPDATES).no_finer_than(TOLERANCE, TOLERANCE);
    let search = search.without_restarts();
    let mut short = likelihood::Options { hold: Some(hold), search, ..second.clone() };
    if short.measurement.offsets == Offsets::AsNeeded {
        // Whether they are needed makes no difference to the other frequencies.
        short.measurement.offsets = Offsets::Free;
    }
    let fit = match likelihood::identify(records, std::slice::from_ref(start), &short) {
        // Nothing can be evaluated there.
        Err(ReconstructError::Start { .. }) => return Ok(false),
        other => other?,
    };
    let found = fit.noise_levels.iter().flatten();
    if found.zip(levels).any(|(found, level)| found.value < COLLAPSED * level) {
        return Ok(false);
    }
    Ok(model_error_test(records, &fit)?.statistic <= SIGNIFICANT)
}
