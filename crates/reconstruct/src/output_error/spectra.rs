//! Records and their inputs in the frequency domain.

use std::f64::consts::TAU;

use nalgebra::DMatrix;
use num_complex::Complex;
use realfft::RealFftPlanner;

use super::options::RecordedInputs;
use crate::likelihood::FrequencyBand;
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
}

impl Spectrum {
    /// Samples in so many seconds.
    pub(super) fn samples_in(&self, seconds: f64) -> usize {
        let fits = |count: &usize| *count as f64 * self.period <= seconds * (1.0 + 1e-9);
        (1_usize..).take_while(fits).last().unwrap_or(0)
    }

    /// How many real numbers the sensors have at these frequencies.
    pub(super) fn real_numbers(&self) -> f64 {
        self.weight.iter().sum::<f64>() * self.y.nrows() as f64
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
    let step = TAU / (samples as f64 * record.period().seconds());
    let kept: Vec<usize> = (1..=samples / 2).filter(|&k| band.holds(k, record)).collect();
    let fft = planner.plan_fft_forward(samples);
    let scale = 1.0 / (samples as f64).sqrt();
    let mut run = |values: &[f64]| {
        let mean = values.iter().sum::<f64>() / samples as f64;
        let mut input: Vec<f64> = values.iter().map(|value| value - mean).collect();
        let mut output = fft.make_output_vec();
        fft.process(&mut input, &mut output).map_err(|error| ReconstructError::Step {
            step: "Fourier transform",
            message: error.to_string(),
        })?;
        Ok(output.into_iter().map(|value| value * scale).collect())
    };
    let all = |signals: Vec<&[f64]>, run: &mut dyn FnMut(&[f64]) -> Result<Vec<_>, _>| {
        signals.into_iter().map(run).collect::<Result<Vec<Vec<Complex<f64>>>, ReconstructError>>()
    };
    let channels = record.channels().iter().map(|channel| &channel.values[..]).collect();
    let sensors = all(channels, &mut run)?;
    let inputs = all(inputs.iter().map(Vec::as_slice).collect(), &mut run)?;
    let at = |signals: &[Vec<Complex<f64>>]| {
        DMatrix::from_fn(signals.len(), kept.len(), |row, place| signals[row][kept[place]])
    };
    let powers: Vec<_> = sensors.iter().map(|y| smoothed_power(y, true)).collect();
    let root = |&k: &usize| {
        if 2 * k == samples {
            Complex::new(-1.0, 0.0)
        } else {
            Complex::from_polar(1.0, TAU * k as f64 / samples as f64)
        }
    };
    let z: Vec<_> = kept.iter().map(root).collect();
    let ramp = if drift {
        // Of sqrt(12) (i - (N - 1)/2) / N, a ramp without mean and of about unit variance.
        z.iter().map(|z| Complex::from(12.0_f64.sqrt() * scale) / (z.conj() - 1.0)).collect()
    } else {
        Vec::new()
    };
    Ok(Spectrum {
        period: record.period().seconds(),
        frequencies: kept.iter().map(|&k| step * k as f64).collect(),
        weight: kept.iter().map(|&k| if 2 * k == samples { 1.0 } else { 2.0 }).collect(),
        y: at(&sensors),
        u: at(&inputs),
        power: DMatrix::from_fn(sensors.len(), kept.len(), |row, place| powers[row][kept[place]]),
        z,
        ramp,
    })
}
