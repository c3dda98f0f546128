//! How the records were measured: what sensors and recorded inputs bring into them beside the response to the unknown excitation.

/// The constant that each sensor adds to its readings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Offsets {
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
/// assert_eq!((&measurement.offsets, measurement.trend), (&Offsets::Zero, Trend::Absent));
/// // The third sensor is an accelerometer: it reads the excitation directly.
/// measurement.feedthrough_sensors = vec![2];
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Measurement {
    /// Sensor offsets; by default zero, since leaving frequency zero out multiplies the standard error of slow modes (by 30 for the roll mode
    /// of a 30 s record).
    pub offsets: Offsets,
    /// Drift of the sensors; by default absent.
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
            offsets: Offsets::Zero,
            trend: Trend::Absent,
            feedthrough_sensors: Vec::new(),
            known_inputs: Vec::new(),
        }
    }
}
