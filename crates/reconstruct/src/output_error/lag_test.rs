//! Are sensors late beside the inputs? A fit with all their lags free, beside the one without.
//!
//! A score test would be cheaper and has no power: what a lag does is in the residuals, and with them in the spectrum that weighs them.

use nalgebra::DVector;

use super::candidate::{Candidate, FIRST_LOOK};
use super::options::Lag;
use super::parametrisation::Parametrisation;
use super::spectra::Spectrum;
use crate::likelihood::Estimate;

/// A lag of so many standard errors is not chance.
const CERTAIN: f64 = 4.0;
/// A lag below this part of the sample period is how sensors are read.
const LEAST_LAG: f64 = 0.6;
/// Lags are needed where they are e^10 times as likely.
const DECISIVE: f64 = 20.0;

/// The lag of each sensor that was taken to be in time or late by so much, with all lags free; `None` where it was free already, or where nothing speaks for
/// another lag.
pub(super) fn lags_left(found: &Candidate, spectra: &[Spectrum]) -> Vec<Option<Estimate>> {
    let given = &found.parametrisation.sensor_lags;
    lags_free(found, spectra).unwrap_or_else(|| vec![None; given.len()])
}

fn lags_free(found: &Candidate, spectra: &[Spectrum]) -> Option<Vec<Option<Estimate>>> {
    let given = &found.parametrisation.sensor_lags;
    let period = spectra.first()?.period;
    let (free, start) = freed(found);
    let first = free.parameters() - free.free_lags().len();
    let fitted = Candidate::fit(free, spectra, &[start], FIRST_LOOK)?;
    if fitted.criterion > found.criterion - DECISIVE {
        return None;
    }
    let (_, covariance) = fitted.evaluation.newton()?;
    let lag = |(sensor, lag): (usize, &Lag)| {
        let k = first + sensor;
        let Lag::Given(seconds) = lag else { return None };
        let value = fitted.evaluation.parameters[k];
        let standard_error = covariance[(k, k)].max(0.0).sqrt();
        let off = (value - seconds).abs();
        (off > CERTAIN * standard_error && off > LEAST_LAG * period)
            .then_some(Estimate { value, standard_error })
    };
    Some(given.iter().enumerate().map(lag).collect())
}

/// The same form with all lags of sensors free, and its parameters where they are now. Free lags of sensors stand in the order of the sensors, in front of those
/// of the inputs.
fn freed(found: &Candidate) -> (Parametrisation, DVector<f64>) {
    let mut free = found.parametrisation.clone();
    let mut parameters = found.evaluation.parameters.clone();
    let first = free.parameters() - free.free_lags().len();
    for sensor in 0..free.sensor_lags.len() {
        if let Lag::Given(seconds) = free.sensor_lags[sensor] {
            parameters = parameters.insert_row(first + sensor, seconds);
            free.sensor_lags[sensor] = Lag::Free;
        }
    }
    (free, parameters)
}
