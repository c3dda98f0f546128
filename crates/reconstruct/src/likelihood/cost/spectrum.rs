//! A record in the frequency domain: what the sums of the likelihood run over.

use num_complex::Complex;
use realfft::RealFftPlanner;

use crate::likelihood::cost::fourier::Fourier;
use crate::likelihood::cost::missing::MissingSamples;
use crate::likelihood::cost::noise::smoothed_power;
use crate::likelihood::options::{Noise, Options};
use crate::model::noise_spectrum::inverse_of_hermitian;
use crate::model::record::rms;
use crate::{Offsets, ReconstructError, Record, Trend};

/// A known signal that enters a record with unknown coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entry {
    /// Into the state alone: the difference of the initial and the final state.
    State,
    /// Into the state and those sensors that read inputs directly: a recorded input.
    StateAndFeedthrough,
    /// Into each sensor: a trend.
    Sensors,
}

/// One record at the frequencies that are used, each sensor divided by its unit.
#[derive(Clone, Debug)]
pub(crate) struct RecordSpectrum {
    /// z = exp(2 pi j k / N).
    pub(crate) z: Vec<Complex<f64>>,
    /// 2 inside, 1 at frequency zero and at half the sampling frequency.
    pub(crate) weight: Vec<f64>,
    /// The sensors, m per frequency: N^(-1/2) sum y(i) z^-i over the unit.
    pub(crate) y: Vec<Complex<f64>>,
    /// How each factor enters.
    pub(crate) entries: Vec<Entry>,
    /// The factors' transforms, one per entry and frequency.
    pub(crate) factors: Vec<Complex<f64>>,
    /// Inverse noise covariances, m x m per frequency (symmetric storage does not matter: row by row); `None` for white noise.
    pub(crate) precision: Option<Vec<Complex<f64>>>,
    /// Smoothed power of each sensor, m per frequency, in units squared: what a relative model error is a part of. `None` where there is none.
    pub(crate) power: Option<Vec<f64>>,
    /// Variances that offsets add at frequency zero, which is then the first one; zero where offsets are not random.
    pub(crate) offset_variance: Vec<f64>,
    /// Whether the first frequency is zero.
    pub(crate) starts_at_zero: bool,
    /// Samples that are unknown, if there are any; `y` is that of some values in their places.
    pub(crate) missing: Option<MissingSamples>,
}

impl RecordSpectrum {
    pub(crate) fn frequencies(&self) -> usize {
        self.z.len()
    }

    /// The same without frequency zero.
    pub(crate) fn without_zero(&self) -> Self {
        let mut rest = self.clone();
        if self.starts_at_zero {
            let (m, entries) = (self.offset_variance.len(), self.entries.len());
            rest.z.remove(0);
            rest.weight.remove(0);
            rest.y.drain(..m);
            rest.factors.drain(..entries);
            if let Some(precision) = &mut rest.precision {
                precision.drain(..m * m);
            }
            if let Some(power) = &mut rest.power {
                power.drain(..m);
            }
            if let Some(missing) = &mut rest.missing {
                missing.without_first_frequency(m);
            }
            rest.starts_at_zero = false;
        }
        rest
    }

    /// The variance of a sensor's noise at one frequency, for noise that is independent between sensors: its own, an offset's at frequency zero, and
    /// the model error's.
    pub(crate) fn variance(&self, k: usize, sensor: usize, variances: &[f64]) -> f64 {
        let m = self.offset_variance.len();
        let offset = if k == 0 && self.starts_at_zero { self.offset_variance[sensor] } else { 0.0 };
        let model_error = match (&self.power, variances.get(m)) {
            (Some(power), Some(square)) => square * power[k * m + sensor],
            _ => 0.0,
        };
        variances[sensor] + offset + model_error
    }

    /// Real residuals: (m - 1) for each real number of the transform, less one for each missing sample of a sensor.
    pub(crate) fn residuals(&self, sensors: usize) -> f64 {
        let missing = self.missing.as_ref().map_or(0, |missing| missing.cells.len());
        self.weight.iter().sum::<f64>() * (sensors - 1) as f64 - missing as f64
    }
}

