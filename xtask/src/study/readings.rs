//! What three sensors of a flight read.

use lti::SamplePeriod;
use nalgebra::DMatrix;
use reconstruct::{Channel, Record};

use super::signals::{Stream, normal};
use crate::TaskError;

/// The sensors, in the order of all rows and channels: sideslip, roll rate, yaw rate.
pub(super) const SENSORS: [&str; 3] = ["beta", "p", "r"];

/// The surfaces: one record is moved through each.
pub(super) const SURFACES: [&str; 2] = ["aileron", "rudder"];

/// Standard deviation of each sensor's noise, the same in all records: from the mean of the signal's root mean squares in the records, each
/// about its own mean.
pub(super) fn noise_levels(clean: &[DMatrix<f64>], signal_to_noise: f64) -> Vec<f64> {
    let level = |sensor| {
        let deviations = clean.iter().map(|y| y.row(sensor).variance().sqrt());
        deviations.sum::<f64>() / clean.len() as f64 / signal_to_noise
    };
    (0..SENSORS.len()).map(level).collect()
}

/// A record of readings with white Gaussian noise of these levels.
pub(super) fn noisy_record(
    name: &str,
    period: SamplePeriod,
    y: &DMatrix<f64>,
    levels: &[f64],
    random: &mut Stream,
) -> Result<Record, TaskError> {
    let noise = normal(SENSORS.len(), y.ncols(), random);
    let channels = SENSORS.iter().enumerate().map(|(sensor, name)| {
        let level = levels[sensor];
        let value = |k| y[(sensor, k)] + level * noise[(sensor, k)];
        Channel::new(*name, (0..y.ncols()).map(value).collect())
    });
    Record::new(name, period, channels.collect()).map_err(TaskError::computation("records"))
}
