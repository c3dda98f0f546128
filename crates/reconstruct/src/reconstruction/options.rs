//! One set of options for both stages, and what each stage takes from it.

use crate::likelihood::{FrequencyBand, Hold, Noise, SearchOptions};
use crate::model::record::rms;
use crate::model::{AutoregressionOrder, VectorAutoregression};
use crate::output_error::{self, Lag, RecordedInputs, Structure};
use crate::subspace::{Intersection, NoiseOrigin, OrderChoice};
use crate::{
    Measurement, NoiseModel, Offsets, ReconstructError, Record, likelihood, paper, subspace,
};

/// How to reconstruct.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The method of the paper, for records without noise.
    Paper,
    /// Intersection of signal subspaces: closed form, noise and any excitation, no standard errors.
    Subspace,
    /// Maximum likelihood from there on: as accurate as the records allow, with standard errors. The default.
    #[default]
    MaximumLikelihood,
    /// Output error, for records whose inputs were all recorded: modes with standard errors beside any disturbance, from one record or several.
    OutputError,
}

/// What excited records whose inputs were recorded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Excitation {
    /// The recorded inputs alone, unless they leave so much unexplained that something else must have moved the system.
    #[default]
    AsNeeded,
    /// The recorded inputs alone, and disturbances.
    Recorded,
    /// In each record something that was not recorded as well.
    Unrecorded,
}

/// What [`reconstruct`](crate::reconstruct) may be told.
///
/// # Example
///
/// ```
/// use reconstruct::subspace::OrderChoice;
/// use reconstruct::{Method, NoiseModel, Options};
///
/// let mut options = Options::default();
/// options.order = OrderChoice::Fixed(4);
/// options.noise = NoiseModel::Levels(vec![5e-4, 1e-3, 1e-3]);
/// assert_eq!(options.method, Method::MaximumLikelihood);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The method; by default maximum likelihood.
    pub method: Method,
    /// The noise of the sensors, for both stages; by default white with estimated levels. A quiet record gives its covariance to the
    /// first stage and the spectrum of its vector autoregression to the second.
    pub noise: NoiseModel,
    /// Offsets, drift and feedthrough of the sensors, and recorded inputs, for both stages. The first stage centres its rows unless offsets
    /// are zero and drift is absent. [`Method::Paper`] knows of none of these.
    pub measurement: Measurement,
    /// Inputs that were recorded, the same list for all records; by default none. Where there are any, [`Method::MaximumLikelihood`] asks `excitation` what else
    /// may have moved the system; they take the place of those in `measurement`.
    pub inputs: RecordedInputs,
    /// Whether something else than the recorded inputs excited the system.
    pub excitation: Excitation,
    /// The form of the equations, for [`Method::MaximumLikelihood`] and [`Method::OutputError`]: by default the lateral ones where the sensors are beta, p, r (and phi) and the records
    /// do not reject them.
    pub structure: Structure,
    /// The lag of each sensor where all inputs were recorded; empty, the default, for none.
    pub sensor_lags: Vec<Lag>,
    /// The lag of each recorded input; empty, the default, for none.
    pub input_lags: Vec<Lag>,
    /// The number of states; by default from the gap among orders up to 10.
    pub order: OrderChoice,
    /// The number of block rows of the first stage; `None` uses its rule, half of them, and one and a half times as many.
    pub block_rows: Option<usize>,
    /// The frequencies that the second stage uses; by default all.
    pub band: Option<FrequencyBand>,
    /// How the excitation moves between samples; `None`, the default, takes what is more likely. The first stage takes it as held.
    pub hold: Option<Hold>,
    /// How far the second stage's search goes.
    pub search: SearchOptions,
    /// Whether real modes get an interval from the likelihood itself, which need not be symmetric; by default not, since it takes as long as the fit. The
    /// standard errors hold to first order: for modes that are slow beside the records, at signal to noise ratios around 10, they are too small or too large.
    pub profile: bool,
    /// How many threads the second stage has for long records; by default 1. The result does not depend on it.
    pub threads: usize,
    /// For [`Method::Paper`].
    pub paper: paper::Options,
}

