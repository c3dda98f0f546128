//! A record: what the sensors of one system read while one unknown input excited it.

use lti::SamplePeriod;

use super::gap_filling::fill;
use crate::ReconstructError;

/// Uniformly sampled sensor signals of one system, excited through one input that nobody measured.
///
/// | part | shape | unit |
/// |---|---|---|
/// | channels | m of them, each with N samples | the sensor's |
/// | sample period | | s |
///
/// The first channel is the pseudo input of the transmissibilities, the others are pseudo outputs. All samples are finite, all
/// channels have the same length, and no two share a name.
///
/// Samples may be missing, see [`Record::with_missing`]. The channels then hold interpolated values in their places, and the methods treat these as
/// unknown: likelihoods are those of the samples that are there, and no window of a block-Hankel matrix touches the others.
///
/// # Example
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::{Channel, Record};
///
/// let record = Record::new(
///     "aileron",
///     SamplePeriod::new(0.1)?,
///     vec![Channel::new("beta", vec![0.0, 0.1, 0.3]), Channel::new("p", vec![0.0, 0.5, 0.4])],
/// )?;
/// assert_eq!(record.samples(), 3);
/// assert_eq!(record.channels()[1].name, "p");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    name: String,
    period: SamplePeriod,
    channels: Vec<Channel>,
    /// For each channel the missing samples, ascending.
    missing: Vec<Vec<usize>>,
}

/// One sensor's signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// What the sensor is called, for example `beta`.
    pub name: String,
    /// Its samples, in the sensor's unit.
    pub values: Vec<f64>,
}

impl Channel {
    /// A named signal. It is checked when a [`Record`] is made of it.
    pub fn new(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self { name: name.into(), values }
    }
}

impl Record {
    /// Checks the channels and binds them into a record.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::EmptyRecord`] without channels or samples, [`ReconstructError::UnequalChannels`],
    /// [`ReconstructError::RepeatedChannel`] and [`ReconstructError::NotFinite`], each naming the record and the channel.
    pub fn new(
        name: impl Into<String>,
        period: SamplePeriod,
        channels: Vec<Channel>,
    ) -> Result<Self, ReconstructError> {
        let name = name.into();
        let samples = channels.first().map_or(0, |first| first.values.len());
        if samples == 0 {
            return Err(ReconstructError::EmptyRecord { record: name });
        }
        for (index, channel) in channels.iter().enumerate() {
            if channel.values.len() != samples {
                return Err(ReconstructError::UnequalChannels {
                    record: name,
                    channel: channel.name.clone(),
                    found: channel.values.len(),
                    expected: samples,
                });
            }
            if channels[..index].iter().any(|other| other.name == channel.name) {
                return Err(ReconstructError::RepeatedChannel {
                    record: name,
                    channel: channel.name.clone(),
                });
            }
            if let Some(sample) = channel.values.iter().position(|value| !value.is_finite()) {
                return Err(ReconstructError::NotFinite {
                    record: name,
                    channel: channel.name.clone(),
                    sample,
                });
            }
        }
        let missing = vec![Vec::new(); channels.len()];
        Ok(Self { name, period, channels, missing })
    }

