//! What can be wrong with records, pairs and options.

/// Why records could not be turned into a reconstruction.
///
/// Numerical doubt is not an error: condition numbers, residuals and spreads are part of the result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReconstructError {
    /// A record without channels or without samples.
    #[error("record {record:?} holds no samples")]
    EmptyRecord {
        /// The record's name.
        record: String,
    },
    /// Channels of different length.
    #[error(
        "record {record:?}: channel {channel:?} has {found} samples, the first channel has {expected}"
    )]
    UnequalChannels {
        /// The record's name.
        record: String,
        /// The channel that differs.
        channel: String,
        /// Its number of samples.
        found: usize,
        /// That of the first channel.
        expected: usize,
    },
    /// Two channels with one name.
    #[error("record {record:?}: channel {channel:?} is there twice")]
    RepeatedChannel {
        /// The record's name.
        record: String,
        /// The repeated name.
        channel: String,
    },
    /// An infinite or undefined sample.
    #[error("record {record:?}: sample {sample} of channel {channel:?} is not a finite number")]
    NotFinite {
        /// The record's name.
        record: String,
        /// The channel.
        channel: String,
        /// Index of the first such sample, from 0.
        sample: usize,
    },
    /// An index beyond the channels of a record.
    #[error("record {record:?} has {channels} channel(s), so that there is none of index {index}")]
    NoSuchChannel {
        /// The record's name.
        record: String,
        /// The index asked for.
        index: usize,
        /// How many channels there are.
        channels: usize,
    },
    /// Fewer records than the method needs.
    #[error("{found} record(s), but {needed} are needed, each with an excitation of its own")]
    TooFewRecords {
        /// How many were given.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// Fewer sensors than the method needs.
    #[error(
        "{found} sensor channel(s), but {needed} are needed: one pseudo input and two pseudo outputs, so that \
         eigenvalues can be told from the zeros of one pair of sensors"
    )]
    TooFewSensors {
        /// How many were given.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A sensor that reads the same number throughout.
    #[error(
        "record {record:?}: channel {channel:?} is constant, {value} throughout: a sensor that reads the excitation is needed"
    )]
    ConstantChannel {
        /// The record's name.
        record: String,
        /// The channel.
        channel: String,
        /// What it reads.
        value: f64,
    },
    /// A zero that is not a finite number.
    #[error("zero {index} of difference {difference} is not a finite number")]
    ZeroNotFinite {
        /// Index of the difference.
        difference: usize,
        /// Index of the zero in its list.
        index: usize,
    },
    /// Records with different sample periods.
    #[error(
        "record {second:?} is sampled every {found_s} s, record {first:?} every {expected_s} s: resample one of them"
    )]
    DifferentSampling {
        /// The first record.
        first: String,
        /// Its sample period in seconds.
        expected_s: f64,
        /// The record that differs.
        second: String,
        /// Its sample period in seconds.
        found_s: f64,
    },
    /// Records with different channels.
    #[error(
        "record {second:?} has channels {found}, record {first:?} has {expected}: the same sensors are needed, in the same order"
    )]
    DifferentChannels {
        /// The first record.
        first: String,
        /// Its channels.
        expected: String,
        /// The record that differs.
        second: String,
        /// Its channels.
        found: String,
    },
    /// A tolerance that is not a positive, finite number.
    #[error("{name} is {value}, but must be positive and finite")]
    InvalidTolerance {
        /// Which option.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The determinant's degree contradicts Theorem 3.1.
    #[error(
        "det Delta has degree {degree}, which is neither zero identically nor at least the order {order}: \
         the two transmissibilities do not belong to one system of that order"
    )]
    NotOneSystem {
        /// Degree found.
        degree: usize,
        /// Order claimed.
        order: usize,
    },
    /// Two transmissibilities that agree: their difference has no zeros to offer.
    #[error(
        "records {first:?} and {second:?} give the same transmissibility from {input:?} to {output:?}: \
         they need excitations that enter the system differently"
    )]
    SameExcitation {
        /// The first record.
        first: String,
        /// The second record.
        second: String,
        /// The pseudo input.
        input: String,
        /// The pseudo output.
        output: String,
    },
    /// More unknowns than the sensors of all records can tell.
    #[error(
        "{records} record(s) of {sensors} sensor(s): J (m - 1) = {} must exceed m = {sensors}, {}",
        .records * .sensors.saturating_sub(1),
        identifiability_hint(*.sensors)
    )]
    NotIdentifiable {
        /// The number of records, J.
        records: usize,
        /// The number of sensors, m.
        sensors: usize,
    },
    /// A record that reads zero throughout.
    #[error(
        "record {record:?} is zero throughout: nothing excited the system, or nothing was recorded"
    )]
    ZeroRecord {
        /// The record's name.
        record: String,
    },
    /// Two channels that are multiples of each other.
    #[error(
        "channels {first:?} and {second:?} are the same signal up to the factor {factor:.3e} in all records: leave one of them out"
    )]
    DuplicatedChannel {
        /// The first channel.
        first: String,
        /// Its double.
        second: String,
        /// What the first must be multiplied with to give the second.
        factor: f64,
    },
    /// A record with too few samples for its block rows.
    #[error(
        "record {record:?} has {samples} samples, but {block_rows} block rows of {sensors} sensors need {needed}"
    )]
    RecordTooShort {
        /// The record's name.
        record: String,
        /// How many samples it has.
        samples: usize,
        /// How many are needed.
        needed: usize,
        /// The number of block rows, L.
        block_rows: usize,
        /// The number of sensors, m.
        sensors: usize,
    },
    /// Too few block rows for the order.
    #[error(
        "{order} states from {records} record(s) of {sensors} sensors need {needed} block rows (L >= (J - 1) n / (J (m - 1) - m) and L > n), \
         not {block_rows}"
    )]
    TooFewBlockRows {
        /// The number of block rows given, L.
        block_rows: usize,
        /// How many are needed.
        needed: usize,
        /// The order, n.
        order: usize,
        /// The number of records, J.
        records: usize,
        /// The number of sensors, m.
        sensors: usize,
    },
    /// An order below one.
    #[error("an order of {order} was asked for, but a system has at least one state")]
    InvalidOrder {
        /// The order asked for.
        order: usize,
    },
    /// An order that the shortest record cannot tell.
    #[error(
        "an order of {order} needs {needed} samples with {sensors} sensors, but record {record:?} has {samples}: \
         it can tell {largest} state(s)"
    )]
    OrderTooHigh {
        /// The order asked for.
        order: usize,
        /// The shortest record.
        record: String,
        /// How many samples it has.
        samples: usize,
        /// How many are needed.
        needed: usize,
        /// The largest order that it can tell.
        largest: usize,
        /// The number of sensors, m.
        sensors: usize,
    },
    /// Noise levels that don't match the sensors.
    #[error("{found} noise level(s) for {sensors} sensor(s)")]
    NoiseLevelCount {
        /// How many were given.
        found: usize,
        /// The number of sensors.
        sensors: usize,
    },
    /// A noise level that is not a positive, finite number.
    #[error("the noise level of sensor {channel:?} is {value}, but must be positive and finite")]
    InvalidNoiseLevel {
        /// The sensor.
        channel: String,
        /// Its level.
        value: f64,
    },
    /// A quiet record whose covariance is singular.
    #[error(
        "the quiet record {record:?} shows noise in {rank} of {rows} directions only: one with the noise of every sensor is needed"
    )]
    SilentRecord {
        /// The quiet record.
        record: String,
        /// Number of directions with noise.
        rank: usize,
        /// Number of directions, m L.
        rows: usize,
    },
    /// One transmissibility could not be identified.
    #[error("record {record:?}, transmissibility from {input:?} to {output:?}: {message}")]
    Identification {
        /// The record.
        record: String,
        /// The pseudo input.
        input: String,
        /// The pseudo output.
        output: String,
        /// What went wrong, with its numbers.
        message: String,
    },
    /// Noise that has no covariance, or not that of these records.
    #[error("noise: {message}")]
    Noise {
        /// What is wrong, with its numbers.
        message: String,
    },
    /// A start that does not fit the records.
    #[error("start {start}: {message}")]
    Start {
        /// Index of the start.
        start: usize,
        /// What is wrong, with its numbers.
        message: String,
    },
    /// An option that does not fit the records.
    #[error("{name}: {message}")]
    Option {
        /// Which option.
        name: &'static str,
        /// What is wrong, with its numbers.
        message: String,
    },
    /// Fewer residuals than parameters.
    #[error(
        "the frequencies used give {residuals} residuals for {parameters} parameters: longer records, more sensors or a wider band are needed"
    )]
    TooFewSamples {
        /// Real residuals, (m - 1) for each sample.
        residuals: f64,
        /// Parameters to be determined, transients included.
        parameters: f64,
    },
    /// A polynomial or realization step failed.
    #[error("{step}: {message}")]
    Step {
        /// Which step.
        step: &'static str,
        /// What went wrong, with its numbers.
        message: String,
    },
}

/// How many records would do.
fn identifiability_hint(sensors: usize) -> String {
    match sensors {
        0 | 1 => "which no number of records of one sensor does: two sensors and three records, or three sensors and two records are needed".to_owned(),
        _ => format!("which takes {} records of these sensors", sensors / (sensors - 1) + 1),
    }
}

/// A tolerance must be positive and finite: zero would make every comparison of computed numbers fail.
pub(crate) fn check_tolerance(name: &'static str, value: f64) -> Result<(), ReconstructError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(ReconstructError::InvalidTolerance { name, value })
    }
}

/// One positive number for each sensor.
pub(crate) fn check_each(
    name: &'static str,
    values: &[f64],
    sensors: usize,
) -> Result<(), ReconstructError> {
    if values.len() != sensors {
        return Err(option(name, format!("{} values for {sensors} sensors", values.len())));
    }
    values.iter().try_for_each(|&value| check_tolerance(name, value))
}

/// An option that does not fit the records or another one.
pub(crate) fn option(name: &'static str, message: String) -> ReconstructError {
    ReconstructError::Option { name, message }
}
