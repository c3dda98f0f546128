//! One run: the default settings on one pair of records, beside the truth.

use nalgebra::DMatrix;
use num_complex::Complex;
use reconstruct::{FoundMode, Options, Reconstruction, reconstruct};
use serde::{Deserialize, Serialize};

use crate::shared::modes::TrueModes;
use crate::shared::simulator_flights::Flight;

/// What became of one flight: what was found, or why nothing was.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outcome {
    pub(super) result: Result<Found, String>,
}

/// What the records gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Found {
    /// Spiral, roll, Dutch roll.
    pub(super) modes: [JudgedMode; 3],
    /// The codes of the doubts, each once. The program ends with 0 where there is none.
    pub(super) doubts: Vec<String>,
    /// The number of states.
    pub(super) order: usize,
    /// Relative, where the fit has one.
    pub(super) model_error: Option<f64>,
    /// The frequencies used, in rad/s; all where there is none.
    pub(super) band_rad_s: Option<[f64; 2]>,
}

/// The eigenvalue closest to a true one, and how far off it is, in 1/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct JudgedMode {
    /// |s - true s|.
    pub(super) error: f64,
    /// Real part of s - true s.
    pub(super) real_error: f64,
    /// The standard error that the fit states of the real part; `None` where it states none.
    pub(super) standard_error: Option<f64>,
}

impl JudgedMode {
    /// The error of the real part in standard errors.
    pub(super) fn score(&self) -> Option<f64> {
        self.standard_error.map(|standard_error| self.real_error / standard_error)
    }
}

/// Identifies and judges; with what the surfaces did where that is given.
pub(super) fn run(flight: Flight, recorded: bool, truth: &TrueModes) -> Outcome {
    let mut options = Options::default();
    if recorded {
        options.inputs = flight.inputs;
    }
    let result = reconstruct(&flight.records, &options).map_err(|error| error.to_string());
    Outcome { result: result.and_then(|found| judged(&found, truth)) }
}

fn judged(found: &Reconstruction, truth: &TrueModes) -> Result<Found, String> {
    let estimates: Vec<Estimate> = found.modes.iter().map(Estimate::of).collect();
    let [Some(spiral), Some(roll), Some(dutch_roll)] =
        truth.list().map(|truth| judged_mode(&estimates, truth))
    else {
        return Err("no modes".to_owned());
    };
    let mut doubts: Vec<_> = found.doubts.iter().map(|doubt| doubt.code().to_owned()).collect();
    doubts.sort();
    doubts.dedup();
    let (fit, with_inputs) = (found.fit(), found.output_error());
    let band = fit.and_then(|fit| fit.options.band);
    Ok(Found {
        modes: [spiral, roll, dutch_roll],
        doubts,
        order: found.readings().map_or(0, DMatrix::ncols),
        model_error: fit
            .and_then(|fit| fit.model_error)
            .or_else(|| with_inputs.map(|fit| fit.model_error))
            .map(|error| error.value),
        band_rad_s: band
            .or_else(|| with_inputs.map(|fit| fit.band))
            .map(|band| [band.lowest_rad_s, band.highest_rad_s]),
    })
}

/// An eigenvalue and the standard error that the fit states of its real part.
struct Estimate {
    s: Complex<f64>,
    standard_error: Option<f64>,
}

impl Estimate {
    fn of(found: &FoundMode) -> Self {
        let estimate = found.estimate.as_ref();
        Self {
            s: found.mode.eigenvalue,
            standard_error: estimate.map(|mode| mode.continuous.real_standard_error()),
        }
    }
}

/// The eigenvalue closest to the true one, whatever else it may stand for: with more states than
/// the airframe has, several may.
fn judged_mode(estimates: &[Estimate], truth: Complex<f64>) -> Option<JudgedMode> {
    let off = |estimate: &Estimate| Complex::new(estimate.s.re, estimate.s.im.abs()) - truth;
    let closest = estimates.iter().min_by(|x, y| off(x).norm().total_cmp(&off(y).norm()))?;
    Some(JudgedMode {
        error: off(closest).norm(),
        real_error: off(closest).re,
        standard_error: closest.standard_error.filter(|error| error.is_finite() && *error > 0.0),
    })
}

#[cfg(test)]
mod tests;
