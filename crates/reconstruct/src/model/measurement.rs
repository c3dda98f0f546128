//! How the records were measured: what sensors and recorded inputs bring into them beside the response to the unknown excitation.

use crate::error::{check_each, option};
use crate::{ReconstructError, Record};

/// The constant that each sensor adds to its readings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Offsets {
    /// Zero unless the records say otherwise: a fit that takes them as zero is followed by one that leaves them free where frequency zero disagrees with all
    /// others, with a probability below 1e-4 by chance. With a relative model error they are free. Signal subspaces alone take them as zero.
    AsNeeded,
    /// The sensors read zero in trim.
    Zero,
    /// Zero on average with these standard deviations, in the sensors' units: one per sensor, drawn anew for each record.
    PriorDeviation(Vec<f64>),
    /// Anything: frequency zero is left out. That costs the slow modes most of what the record says about them.
    Free,
}

/// Slow drift of the sensors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Trend {
    /// None, unless there is a relative model error and the likelihood asks for one.
    AsNeeded,
    /// None.
    Absent,
    /// Each sensor drifts by an unknown constant rate in each record.
    Linear,
}

/// What is assumed about the sensors, and which inputs were recorded.
///
/// # Example
///
/// ```
/// use reconstruct::{Measurement, Offsets, Trend};
///
/// let mut measurement = Measurement::default();
/// assert_eq!((&measurement.offsets, measurement.trend), (&Offsets::AsNeeded, Trend::AsNeeded));
/// // The third sensor is an accelerometer: it reads the excitation directly.
/// measurement.feedthrough_sensors = vec![2];
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Measurement {
    /// Sensor offsets; by default estimated only where the records call for them, since leaving frequency zero out multiplies the standard error of
    /// slow modes (by 30 for the roll mode of a 30 s record).
    pub offsets: Offsets,
    /// Drift of the sensors; by default none unless the records call for it.
    pub trend: Trend,
    /// Indices of the sensors that read the excitation directly, as accelerometers do; by default none.
    pub feedthrough_sensors: Vec<usize>,
    /// Inputs that were recorded (a yaw damper's, say): for each record a list of signals with as many samples as the record. Empty where
    /// nothing was recorded. How they enter the state, and the sensors with feedthrough, is estimated for each record.
    pub known_inputs: Vec<Vec<Vec<f64>>>,
}

impl Default for Measurement {
    fn default() -> Self {
        Self {
            offsets: Offsets::AsNeeded,
            trend: Trend::AsNeeded,
            feedthrough_sensors: Vec::new(),
            known_inputs: Vec::new(),
        }
    }
}

impl Measurement {
    /// Refuses what does not fit the records, which have channels of the same number each.
    pub(crate) fn check(&self, records: &[Record]) -> Result<(), ReconstructError> {
        let sensors = records.first().map_or(0, |record| record.channels().len());
        if let Offsets::PriorDeviation(deviations) = &self.offsets {
            check_each("deviations of offsets", deviations, sensors)?;
        }
        for (place, &sensor) in self.feedthrough_sensors.iter().enumerate() {
            if sensor >= sensors || self.feedthrough_sensors[..place].contains(&sensor) {
                return Err(option(
                    "feedthrough sensors",
                    format!("sensor {sensor} is listed twice or beyond the {sensors} sensors"),
                ));
            }
        }
        check_known_inputs(records, &self.known_inputs)
    }
}

/// Refuses inputs that do not fit the records: for each record a list of signals as long as the record, finite and not zero throughout.
fn check_known_inputs(
    records: &[Record],
    inputs: &[Vec<Vec<f64>>],
) -> Result<(), ReconstructError> {
    const NAME: &str = "known inputs";
    if !inputs.is_empty() && inputs.len() != records.len() {
        return Err(option(
            NAME,
            format!("lists for {} of {} records", inputs.len(), records.len()),
        ));
    }
    for (record, list) in records.iter().zip(inputs) {
        for input in list {
            if input.len() != record.samples() {
                return Err(option(
                    NAME,
                    format!(
                        "record {:?} has {} samples, an input of it {}",
                        record.name(),
                        record.samples(),
                        input.len()
                    ),
                ));
            }
            if input.iter().any(|value| !value.is_finite())
                || input.iter().all(|&v| v.abs() < f64::MIN_POSITIVE)
            {
                return Err(option(
                    NAME,
                    format!(
                        "an input of record {:?} is not finite or zero throughout",
                        record.name()
                    ),
                ));
            }
        }
    }
    Ok(())
}
