//! What is known about the noise of the sensors.

use crate::Record;

/// The noise of the sensors: what is known about it, and from where.
///
/// Sensor noise is taken as white and independent from sensor to sensor, unless a quiet record shows what it is.
///
/// # Example
///
/// ```
/// use reconstruct::NoiseModel;
///
/// // A sideslip vane good to 0.5 mrad, two rate gyros good to 1 mrad/s.
/// let known = NoiseModel::Levels(vec![5e-4, 1e-3, 1e-3]);
/// assert_ne!(known, NoiseModel::default());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum NoiseModel {
    /// White, one unknown level per sensor, the same in all records, and beside it a relative model error where the records show one: both estimated
    /// from them. The default, since it needs to know nothing. See [`Noise::ModelError`](crate::likelihood::Noise::ModelError).
    #[default]
    Estimated,
    /// White and nothing else, one unknown level per sensor, the same in all records.
    White,
    /// White, with this standard deviation for each sensor, in the sensor's unit and in the order of the channels.
    Levels(Vec<f64>),
    /// Of any colour, as in this record of the same sensors under the same disturbances while nobody excited the system on purpose: the
    /// seconds before a manoeuvre. What the disturbances do to the system counts as noise, too.
    Quiet(Record),
}

impl NoiseModel {
    /// Whether levels are estimated from the records.
    pub(crate) fn is_estimated(&self) -> bool {
        matches!(self, Self::Estimated | Self::White)
    }
}
