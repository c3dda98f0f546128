//! What the model makes of recorded inputs in the time domain, beside what the sensors read: for plots, and for records that the fit has not seen.

use lti::{Discrete, StateSpace};
use nalgebra::{DMatrix, DVector};

use super::fit::Fit;
use super::options::RecordedInputs;
use crate::error::option;
use crate::likelihood::Estimate;
use crate::model::record::refuse_constant_channels;
use crate::{ReconstructError, Record};

/// A system with inputs, and by how much its sensors and inputs are late.
///
/// # Example
///
/// ```
/// use lti::{Discrete, SamplePeriod, StateSpace};
/// use nalgebra::dmatrix;
/// use reconstruct::output_error::{InputModel, RecordedInputs, simulate};
/// use reconstruct::{Channel, Record};
///
/// let period = SamplePeriod::new(0.1)?;
/// let system =
///     StateSpace::<Discrete>::new(dmatrix![0.5], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0], period)?;
/// let model = InputModel { system, sensor_lags: vec![0.0], input_lags: vec![0.0], drift: false };
/// // A step of the input, and a sensor that is offset.
/// let y = vec![10.0, 11.0, 11.5, 11.75, 11.875];
/// let record = Record::new("a", period, vec![Channel::new("y", y)])?;
/// let inputs = RecordedInputs { names: vec!["u".to_owned()], signals: vec![vec![vec![1.0; 5]]] };
/// let found = &simulate(&[record], &inputs, &model)?[0];
/// assert!(found.fit[0] > 0.999_999);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct InputModel {
    /// From the inputs to the sensors.
    pub system: StateSpace<Discrete>,
    /// The lag of each sensor in s.
    pub sensor_lags: Vec<f64>,
    /// The lag of each input in s.
    pub input_lags: Vec<f64>,
    /// Whether sensors drift by a constant rate.
    pub drift: bool,
}

impl From<&Fit> for InputModel {
    fn from(fit: &Fit) -> Self {
        let values = |lags: &[Estimate]| lags.iter().map(|lag| lag.value).collect();
        Self {
            system: fit.model.clone(),
            sensor_lags: values(&fit.sensor_lags),
            input_lags: values(&fit.input_lags),
            drift: fit.drift,
        }
    }
}

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
/// [`ReconstructError::Option`] where sensors, inputs or the sample period are not those of the model.
pub fn simulate(
    records: &[Record],
    inputs: &RecordedInputs,
    model: &InputModel,
) -> Result<Vec<Simulation>, ReconstructError> {
    let (sensors, count) = (model.system.c().nrows(), model.system.b().ncols());
    if model.sensor_lags.len() != sensors || model.input_lags.len() != count {
        return Err(option("lags", format!("{sensors} sensors and {count} inputs need one each")));
    }
    if inputs.names.len() != count || inputs.signals.len() != records.len() {
        return Err(option("recorded inputs", format!("the model has {count} inputs")));
    }
    refuse_constant_channels(records)?;
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
            let (own, other) = (record.period().seconds(), model.system.period().seconds());
            if (own - other).abs() > SAME_PERIOD * other {
                let name = record.name();
                let message = format!("record {name:?} is sampled every {own} s, the model every {other} s");
                return Err(option("recorded inputs", message));
            }
            Ok(one(record, signals, model))
        })
        .collect()
}

/// Periods that differ by a smaller part are the same.
const SAME_PERIOD: f64 = 1e-3;

fn one(record: &Record, signals: &[Vec<f64>], model: &InputModel) -> Simulation {
    let period = record.period().seconds();
    let (n, m) = (model.system.a().nrows(), model.system.c().nrows());
    let samples = record.samples();
    let late: Vec<Vec<f64>> = signals
        .iter()
        .zip(&model.input_lags)
        .map(|(signal, lag)| delayed(signal, lag / period))
        .collect();
    let input = |k: usize| DVector::from_fn(late.len(), |row, _| late[row][k]);
    let forced = response(model, DVector::zeros(n), samples, input);
    let turned = |response: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
        let lags = model.sensor_lags.iter().map(|lag| lag / period);
        response.iter().zip(lags).map(|(sensor, lag)| delayed(sensor, lag)).collect()
    };
    let forced = turned(forced);
    let free: Vec<Vec<Vec<f64>>> = (0..n)
        .map(|state| {
            let start = DVector::from_fn(n, |i, _| if i == state { 1.0 } else { 0.0 });
            turned(response(model, start, samples, |_| DVector::zeros(late.len())))
        })
        .collect();
    // Unknowns: the initial state, then an offset for each sensor, then a drift.
    let own = if model.drift { 2 } else { 1 };
    let unknowns = n + own * m;
    let (mut gram, mut right) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
    let column = |sensor: usize, k: usize| {
        let mut row = DVector::zeros(unknowns);
        for (state, free) in free.iter().enumerate() {
            row[state] = free[sensor][k];
        }
        row[n + sensor] = 1.0;
        if model.drift {
            row[n + m + sensor] = k as f64 / samples as f64 - 0.5;
        }
        row
    };
    let sizes: Vec<f64> = record.channels().iter().map(|channel| spread(&channel.values)).collect();
    for (sensor, channel) in record.channels().iter().enumerate() {
        let weight = 1.0 / (sizes[sensor] * sizes[sensor]).max(f64::MIN_POSITIVE);
        for k in present(record, sensor) {
            let (value, row) = (channel.values[k], column(sensor, k));
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
    let fits = record.channels().iter().zip(&sensors).zip(&sizes).enumerate();
    let fits = fits.map(|(sensor, ((read, found), size))| {
        let all = present(record, sensor).map(|k| (read.values[k] - found[k]).powi(2));
        let (squares, count) = all.fold((0.0, 0_usize), |(sum, count), own| (sum + own, count + 1));
        1.0 - (squares / count.max(1) as f64).sqrt() / size.max(f64::MIN_POSITIVE)
    });
    Simulation { record: record.name().to_owned(), fit: fits.collect(), sensors }
}

/// The samples of a sensor that are there.
fn present(record: &Record, sensor: usize) -> impl Iterator<Item = usize> {
    let missing = record.missing(sensor);
    (0..record.samples()).filter(|k| missing.binary_search(k).is_err())
}

/// What each sensor reads from a state on, under inputs.
fn response(
    model: &InputModel,
    mut state: DVector<f64>,
    samples: usize,
    input: impl Fn(usize) -> DVector<f64>,
) -> Vec<Vec<f64>> {
    let mut sensors = vec![Vec::with_capacity(samples); model.system.c().nrows()];
    for k in 0..samples {
        let u = input(k);
        let read = model.system.c() * &state + model.system.d() * &u;
        for (sensor, value) in sensors.iter_mut().zip(read.iter()) {
            sensor.push(*value);
        }
        state = model.system.a() * state + model.system.b() * u;
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
