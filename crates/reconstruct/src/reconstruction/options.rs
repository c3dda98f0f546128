//! One set of options for both stages, and what each stage takes from it.

use crate::likelihood::rms;
use crate::{
    AsPrintedOptions, AutoregressionOrder, Centring, DirectPath, FrequencyBand, Hold, Intersection,
    LikelihoodNoise, LikelihoodOptions, NoiseModel, NoiseOrigin, Offsets, OrderChoice,
    ReconstructError, Record, SubspaceOptions, Trend, VectorAutoregression,
};

/// How to reconstruct.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The printed method, for records without noise.
    AsPrinted,
    /// Intersection of signal subspaces: closed form, noise and any excitation, no deviations.
    Subspace,
    /// Maximum likelihood from there on: as accurate as the records allow, with deviations. The default.
    #[default]
    MaximumLikelihood,
}

/// What [`reconstruct`](crate::reconstruct) may be told.
///
/// # Example
///
/// ```
/// use reconstruct::{Method, NoiseModel, Options, OrderChoice};
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
    /// The number of states; by default from the gap among orders up to 10.
    pub order: OrderChoice,
    /// The number of block rows of the first stage; `None` uses its rule, half of them, and one and a half times as many.
    pub block_rows: Option<usize>,
    /// Sensor offsets; by default zero, since offsets that may be anything hide the slow modes of short records. The first stage centres its
    /// rows unless they are zero.
    pub offsets: Offsets,
    /// Drift of the sensors; by default absent. The first stage knows of none and centres its rows.
    pub trend: Trend,
    /// The frequencies that the second stage uses; by default all.
    pub band: Option<FrequencyBand>,
    /// Indices of the sensors that read the excitation directly, as accelerometers do; by default none.
    pub feedthrough_sensors: Vec<usize>,
    /// Inputs that were recorded: for each record a list of signals as long as the record. Empty where nothing was recorded. [`Method::AsPrinted`]
    /// knows of none.
    pub known_inputs: Vec<Vec<Vec<f64>>>,
    /// How the excitation moves between samples; `None`, the default, takes what is more likely. The first stage takes it as held.
    pub hold: Option<Hold>,
    /// Whether real modes get an interval from the likelihood itself, which need not be symmetric; by default not, since it takes as long as the fit. The
    /// deviations hold to first order: for modes that are slow beside the records, at signal to noise ratios around 10, they are too small or too large.
    pub profile: bool,
    /// The most steps of the second stage's search between two updates of the noise levels; by default 100.
    pub largest_steps: usize,
    /// How many threads the second stage has for long records; by default 1. The result does not depend on it.
    pub threads: usize,
    /// For [`Method::AsPrinted`].
    pub printed: AsPrintedOptions,
}

impl Default for Options {
    fn default() -> Self {
        let first = SubspaceOptions::default();
        let second = LikelihoodOptions::default();
        Self {
            method: Method::default(),
            noise: first.noise,
            order: first.order,
            block_rows: first.block_rows,
            offsets: second.offsets,
            trend: second.trend,
            band: second.band,
            feedthrough_sensors: second.feedthrough_sensors,
            known_inputs: second.known_inputs,
            hold: second.hold,
            profile: false,
            largest_steps: second.largest_steps,
            threads: second.threads,
            printed: AsPrintedOptions::default(),
        }
    }
}

/// Records without noise are given this part of a sensor's root mean square as its level: far above rounding errors, far below any sensor's.
const LEVEL_WITHOUT_NOISE: f64 = 1e-9;

/// The longest autoregression tried for a quiet record.
const LONGEST_AUTOREGRESSION: usize = 24;

impl Options {
    /// The options of the first stage.
    pub(super) fn subspace(&self) -> SubspaceOptions {
        let still = self.offsets == Offsets::Zero && self.trend == Trend::Absent;
        let direct = !self.feedthrough_sensors.is_empty();
        SubspaceOptions {
            order: self.order,
            block_rows: self.block_rows,
            noise: self.noise.clone(),
            centring: if still { Centring::None } else { Centring::Rows },
            known_inputs: self.known_inputs.clone(),
            direct_path: if direct { DirectPath::Present } else { DirectPath::Absent },
        }
    }

    /// The options of the second stage, after the first.
    pub(super) fn likelihood(
        &self,
        records: &[Record],
        first: &Intersection,
    ) -> Result<LikelihoodOptions, ReconstructError> {
        let noise = match &self.noise {
            NoiseModel::Levels(levels) => LikelihoodNoise::Given(levels.clone()),
            NoiseModel::Estimated if first.noise.origin == NoiseOrigin::Rounding => {
                LikelihoodNoise::Given(levels_without_noise(records, &first.noise.deviations))
            }
            NoiseModel::Estimated => {
                LikelihoodNoise::Estimated { first_guess: Some(first.noise.deviations.clone()) }
            }
            NoiseModel::Quiet(quiet) => {
                let fitted = VectorAutoregression::fit(quiet, longest(quiet))?;
                let spectra = records.iter().map(|record| fitted.spectrum(record.samples()));
                LikelihoodNoise::Spectra(spectra.collect::<Result<_, _>>()?)
            }
        };
        Ok(LikelihoodOptions {
            noise,
            offsets: self.offsets.clone(),
            trend: self.trend,
            band: self.band,
            feedthrough_sensors: self.feedthrough_sensors.clone(),
            known_inputs: self.known_inputs.clone(),
            hold: self.hold,
            largest_steps: self.largest_steps,
            threads: self.threads,
            ..LikelihoodOptions::default()
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
