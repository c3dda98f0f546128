//! What a fit with recorded inputs is told.

use crate::error::option;
use crate::likelihood::{FrequencyBand, Hold};
use crate::subspace::OrderChoice;
use crate::{ReconstructError, Record, Trend, subspace};

/// The inputs that were recorded, each with its name, and for each record their samples.
///
/// # Example
///
/// ```
/// use reconstruct::output_error::RecordedInputs;
///
/// // One record, in which the aileron moved and the rudder did not.
/// let inputs = RecordedInputs {
///     names: vec!["aileron".to_owned(), "rudder".to_owned()],
///     signals: vec![vec![vec![0.0, 0.1, 0.1, 0.0], vec![0.0; 4]]],
/// };
/// assert_eq!(inputs.signals[0].len(), inputs.names.len());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedInputs {
    /// One name for each input.
    pub names: Vec<String>,
    /// For each record a signal for each input, with as many samples as the record; zero throughout where it did not move.
    pub signals: Vec<Vec<Vec<f64>>>,
}

/// The form of the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Structure {
    /// The lateral equations where the sensors are beta, p, r (and phi), unless a system of so many states of which nothing else is known is more likely.
    #[default]
    Automatic,
    /// A system of so many states, of which nothing else is known.
    BlackBox,
    /// The lateral equations with beta, p, r and phi as states; derivatives are their parameters.
    Lateral,
}

/// By how much a sensor or an input is late.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Lag {
    /// By so many seconds.
    Given(f64),
    /// By a lag that is estimated.
    Free,
}

/// How to fit records whose inputs were recorded.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The form of the equations.
    pub structure: Structure,
    /// The number of states of a black box; by default by Schwarz's criterion.
    pub order: OrderChoice,
    /// How the inputs move between samples; `None`, the default, takes what is more likely.
    pub hold: Option<Hold>,
    /// The frequencies that are used; by default up to a multiple of the fastest mode.
    pub band: Option<FrequencyBand>,
    /// Drift of the sensors; by default where the records call for it. Offsets are always free.
    pub trend: Trend,
    /// Indices of the sensors that read inputs directly, as accelerometers do; by default none.
    pub feedthrough_sensors: Vec<usize>,
    /// The lag of each sensor; empty, the default, for none.
    pub sensor_lags: Vec<Lag>,
    /// The lag of each input; empty, the default, for none.
    pub input_lags: Vec<Lag>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            structure: Structure::default(),
            order: subspace::Options::default().order,
            hold: None,
            band: None,
            trend: Trend::AsNeeded,
            feedthrough_sensors: Vec::new(),
            sensor_lags: Vec::new(),
            input_lags: Vec::new(),
        }
    }
}

/// Two inputs of which one is a multiple of the other in all records, but for rounding.
fn alike(inputs: &RecordedInputs) -> Option<[usize; 2]> {
    /// Of the power of one that is not a multiple of the other.
    const ROUNDING: f64 = 1e-12;
    let count = inputs.names.len();
    let centred = |index: usize| -> Vec<f64> {
        let all = inputs.signals.iter().map(|signals| &signals[index]);
        all.flat_map(|signal| {
            let mean = signal.iter().sum::<f64>() / signal.len().max(1) as f64;
            signal.iter().map(move |value| value - mean)
        })
        .collect()
    };
    let all: Vec<Vec<f64>> = (0..count).map(centred).collect();
    let product = |i: usize, k: usize| all[i].iter().zip(&all[k]).map(|(a, b)| a * b).sum::<f64>();
    let pairs = (0..count).flat_map(|k| (0..k).map(move |i| [i, k]));
    pairs.into_iter().find(|&[i, k]| {
        let (own, other, mixed) = (product(i, i), product(k, k), product(i, k));
        own > 0.0 && other > 0.0 && 1.0 - mixed * mixed / (own * other) < ROUNDING
    })
}

/// Refuses inputs and options that do not fit the records.
pub(super) fn check(
    records: &[Record],
    inputs: &RecordedInputs,
    options: &Options,
) -> Result<(), ReconstructError> {
    const NAME: &str = "recorded inputs";
    let count = inputs.names.len();
    if count == 0 {
        return Err(option(NAME, "there are none".to_owned()));
    }
    if inputs.signals.len() != records.len() {
        let found = inputs.signals.len();
        return Err(option(NAME, format!("lists for {found} of {} records", records.len())));
    }
    for (record, signals) in records.iter().zip(&inputs.signals) {
        let name = record.name();
        if signals.len() != count {
            let found = signals.len();
            return Err(option(NAME, format!("record {name:?} has {found} of {count} inputs")));
        }
        for (input, signal) in inputs.names.iter().zip(signals) {
            let (found, samples) = (signal.len(), record.samples());
            if found != samples {
                let message =
                    format!("record {name:?} has {samples} samples, its input {input:?} {found}");
                return Err(option(NAME, message));
            }
            if signal.iter().any(|value| !value.is_finite()) {
                let message = format!("input {input:?} of record {name:?} is not finite");
                return Err(option(NAME, message));
            }
        }
    }
    for (index, name) in inputs.names.iter().enumerate() {
        let moves = |signals: &Vec<Vec<f64>>| {
            signals[index].windows(2).any(|pair| pair[0].total_cmp(&pair[1]).is_ne())
        };
        if !inputs.signals.iter().any(moves) {
            return Err(option(NAME, format!("input {name:?} moves in no record; leave it out")));
        }
    }
    if let Some([first, second]) = alike(inputs) {
        let (first, second) = (&inputs.names[first], &inputs.names[second]);
        return Err(option(
            NAME,
            format!(
                "{second:?} is a multiple of {first:?} in all records, so that their effects cannot be told apart; leave one out"
            ),
        ));
    }
    let sensors = records.first().map_or(0, |record| record.channels().len());
    let lags = [
        ("lags of sensors", &options.sensor_lags, sensors),
        ("lags of inputs", &options.input_lags, count),
    ];
    for (name, lags, needed) in lags {
        if !lags.is_empty() && lags.len() != needed {
            return Err(option(name, format!("{} for {needed}", lags.len())));
        }
        let bad = |lag: &&Lag| matches!(lag, Lag::Given(seconds) if !seconds.is_finite());
        if lags.iter().find(bad).is_some() {
            return Err(option(name, "one is not finite".to_owned()));
        }
    }
    Ok(())
}
