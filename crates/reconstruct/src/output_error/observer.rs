//! A start for a black box: Markov parameters from an observer, and their realization.
//!
//! An autoregression with inputs predicts the sensors from what sensors and inputs were; it is an observer that forgets within its length, so that it can be
//! fitted by least squares whatever the disturbance. From its coefficients the Markov parameters of the system itself follow, and from these the eigensystem
//! realization algorithm makes a model of any order (observer/Kalman filter identification: Juang, Phan, Horta & Longman, Journal of Guidance, Control, and
//! Dynamics 16 (1993) 320-329).

use era::{EraOptions, Order, realize};
use hankel::{Accumulator, Column, Layout};
use lti::SamplePeriod;
use nalgebra::DMatrix;

use super::cells::Matrices;
use super::options::RecordedInputs;
use crate::{ReconstructError, Record};

/// The Markov parameters H_0 = D, H_1, .. of the system from inputs to sensors.
pub(super) struct Markov {
    parameters: Vec<DMatrix<f64>>,
    period: SamplePeriod,
}

/// Coefficients may use this part of the rows.
const ROWS_PER_COEFFICIENT: usize = 6;
/// The longest observer, in samples.
const LONGEST: usize = 40;
/// Markov parameters for each sample of the observer's length.
const TIMES_THE_OBSERVER: usize = 4;
/// Added to each channel's power, so that records without noise determine the coefficients as well.
const RIDGE: f64 = 1e-7;

/// From all records; an error where they are too short for an observer of two samples.
pub(super) fn markov(
    records: &[Record],
    inputs: &RecordedInputs,
) -> Result<Markov, ReconstructError> {
    let (sensors, count) = (records[0].channels().len(), inputs.names.len());
    let channels = sensors + count;
    let rows: usize = records.iter().map(Record::samples).sum();
    let length = (rows / (ROWS_PER_COEFFICIENT * channels)).min(LONGEST);
    let shortest = records.iter().map(Record::samples).min().unwrap_or(0);
    let length = length.min(shortest / 3).max(1);
    // Past samples of all channels, newest first, then the inputs of now, then the sensors of now.
    let past =
        (1..=length as isize).flat_map(|lag| (0..channels).map(move |c| Column::new(c, -lag)));
    let now = (sensors..channels).chain(0..sensors).map(|c| Column::new(c, 0));
    let failed = |error: hankel::HankelError| ReconstructError::Step {
        step: "observer",
        message: error.to_string(),
    };
    let layout = Layout::new(channels, past.chain(now).collect()).map_err(failed)?;
    let mut sums = Accumulator::new(&layout, &hankel::Options::default()).map_err(failed)?;
    for (record, signals) in records.iter().zip(&inputs.signals) {
        let centred: Vec<Vec<f64>> = record
            .channels()
            .iter()
            .map(|channel| &channel.values)
            .chain(signals)
            .map(|values| {
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                values.iter().map(|value| value - mean).collect()
            })
            .collect();
        let signals: Vec<&[f64]> = centred.iter().map(Vec::as_slice).collect();
        sums.push(&signals).map_err(failed)?;
        sums.gap();
    }
    let gram = sums.gram().and_then(|gram| gram.matrix()).map_err(failed)?;
    let known = length * channels + count;
    let mut left = gram.view((0, 0), (known, known)).into_owned();
    for k in 0..known {
        left[(k, k)] *= 1.0 + RIDGE;
        if left[(k, k)] <= 0.0 {
            left[(k, k)] = 1.0;
        }
    }
    let right = gram.view((0, known), (known, sensors)).into_owned();
    let solution = left.cholesky().ok_or_else(|| ReconstructError::Step {
        step: "observer",
        message: "the past of sensors and inputs is not independent".to_owned(),
    })?;
    let coefficients = solution.solve(&right).transpose();
    let of_lag = |lag: usize, first: usize, width: usize| {
        coefficients.columns((lag - 1) * channels + first, width).into_owned()
    };
    let direct = coefficients.columns(length * channels, count).into_owned();
    let mut parameters = vec![direct];
    for k in 1..=TIMES_THE_OBSERVER * length.max(2) {
        let mut next =
            if k <= length { of_lag(k, sensors, count) } else { DMatrix::zeros(sensors, count) };
        for lag in 1..=k.min(length) {
            next += of_lag(lag, 0, sensors) * &parameters[k - lag];
        }
        parameters.push(next);
    }
    Ok(Markov { parameters, period: records[0].period() })
}

impl Markov {
    /// The model of so many states; `None` where the parameters do not hold as many.
    pub(super) fn model(&self, order: usize) -> Option<Matrices> {
        let options = EraOptions::with_order(Order::Fixed(order));
        let system = realize(&self.parameters, self.period, &options).ok()?.system;
        let (a, b, c) = (system.a().clone(), system.b().clone(), system.c().clone());
        let (sensor_lags, input_lags) = (vec![0.0; c.nrows()], vec![0.0; b.ncols()]);
        let d = system.d().clone();
        (a.nrows() == order).then_some(Matrices { a, b, c, d, sensor_lags, input_lags })
    }
}
