//! From records and starts to the most likely system.

use super::cost::evaluation::Problem;
use super::cost::noise::sensor_units;
use super::inference::conclusion::conclude;
use super::inference::doubt::IMPROBABLE;
use super::inference::fit::Fit;
use super::options::{Noise, Options};
use super::search::hold_selection::search_over_holds;
use super::validation;
use crate::{Measurement, Offsets, ReconstructError, Record, SharedModel};

/// Fits one system to several records.
///
/// # Errors
///
/// Records that do not fit together; [`ReconstructError::TooFewRecords`] and [`ReconstructError::TooFewSensors`] below two of each;
/// [`ReconstructError::ConstantChannel`]; [`ReconstructError::Start`] and [`ReconstructError::Option`] for starts and options that do not fit the records;
/// [`ReconstructError::Noise`] for noise that is not one; [`ReconstructError::TooFewSamples`] where there are not more residuals than parameters.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../doctest/two_decays.md")]
/// use lti::SamplePeriod;
/// use nalgebra::{DMatrix, DVector};
/// use reconstruct::SharedModel;
/// use reconstruct::likelihood::{Options, identify};
///
/// let records = two_decays(0.9, 500, 0.01)?;
/// // A start that is roughly right, and knows nothing of the directions.
/// let start = SharedModel {
///     a: DMatrix::from_row_slice(2, 2, &[0.88, 0.0, 0.0, 0.53]),
///     c: DMatrix::from_row_slice(3, 2, &[1.0, 1.1, 1.0, -0.9, 1.0, 3.0]),
///     b: vec![DVector::from_element(2, 1.0); 2],
///     feedthrough: None,
///     period: SamplePeriod::new(1.0)?,
/// };
/// let fit = identify(&records, &[start], &Options::default())?;
/// let slow = fit.modes[1].discrete;
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_standard_error());
/// assert!(slow.real_standard_error() < 1e-3);
/// let level = fit.noise_levels.as_ref().ok_or("no levels")?[0];
/// assert!((level.value - 0.01).abs() < 3.0 * level.standard_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify(
    records: &[Record],
    starts: &[SharedModel],
    options: &Options,
) -> Result<Fit, ReconstructError> {
    if options.measurement.offsets != Offsets::AsNeeded {
        return fitted(records, starts, options);
    }
    let with = |offsets| {
        let measurement = Measurement { offsets, ..options.measurement.clone() };
        Options { measurement, ..options.clone() }
    };
    if matches!(options.noise, Noise::ModelError { .. }) {
        return fitted(records, starts, &with(Offsets::Free));
    }
    let fit = fitted(records, starts, &with(Offsets::Zero))?;
    let Some(test) = fit.offset_test.filter(|test| test.p_value < IMPROBABLE) else {
        return Ok(fit);
    };
    let starts: Vec<SharedModel> = std::iter::once(&fit.model).chain(starts).cloned().collect();
    let mut free = fitted(records, &starts, &with(Offsets::Free))?;
    free.starts.remove(0);
    free.best_start = free.best_start.saturating_sub(1);
    free.offset_test = Some(test);
    Ok(free)
}

fn fitted(
    records: &[Record],
    starts: &[SharedModel],
    options: &Options,
) -> Result<Fit, ReconstructError> {
    let layout = validation::check(records, starts, options)?;
    let units = sensor_units(records, options);
    let mut problem = Problem::new(layout, records, &units, options)?;
    let residuals: f64 =
        problem.spectra.iter().map(|spectrum| spectrum.residuals(problem.layout.sensors)).sum();
    let needed = problem.layout.identifiable() as f64
        + problem
            .no_coefficients()
            .iter()
            .flatten()
            .map(|_| problem.layout.order as f64)
            .sum::<f64>();
    if residuals <= needed {
        // A sum of nothing is minus zero.
        return Err(ReconstructError::TooFewSamples {
            residuals: residuals + 0.0,
            parameters: needed,
        });
    }
    let found =
        search_over_holds(&mut problem, starts, &units, residuals, options).ok_or_else(|| {
            ReconstructError::Start {
                start: 0,
                message: "no start has a finite likelihood".to_owned(),
            }
        })?;
    conclude(records, &problem, found, &units, residuals, options)
}