/// The transform of one record at the frequencies that the options leave.
pub(crate) fn transform(
    record: &Record,
    index: usize,
    units: &[f64],
    options: &Options,
    planner: &mut RealFftPlanner<f64>,
) -> Result<RecordSpectrum, ReconstructError> {
    let samples = record.samples();
    let fourier = Fourier::new(samples, kept_frequencies(record, options), planner);
    let run = |values: &[f64], unit: f64| fourier.of(values.iter().map(|value| value / unit));
    let channels = record
        .channels()
        .iter()
        .zip(units)
        .map(|(channel, &unit)| run(&channel.values, unit))
        .collect::<Result<Vec<_>, _>>()?;
    let known = options.measurement.known_inputs.get(index).map_or(&[][..], Vec::as_slice);
    let inputs = known.iter().map(|input| run(input, rms(input))).collect::<Result<Vec<_>, _>>()?;
    let (z, weight, kept) = (fourier.z(), fourier.weight(), &fourier.kept);
    let mut entries = vec![Entry::State];
    entries.extend(inputs.iter().map(|_| Entry::StateAndFeedthrough));
    let mut ramp = Vec::new();
    if options.measurement.trend == Trend::Linear {
        entries.push(Entry::Sensors);
        ramp = fourier.ramp();
    }
    let mut factors = Vec::with_capacity(entries.len() * kept.len());
    for (place, (&k, &z)) in kept.iter().zip(&z).enumerate() {
        factors.push(z);
        factors.extend(inputs.iter().map(|input| input[k]));
        factors.extend(ramp.get(place));
    }
    let y = kept.iter().flat_map(|&k| channels.iter().map(move |channel| channel[k])).collect();
    let starts_at_zero = kept.first() == Some(&0);
    let offset_variance = match &options.measurement.offsets {
        Offsets::PriorDeviation(deviations) if starts_at_zero => deviations
            .iter()
            .zip(units)
            .map(|(deviation, unit)| samples as f64 * (deviation / unit).powi(2))
            .collect(),
        _ => vec![0.0; units.len()],
    };
    let precision = match &options.noise {
        Noise::Spectra(spectra) => {
            Some(precisions(&spectra[index], kept, units, &offset_variance)?)
        }
        _ => None,
    };
    let power = matches!(options.noise, Noise::ModelError { .. }).then(|| {
        let centred = options.measurement.offsets != Offsets::Zero;
        let smooth: Vec<_> = channels.iter().map(|y| smoothed_power(y, centred)).collect();
        kept.iter().flat_map(|&k| smooth.iter().map(move |power| power[k])).collect()
    });
    Ok(RecordSpectrum {
        z,
        weight,
        y,
        entries,
        factors,
        precision,
        power,
        offset_variance,
        starts_at_zero,
        missing: MissingSamples::new(record, kept.clone(), planner),
    })
}

fn kept_frequencies(record: &Record, options: &Options) -> Vec<usize> {
    let samples = record.samples();
    let first = usize::from(options.measurement.offsets == Offsets::Free);
    let inside = |k: &usize| options.band.is_none_or(|band| band.holds(*k, record));
    (first..=samples / 2).filter(inside).collect()
}

fn precisions(
    spectrum: &crate::model::NoiseSpectrum,
    kept: &[usize],
    units: &[f64],
    offset_variance: &[f64],
) -> Result<Vec<Complex<f64>>, ReconstructError> {
    let sensors = units.len();
    let mut all = Vec::with_capacity(kept.len() * sensors * sensors);
    for &k in kept {
        let mut scaled = spectrum.covariances()[k].clone();
        for i in 0..sensors {
            for l in 0..sensors {
                scaled[(i, l)] /= units[i] * units[l];
            }
            if k == 0 {
                scaled[(i, i)] += offset_variance[i];
            }
        }
        let inverse = inverse_of_hermitian(&scaled).ok_or_else(|| ReconstructError::Noise {
            message: format!("the covariance at frequency {k} cannot be inverted"),
        })?;
        for i in 0..sensors {
            all.extend((0..sensors).map(|l| inverse[(i, l)]));
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests;
