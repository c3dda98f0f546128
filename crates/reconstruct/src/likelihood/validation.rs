//! What is asked of records, starts and options before anything is computed.

use super::cost::parameters::Layout;
use super::options::{InputDirections, Noise, Options};
use crate::error::{check_each, check_tolerance, option};
use crate::model::record::{check_compatible, refuse_constant_channels};
use crate::model::{FrequencyBand, Hold};
use crate::{ReconstructError, Record, SharedModel};

/// Checks that everything fits together, and says how many unknowns there are.
pub(super) fn check(
    records: &[Record],
    starts: &[SharedModel],
    options: &Options,
) -> Result<Layout, ReconstructError> {
    let [first, _, ..] = records else {
        return Err(ReconstructError::TooFewRecords { found: records.len(), needed: 2 });
    };
    check_compatible(records)?;
    let sensors = first.channels().len();
    if sensors < 2 {
        return Err(ReconstructError::TooFewSensors { found: sensors, needed: 2 });
    }
    refuse_constant_channels(records)?;
    check_options(records, sensors, options)?;
    let Some(start) = starts.first() else {
        return Err(option("starts", "none is given, at least one is needed".to_owned()));
    };
    let order = start.a.nrows();
    for (index, start) in starts.iter().enumerate() {
        check_start(index, start, order, records, sensors, options)?;
    }
    Ok(Layout {
        order,
        sensors,
        records: records.len(),
        feedthrough: options.measurement.feedthrough_sensors.clone(),
        hold: options.hold.unwrap_or(Hold::ZeroOrder),
    })
}

fn check_options(
    records: &[Record],
    sensors: usize,
    options: &Options,
) -> Result<(), ReconstructError> {
    if options.threads == 0 {
        return Err(option("the number of threads", "0; at least 1 is needed".to_owned()));
    }
    check_tolerance("the tolerance of the last step", options.search.step_tolerance)?;
    check_tolerance("the tolerance of the noise levels", options.search.level_tolerance)?;
    match &options.noise {
        Noise::Given(levels)
        | Noise::Estimated { first_guess: Some(levels) }
        | Noise::ModelError { first_guess: Some(levels) } => {
            check_each("noise levels", levels, sensors)?;
        }
        Noise::Estimated { first_guess: None } | Noise::ModelError { first_guess: None } => {}
        Noise::Spectra(spectra) => {
            let shapes = spectra.iter().map(|spectrum| (spectrum.samples(), spectrum.sensors()));
            let needed = records.iter().map(|record| (record.samples(), sensors));
            if !shapes.clone().eq(needed.clone()) {
                return Err(ReconstructError::Noise {
                    message: format!(
                        "spectra for (samples, sensors) {:?}, but the records have {:?}",
                        shapes.collect::<Vec<_>>(),
                        needed.collect::<Vec<_>>()
                    ),
                });
            }
        }
    }
    if let Some(FrequencyBand { lowest_rad_s, highest_rad_s }) = options.band
        && !(lowest_rad_s >= 0.0 && highest_rad_s > lowest_rad_s)
    {
        return Err(option("band", format!("from {lowest_rad_s} to {highest_rad_s} rad/s")));
    }
    options.measurement.check(records)
}

fn check_start(
    index: usize,
    start: &SharedModel,
    order: usize,
    records: &[Record],
    sensors: usize,
    options: &Options,
) -> Result<(), ReconstructError> {
    let fault = |message: String| Err(ReconstructError::Start { start: index, message });
    if order == 0 || start.a.shape() != (order, order) {
        return fault(format!("A is {:?}, {order} x {order} is needed", start.a.shape()));
    }
    if start.c.shape() != (sensors, order) {
        return fault(format!("C is {:?}, {sensors} x {order} is needed", start.c.shape()));
    }
    if start.b.len() != records.len() || start.b.iter().any(|b| b.len() != order) {
        return fault(format!(
            "b has lengths {:?}, {} vectors of length {order} are needed",
            start.b.iter().map(|b| b.len()).collect::<Vec<_>>(),
            records.len()
        ));
    }
    if let Some(feedthrough) = &start.feedthrough
        && (feedthrough.len() != records.len() || feedthrough.iter().any(|d| d.len() != sensors))
    {
        return fault(format!(
            "the feedthrough needs {} vectors of length {sensors}",
            records.len()
        ));
    }
    let vectors = start.b.iter().chain(start.feedthrough.iter().flatten());
    let finite = start.a.iter().chain(start.c.iter()).chain(vectors.flat_map(|v| v.iter()));
    if !finite.into_iter().all(|entry| entry.is_finite()) {
        return fault("an entry is not a finite number".to_owned());
    }
    let idle = |record: usize| {
        let d = start.feedthrough.as_ref().map_or(0.0, |all| {
            options
                .measurement
                .feedthrough_sensors
                .iter()
                .map(|&sensor| all[record][sensor].abs())
                .sum()
        });
        start.b[record].norm() + d == 0.0
    };
    if options.search.directions == InputDirections::AsStarted
        && let Some(record) = (0..records.len()).find(|&record| idle(record))
    {
        return fault(format!("the direction of record {record} is zero"));
    }
    Ok(())
}

#[cfg(test)]
mod tests;
