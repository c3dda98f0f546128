//! Records and their inputs in the frequency domain.

use std::f64::consts::TAU;

use nalgebra::DMatrix;
use num_complex::Complex;
use realfft::RealFftPlanner;

use super::options::RecordedInputs;
use crate::likelihood::FrequencyBand;
use crate::likelihood::cost::fourier::Fourier;
use crate::likelihood::cost::missing::MissingSamples;
use crate::likelihood::cost::noise::smoothed_power;
use crate::{ReconstructError, Record};

/// One record at the frequencies that are used; frequency zero, where offsets are, is never among them.
#[derive(Clone, Debug)]
pub(super) struct Spectrum {
    /// In s.
    pub(super) period: f64,
    /// In rad/s.
    pub(super) frequencies: Vec<f64>,
    /// z = exp(2 pi j k / N).
    pub(super) z: Vec<Complex<f64>>,
    /// Real numbers at each frequency: 2 inside, 1 at half the sampling frequency.
    pub(super) weight: Vec<f64>,
    /// The sensors, m x F: N^(-1/2) sum y(i) z^-i.
    pub(super) y: DMatrix<Complex<f64>>,
    /// The recorded inputs, in the same way.
    pub(super) u: DMatrix<Complex<f64>>,
    /// Smoothed power of each sensor, m x F.
    pub(super) power: DMatrix<f64>,
    /// The transform of a ramp, where sensors drift; empty where they do not.
    pub(super) ramp: Vec<Complex<f64>>,
    /// Samples that are missing; `y` is that of interpolated values in their places.
    pub(super) missing: Option<MissingSamples>,
}

impl Spectrum {
    /// Samples in so many seconds.
    pub(super) fn samples_in(&self, seconds: f64) -> usize {
        let fits = |count: &usize| *count as f64 * self.period <= seconds * (1.0 + 1e-9);
        (1_usize..).take_while(fits).last().unwrap_or(0)
    }

    /// How many real numbers the sensors have at these frequencies; of samples that are missing they lack their share.
    pub(super) fn real_numbers(&self) -> f64 {
        let numbers = self.weight.iter().sum::<f64>() * self.y.nrows() as f64;
        self.missing
            .as_ref()
            .map_or(numbers, |missing| numbers * missing.part_present(self.y.nrows()))
    }
}

/// Transforms all records.
pub(super) fn spectra(
    records: &[Record],
    inputs: &RecordedInputs,
    band: FrequencyBand,
    drift: bool,
) -> Result<Vec<Spectrum>, ReconstructError> {
    let mut planner = RealFftPlanner::new();
    records
        .iter()
        .zip(&inputs.signals)
        .map(|(record, signals)| transform(record, signals, band, drift, &mut planner))
        .collect()
}

fn transform(
    record: &Record,
    inputs: &[Vec<f64>],
    band: FrequencyBand,
    drift: bool,
    planner: &mut RealFftPlanner<f64>,
) -> Result<Spectrum, ReconstructError> {
    let samples = record.samples();
    let kept = (1..=samples / 2).filter(|&k| band.holds(k, record)).collect();
    let fourier = Fourier::new(samples, kept, planner);
    let run = |values: &Vec<f64>| {
        let mean = values.iter().sum::<f64>() / samples as f64;
        fourier.of(values.iter().map(|value| value - mean))
    };
    let channels = record.channels().iter().map(|channel| &channel.values);
    let sensors = channels.map(run).collect::<Result<Vec<_>, _>>()?;
    let inputs = inputs.iter().map(run).collect::<Result<Vec<_>, _>>()?;
    let kept = &fourier.kept;
    let at = |signals: &[Vec<Complex<f64>>]| {
        DMatrix::from_fn(signals.len(), kept.len(), |row, place| signals[row][kept[place]])
    };
    let powers: Vec<_> = sensors.iter().map(|y| smoothed_power(y, true)).collect();
    let step = TAU / (samples as f64 * record.period().seconds());
    Ok(Spectrum {
        period: record.period().seconds(),
        frequencies: kept.iter().map(|&k| step * k as f64).collect(),
        z: fourier.z(),
        weight: fourier.weight(),
        y: at(&sensors),
        u: at(&inputs),
        power: DMatrix::from_fn(sensors.len(), kept.len(), |row, place| powers[row][kept[place]]),
        ramp: if drift { fourier.ramp() } else { Vec::new() },
        missing: MissingSamples::new(record, kept.clone(), planner),
    })
}