    /// The same where samples may be missing: those that are NaN.
    ///
    /// # Errors
    ///
    /// Those of [`Record::new`]; [`ReconstructError::NotFinite`] for infinite samples and for a channel of which all samples are missing.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::SamplePeriod;
    /// use reconstruct::{Channel, Record};
    ///
    /// let beta = Channel::new("beta", vec![0.0, 1.0, f64::NAN, 3.0]);
    /// let p = Channel::new("p", vec![0.0, 0.5, 0.4, 0.2]);
    /// let record = Record::with_missing("aileron", SamplePeriod::new(0.1)?, vec![beta, p])?;
    /// assert_eq!(record.missing(0), [2]);
    /// assert!(record.missing(1).is_empty());
    /// assert_eq!(record.missing_rows(), 1);
    /// // Nothing is NaN: missing samples are interpolated.
    /// assert_eq!(record.channels()[0].values[2], 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_missing(
        name: impl Into<String>,
        period: SamplePeriod,
        mut channels: Vec<Channel>,
    ) -> Result<Self, ReconstructError> {
        let missing = channels.iter_mut().map(|channel| fill(&mut channel.values)).collect();
        Ok(Self { missing, ..Self::new(name, period, channels)? })
    }

    /// The missing samples of a channel, ascending; none of a channel that is not there.
    #[must_use]
    pub fn missing(&self, channel: usize) -> &[usize] {
        self.missing.get(channel).map_or(&[], Vec::as_slice)
    }

    /// At how many times a sample of any channel is missing.
    #[must_use]
    pub fn missing_rows(&self) -> usize {
        let mut rows: Vec<usize> = self.missing.iter().flatten().copied().collect();
        rows.sort_unstable();
        rows.dedup();
        rows.len()
    }

    /// The channels with NaN in the place of each missing sample, as [`Record::with_missing`] takes them.
    #[must_use]
    pub fn marked(&self) -> Vec<Channel> {
        let mut channels = self.channels.clone();
        for (channel, missing) in channels.iter_mut().zip(&self.missing) {
            missing.iter().for_each(|&sample| channel.values[sample] = f64::NAN);
        }
        channels
    }

    /// What the record is called, for messages and tables.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Time between two samples.
    #[must_use]
    pub fn period(&self) -> SamplePeriod {
        self.period
    }

    /// The number of samples of each channel, N.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.channels.first().map_or(0, |first| first.values.len())
    }

    /// All channels, in the order in which they were given.
    #[must_use]
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// Channel `index`, counted from 0.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::NoSuchChannel`].
    pub fn get(&self, index: usize) -> Result<&Channel, ReconstructError> {
        self.channels.get(index).ok_or_else(|| ReconstructError::NoSuchChannel {
            record: self.name.clone(),
            index,
            channels: self.channels.len(),
        })
    }

    /// The index of the channel of that name.
    #[must_use]
    pub fn position(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.name == name)
    }
}

/// Refuses records that cannot come from one system's sensors: other channels or another sample period.
///
/// # Errors
///
/// [`ReconstructError::DifferentSampling`] where periods differ by more than one part in a million (a thousandth of a sample over a
/// thousand of them), [`ReconstructError::DifferentChannels`] where names or their order differ.
pub(crate) fn check_compatible(records: &[Record]) -> Result<(), ReconstructError> {
    const PERIOD_TOLERANCE: f64 = 1e-6;
    let Some((first, others)) = records.split_first() else {
        return Ok(());
    };
    for other in others {
        let (expected_s, found_s) = (first.period.seconds(), other.period.seconds());
        if (found_s - expected_s).abs() > PERIOD_TOLERANCE * expected_s {
            return Err(ReconstructError::DifferentSampling {
                first: first.name.clone(),
                expected_s,
                second: other.name.clone(),
                found_s,
            });
        }
        if !first
            .channels
            .iter()
            .map(|channel| &channel.name)
            .eq(other.channels.iter().map(|channel| &channel.name))
        {
            let names = |record: &Record| {
                record
                    .channels
                    .iter()
                    .map(|channel| channel.name.as_str())
                    .collect::<Vec<_>>()
                    .join(", ")
            };
            return Err(ReconstructError::DifferentChannels {
                first: first.name.clone(),
                expected: names(first),
                second: other.name.clone(),
                found: names(other),
            });
        }
    }
    Ok(())
}

/// A sensor that reads the same throughout says nothing, and as a pseudo input would make any answer possible.
pub(crate) fn refuse_constant_channels(records: &[Record]) -> Result<(), ReconstructError> {
    for record in records {
        let dead = record.channels().iter().find(|channel| {
            channel.values.windows(2).all(|pair| pair[0].total_cmp(&pair[1]).is_eq())
        });
        if let Some(channel) = dead {
            return Err(ReconstructError::ConstantChannel {
                record: record.name().to_owned(),
                channel: channel.name.clone(),
                value: channel.values[0],
            });
        }
    }
    Ok(())
}

/// The root mean square of a size over all records.
pub(crate) fn over_all(records: &[Record], size: impl Fn(&Record) -> f64) -> f64 {
    let square: f64 = records.iter().map(|record| size(record).powi(2)).sum();
    (square / records.len() as f64).sqrt()
}

/// The root mean square of a sensor about its mean, over all records.
pub(crate) fn deviation(records: &[Record], sensor: usize) -> f64 {
    over_all(records, |record| {
        let values = &record.channels()[sensor].values;
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        rms(&values.iter().map(|value| value - mean).collect::<Vec<f64>>())
    })
}

/// Root mean square, 1 for a signal that is zero throughout.
pub(crate) fn rms(values: &[f64]) -> f64 {
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    if largest == 0.0 {
        return 1.0;
    }
    let mean = values.iter().map(|value| (value / largest).powi(2)).sum::<f64>();
    largest * (mean / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests;
