//! What the model makes of recorded inputs in the time domain, beside what the sensors read: for plots, and for records that the fit has not seen.

use nalgebra::{DMatrix, DVector};

use super::fit::Fit;
use super::options::RecordedInputs;
use crate::error::option;
use crate::{ReconstructError, Record};

/// A record as the model has it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Simulation {
    /// The record's name.
    pub record: String,
    /// What each sensor would read: initial state, offset (and drift, where the fit has one) are those that come closest.
    pub sensors: Vec<Vec<f64>>,
    /// For each sensor 1 less the root mean square of what is left over that of the sensor about its mean: 1 is perfect, 0 no better than the mean.
    pub fit: Vec<f64>,
}

/// Simulates records with the inputs that were recorded.
///
/// # Errors
///
/// [`ReconstructError::Option`] where sensors or inputs are not those of the fit.
pub fn simulate(
    records: &[Record],
    inputs: &RecordedInputs,
    fit: &Fit,
) -> Result<Vec<Simulation>, ReconstructError> {
    let (sensors, count) = (fit.model.c().nrows(), fit.model.b().ncols());
    if inputs.names.len() != count || inputs.signals.len() != records.len() {
        return Err(option("recorded inputs", format!("the model has {count} inputs")));
    }
    records
        .iter()
        .zip(&inputs.signals)
        .map(|(record, signals)| {
            let channels = record.channels().len();
            if channels != sensors || signals.len() != count {
                let name = record.name();
                let message = format!("record {name:?} has {channels} sensors and {} inputs, the model {sensors} and {count}", signals.len());
                return Err(option("recorded inputs", message));
            }
            Ok(one(record, signals, fit))
        })
        .collect()
}

fn one(record: &Record, signals: &[Vec<f64>], fit: &Fit) -> Simulation {
    let period = record.period().seconds();
    let (n, m) = (fit.model.a().nrows(), fit.model.c().nrows());
    let samples = record.samples();
    let late: Vec<Vec<f64>> = signals
        .iter()
        .zip(&fit.input_lags)
        .map(|(signal, lag)| delayed(signal, lag.value / period))
        .collect();
    let input = |k: usize| DVector::from_fn(late.len(), |row, _| late[row][k]);
    let forced = response(fit, DVector::zeros(n), samples, input);
    let turned = |response: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
        let lags = fit.sensor_lags.iter().map(|lag| lag.value / period);
        response.iter().zip(lags).map(|(sensor, lag)| delayed(sensor, lag)).collect()
    };
    let forced = turned(forced);
    let free: Vec<Vec<Vec<f64>>> = (0..n)
        .map(|state| {
            let start = DVector::from_fn(n, |i, _| if i == state { 1.0 } else { 0.0 });
            turned(response(fit, start, samples, |_| DVector::zeros(late.len())))
        })
        .collect();
    // Unknowns: the initial state, then an offset for each sensor, then a drift.
    let own = if fit.drift { 2 } else { 1 };
    let unknowns = n + own * m;
    let (mut gram, mut right) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
    let column = |sensor: usize, k: usize| {
        let mut row = DVector::zeros(unknowns);
        for (state, free) in free.iter().enumerate() {
            row[state] = free[sensor][k];
        }
        row[n + sensor] = 1.0;
        if fit.drift {
            row[n + m + sensor] = k as f64 / samples as f64 - 0.5;
        }
        row
    };
    let sizes: Vec<f64> = record.channels().iter().map(|channel| spread(&channel.values)).collect();
    for (sensor, channel) in record.channels().iter().enumerate() {
        let weight = 1.0 / (sizes[sensor] * sizes[sensor]).max(f64::MIN_POSITIVE);
        for (k, value) in channel.values.iter().enumerate() {
            let row = column(sensor, k);
            right += &row * (weight * (value - forced[sensor][k]));
            gram.ger(weight, &row, &row, 1.0);
        }
    }
    let scale =
        gram.diagonal().map(|entry: f64| if entry > 0.0 { 1.0 / entry.sqrt() } else { 0.0 });
    let unit = DMatrix::from_fn(unknowns, unknowns, |i, k| gram[(i, k)] * scale[i] * scale[k]);
    let solved = unit.svd(true, true).solve(&right.component_mul(&scale), 1e-12);
    let best =
        solved.map_or_else(|_| DVector::zeros(unknowns), |found| found.component_mul(&scale));
    let sensors: Vec<Vec<f64>> = (0..m)
        .map(|sensor| {
            (0..samples).map(|k| forced[sensor][k] + column(sensor, k).dot(&best)).collect()
        })
        .collect();
    let fits = record.channels().iter().zip(&sensors).zip(&sizes).map(|((read, found), size)| {
        let squares = read.values.iter().zip(found).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        1.0 - (squares / samples as f64).sqrt() / size.max(f64::MIN_POSITIVE)
    });
    Simulation { record: record.name().to_owned(), fit: fits.collect(), sensors }
}

/// What each sensor reads from a state on, under inputs.
fn response(
    fit: &Fit,
    mut state: DVector<f64>,
    samples: usize,
    input: impl Fn(usize) -> DVector<f64>,
) -> Vec<Vec<f64>> {
    let mut sensors = vec![Vec::with_capacity(samples); fit.model.c().nrows()];
    for k in 0..samples {
        let u = input(k);
        let read = fit.model.c() * &state + fit.model.d() * &u;
        for (sensor, value) in sensors.iter_mut().zip(read.iter()) {
            sensor.push(*value);
        }
        state = fit.model.a() * state + fit.model.b() * u;
    }
    sensors
}

/// A signal late by so many samples, straight between them, and what it was at its ends beyond.
fn delayed(signal: &[f64], samples: f64) -> Vec<f64> {
    if samples == 0.0 {
        return signal.to_vec();
    }
    let last = (signal.len() - 1) as f64;
    let at = |k: usize| {
        let place = (k as f64 - samples).clamp(0.0, last);
        let below = place.floor();
        // Within the signal, so that the index is one.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to the last index"
        )]
        let index = below as usize;
        let next = signal[(index + 1).min(signal.len() - 1)];
        signal[index] + (place - below) * (next - signal[index])
    };
    (0..signal.len()).map(at).collect()
}

/// The standard deviation of a signal.
fn spread(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}
