//! results.json: every check, and the aircraft's numbers in full precision.

use num_complex::Complex;
use serde::Serialize;

use super::check::Check;
use super::flight::Flight;
use crate::TaskError;

#[derive(Serialize)]
struct Results<'a> {
    checks: &'a [&'a Check],
    aircraft: Aircraft,
}

#[derive(Serialize)]
struct Aircraft {
    shared_zeros: Vec<[f64; 2]>,
    eigenvalues: Vec<[f64; 2]>,
    true_eigenvalues: Vec<[f64; 2]>,
}

pub(crate) fn json(checks: &[&Check], flight: &Flight) -> Result<String, TaskError> {
    let pairs = |values: Vec<Complex<f64>>| values.into_iter().map(|z| [z.re, z.im]).collect();
    let truth = flight.continuous.poles().map_err(TaskError::computation("aircraft"))?;
    let results = Results {
        checks,
        aircraft: Aircraft {
            shared_zeros: pairs(flight.result.shared.values()),
            eigenvalues: pairs(flight.result.modes.iter().map(|mode| mode.eigenvalue).collect()),
            true_eigenvalues: pairs(truth),
        },
    };
    let mut text =
        serde_json::to_string_pretty(&results).map_err(TaskError::computation("results.json"))?;
    text.push('\n');
    Ok(text)
}
