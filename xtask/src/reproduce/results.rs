//! results.json: every check, and the aircraft's numbers in full precision.

use num_complex::Complex;
use reconstruct::paper::containment;
use serde::Serialize;

use super::AircraftExample;
use super::check::Check;
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

pub(crate) fn json(checks: &[&Check], example: &AircraftExample) -> Result<String, TaskError> {
    let pairs = |values: Vec<Complex<f64>>| values.into_iter().map(|z| [z.re, z.im]).collect();
    let truth = example.aircraft.continuous.poles().map_err(TaskError::computation("aircraft"))?;
    let eigenvalues: Vec<_> = example.result.modes.iter().map(|mode| mode.eigenvalue).collect();
    // Each true eigenvalue in the place of the reconstructed one that is closest to it.
    let truth =
        containment(&eigenvalues, &truth).matched.into_iter().map(|(value, _)| value).collect();
    let results = Results {
        checks,
        aircraft: Aircraft {
            shared_zeros: pairs(example.result.shared.values()),
            eigenvalues: pairs(eigenvalues),
            true_eigenvalues: pairs(truth),
        },
    };
    let mut text =
        serde_json::to_string_pretty(&results).map_err(TaskError::computation("results.json"))?;
    text.push('\n');
    Ok(text)
}
