//! Which noise do the records show? White noise alone where its residuals do not follow the signal, otherwise a relative model error beside it.

use super::doubt;
use super::model_error::{self, WithModelError};
use super::options::Options;
use super::starts;
use super::white_noise::{self, Fitted};
use crate::likelihood::{Estimate, Fit, Hold, SearchOptions, model_error_test};
use crate::model::record::largest_rms;
use crate::subspace::NoiseOrigin;
use crate::{NoiseModel, ReconstructError, Record, SharedModel, likelihood};

/// Residuals that follow the signal by so many standard deviations are no white noise.
const SIGNIFICANT: f64 = 4.0;

/// Whether less noise or a smaller model error would be found if they had no floors: only then can white noise alone do better.
fn floors_bind(records: &[Record], fit: &Fit) -> bool {
    /// The floor of the model error, 1e-3, but for the last update.
    const AT_THE_FLOOR: f64 = 1.2e-3;
    /// Noise above this part of a sensor's root mean square hides a model error of 1e-3.
    const QUIET: f64 = 5e-3;
    let at_floor = fit.model_error.is_some_and(|error| error.value < AT_THE_FLOOR);
    let quiet =
        |(sensor, level): (usize, &Estimate)| level.value < QUIET * largest_rms(records, sensor);
    at_floor && fit.noise_levels.iter().flatten().enumerate().any(quiet)
}

/// Fits the records, with the noise model that was asked for or the one that they show.
pub(super) fn fitted(records: &[Record], options: &Options) -> Result<Fitted, ReconstructError> {
    let stage = starts::first_stage(records, options)?;
    let open = options.noise == NoiseModel::Estimated
        && matches!(stage.intersection.noise.origin, NoiseOrigin::Estimated { .. });
    let second = options.likelihood(records, &stage.intersection)?;
    if !open {
        return white_noise::fitted(records, options, &second, stage);
    }
    let levels = &stage.intersection.noise.deviations;
    let white = if is_white(records, &stage.starts[0], levels, &second)? {
        let found = white_noise::fit(records, options, &second, stage.clone())?;
        if white_noise::fits(&found.doubts) && !white_noise::is_contested(&found.doubts) {
            return Ok(found);
        }
        Some(found)
    } else {
        None
    };
    let WithModelError { fit, compared } =
        model_error::fitted(records, options, levels, &stage.order)?;
    let order = fit.model.a.nrows();
    // Where the floors cost nothing, the same system is as likely with them.
    let tried = white.filter(|white| white.stage.order.order == order);
    if tried.is_some()
        || (floors_bind(records, &fit) && is_white(records, &fit.model, levels, &second)?)
    {
        // Too few states had left something that follows the signal; with these nothing does.
        let mut found = match tried {
            Some(white) => white,
            None => white_noise::at_order(records, options, &second, &stage.order, order)?,
        };
        if white_noise::fits(&found.doubts) {
            found.doubts.retain(|doubt| !white_noise::is_about_order(doubt));
            found.compared = compared;
            return Ok(found);
        }
    }
    let stage = starts::at_order(records, options, &stage.order, order)?;
    let doubts =
        doubt::doubts(records, &stage.intersection, stage.doubts.clone(), &fit, &options.noise);
    Ok(Fitted { stage, fit, doubts, compared })
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
    /// A level below this part of what the signal subspaces show is none: one sensor explains the excitation exactly.
    const COLLAPSED: f64 = 0.1;
    const TOLERANCE: f64 = 0.1;
    let short = likelihood::Options {
        hold: Some(hold),
        search: SearchOptions {
            max_steps: second.search.max_steps.min(STEPS),
            max_noise_updates: second.search.max_noise_updates.min(UPDATES),
            max_restarts: 0,
            step_tolerance: second.search.step_tolerance.max(TOLERANCE),
            level_tolerance: second.search.level_tolerance.max(TOLERANCE),
            ..second.search.clone()
        },
        ..second.clone()
    };
    let fit = match likelihood::identify(records, std::slice::from_ref(start), &short) {
        // Nothing can be evaluated there.
        Err(ReconstructError::Start { .. }) => return Ok(false),
        other => other?,
    };
    let collapsed = fit
        .noise_levels
        .iter()
        .flatten()
        .zip(levels)
        .any(|(found, level)| found.value < COLLAPSED * level);
    if collapsed {
        return Ok(false);
    }
    let test = model_error_test(records, &fit)?;
    Ok(test.statistic <= SIGNIFICANT)
}