impl Default for Options {
    fn default() -> Self {
        let first = subspace::Options::default();
        let second = likelihood::Options::default();
        Self {
            method: Method::default(),
            noise: first.noise,
            measurement: second.measurement,
            inputs: RecordedInputs::default(),
            excitation: Excitation::default(),
            structure: Structure::default(),
            sensor_lags: Vec::new(),
            input_lags: Vec::new(),
            order: first.order,
            block_rows: first.block_rows,
            band: second.band,
            hold: second.hold,
            search: second.search,
            profile: false,
            threads: second.threads,
            paper: paper::Options::default(),
        }
    }
}

/// Records without noise are given this part of a sensor's root mean square as its level: far above rounding errors, far below any sensor's.
const LEVEL_WITHOUT_NOISE: f64 = 1e-9;

/// The longest autoregression tried for a quiet record.
const LONGEST_AUTOREGRESSION: usize = 24;

impl Options {
    /// The options where all inputs were recorded.
    pub(super) fn output_error(&self) -> output_error::Options {
        output_error::Options {
            structure: self.structure,
            order: self.order,
            hold: self.hold,
            band: self.band,
            trend: self.measurement.trend,
            feedthrough_sensors: self.measurement.feedthrough_sensors.clone(),
            sensor_lags: self.sensor_lags.clone(),
            input_lags: self.input_lags.clone(),
        }
    }

    /// The same beside an excitation that was not recorded: inputs enter each record in which they move in a way of their own.
    pub(crate) fn with_unrecorded_excitation(&self) -> Self {
        let mut options = self.clone();
        if !self.inputs.names.is_empty() {
            let moves = |signal: &&Vec<f64>| signal.iter().any(|value| value.abs() > 0.0);
            let moving = |signals: &Vec<Vec<f64>>| signals.iter().filter(moves).cloned().collect();
            options.measurement.known_inputs = self.inputs.signals.iter().map(moving).collect();
        }
        options
    }

    /// The options of the first stage. Where the likelihood is to tell whether sensors are offset, its starts must not take an offset for a state.
    #[must_use]
    pub fn subspace(&self) -> subspace::Options {
        let mut measurement = self.with_unrecorded_excitation().measurement;
        if measurement.offsets == Offsets::AsNeeded && self.method == Method::MaximumLikelihood {
            measurement.offsets = Offsets::Free;
        }
        subspace::Options {
            order: self.order,
            block_rows: self.block_rows,
            noise: self.noise.clone(),
            measurement,
        }
    }

    /// The options of the second stage, after the first.
    pub(super) fn likelihood(
        &self,
        records: &[Record],
        first: &Intersection,
    ) -> Result<likelihood::Options, ReconstructError> {
        let noise = match &self.noise {
            NoiseModel::Levels(levels) => Noise::Given(levels.clone()),
            NoiseModel::Estimated | NoiseModel::White
                if first.noise.origin == NoiseOrigin::Rounding =>
            {
                Noise::Given(levels_without_noise(records, &first.noise.deviations))
            }
            NoiseModel::Estimated | NoiseModel::White => {
                Noise::Estimated { first_guess: Some(first.noise.deviations.clone()) }
            }
            NoiseModel::Quiet(quiet) => {
                let fitted = VectorAutoregression::fit(quiet, longest(quiet))?;
                let spectra = records.iter().map(|record| fitted.spectrum(record.samples()));
                Noise::Spectra(spectra.collect::<Result<_, _>>()?)
            }
        };
        Ok(likelihood::Options {
            noise,
            measurement: self.measurement.clone(),
            band: self.band,
            hold: self.hold,
            search: self.search.clone(),
            threads: self.threads,
        })
    }
}

/// As long an autoregression as leaves ten equations for each unknown of a row.
fn longest(quiet: &Record) -> AutoregressionOrder {
    const EQUATIONS: usize = 10;
    let largest = quiet.samples() / (EQUATIONS * quiet.channels().len() + 1);
    AutoregressionOrder::Akaike { largest: largest.min(LONGEST_AUTOREGRESSION) }
}

fn levels_without_noise(records: &[Record], bounds: &[f64]) -> Vec<f64> {
    let level = |(sensor, bound): (usize, &f64)| {
        let all = records.iter().map(|record| rms(&record.channels()[sensor].values));
        bound.max(LEVEL_WITHOUT_NOISE * all.fold(0.0, f64::max))
    };
    bounds.iter().enumerate().map(level).collect()
}
