//! The result: the system, how certain it is, and what it was compared with.

use lti::{Discrete, StateSpace};
use nalgebra::DMatrix;
use num_complex::Complex;

use super::candidate::Candidate;
use super::cells::Sizes;
use super::coherence::coherence;
use super::doubt::{Doubt, doubts};
use super::explained::explained;
use super::forms::hold_of;
use super::model_error::model_error;
use super::options::{Lag, RecordedInputs};
use super::parametrisation::Form;
use super::spectra::Spectrum;
use crate::likelihood::cost::noise::LEAST_MODEL_ERROR;
use crate::likelihood::inference::derivatives::{self, Derivative};
use crate::likelihood::inference::uncertainty::{ModelBias, modes};
use crate::likelihood::{Estimate, FrequencyBand, Hold, Mode};
use crate::model::lateral_equations::NAMES;
use crate::{ReconstructError, Record};

/// Another form that was fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Compared {
    /// The number of states.
    pub order: usize,
    /// Whether it is the lateral equations.
    pub is_lateral: bool,
    /// What its criterion lies above that of the form used; below zero where it is more likely.
    pub above: f64,
}

/// What the recorded inputs explain of one record.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RecordFit {
    /// The frequencies in rad/s.
    pub frequencies_rad_s: Vec<f64>,
    /// The transform of each sensor, N^(-1/2) sum y(i) z^-i, m x F; the most likely values in place of missing samples.
    pub measured: DMatrix<Complex<f64>>,
    /// What the model leaves of it.
    pub residuals: DMatrix<Complex<f64>>,
    /// The part of each sensor's power in the band that the model explains, 1 for all of it.
    pub explained: Vec<f64>,
    /// Coherence of each sensor with all inputs of the record together, m x F: where it is near 1, the inputs tell what the sensor reads.
    pub coherence: DMatrix<f64>,
}

/// What a fit with recorded inputs says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Fit {
    /// The system from the recorded inputs to the sensors.
    pub model: StateSpace<Discrete>,
    /// The modes with their uncertainty, by real part of the eigenvalue, a complex pair once.
    pub modes: Vec<Mode>,
    /// The derivatives of the lateral equations; empty for a black box.
    pub derivatives: Vec<Derivative>,
    /// The correlations of their estimates.
    pub correlations: DMatrix<f64>,
    /// The lag of each sensor in s; without a standard error where it was given.
    pub sensor_lags: Vec<Estimate>,
    /// The lag of each input in s.
    pub input_lags: Vec<Estimate>,
    /// How the inputs move between samples.
    pub hold: Hold,
    /// Minus twice the logarithm of the other hold's likelihood over this one's; `None` where the hold was given.
    pub hold_evidence: Option<f64>,
    /// The frequencies that were used.
    pub band: FrequencyBand,
    /// Whether a drift of each sensor was estimated.
    pub drift: bool,
    /// Schwarz's criterion.
    pub criterion: f64,
    /// Other forms that were fitted.
    pub compared: Vec<Compared>,
    /// The part of what the sensors read that no linear model explains; what lies above a twentieth is a disturbance of another kind.
    pub model_error: Estimate,
    /// Each record on its own.
    pub records: Vec<RecordFit>,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<Doubt>,
}

/// From here on residuals are a disturbance rather than a model error, turbulence most of the time; at three times as much they are nothing else.
const LARGEST_MODEL_ERROR: f64 = 0.05;

/// What counts as model error of what residuals show: all of it while it is small, the least there is where they are a disturbance.
fn part_of_the_model(found: f64) -> f64 {
    let beyond = (found - LARGEST_MODEL_ERROR) / (2.0 * LARGEST_MODEL_ERROR);
    let part = found.min(LARGEST_MODEL_ERROR) * (1.0 - beyond.clamp(0.0, 1.0));
    part.max(LEAST_MODEL_ERROR)
}

/// What was fitted.
pub(super) struct Context<'a> {
    pub(super) records: &'a [Record],
    pub(super) inputs: &'a RecordedInputs,
    pub(super) spectra: &'a [Spectrum],
    pub(super) band: FrequencyBand,
    pub(super) drift: bool,
}

pub(super) fn conclude(
    context: &Context<'_>,
    found: &Candidate,
    hold_evidence: Option<f64>,
    compared: Vec<Compared>,
) -> Result<Fit, ReconstructError> {
    let Context { records, inputs, spectra, band, drift } = *context;
    let failed = |message: String| ReconstructError::Step { step: "recorded inputs", message };
    let period = records[0].period();
    let matrices = found.matrices().ok_or_else(|| failed("no system".to_owned()))?;
    let sizes = matrices.sizes();
    let residuals = found.residuals(spectra);
    let error = model_error(&residuals, spectra);
    let error =
        error.unwrap_or(Estimate { value: LEAST_MODEL_ERROR, standard_error: f64::INFINITY });
    let covariance = covariance(found);
    let tangent = found.parametrisation.tangent(&found.evaluation.parameters);
    let tangent = tangent.ok_or_else(|| failed("no derivatives".to_owned()))?;
    let of_a = tangent.rows(0, sizes.states * sizes.states);
    let of_a = of_a * &covariance * of_a.transpose();
    let seconds = records.iter().map(|record| period.seconds() * record.samples() as f64);
    let resolution = std::f64::consts::TAU / seconds.fold(0.0, f64::max);
    let own = part_of_the_model(error.value);
    let bias = ModelBias { model_error: own, resolution };
    let modes =
        modes(&matrices.a, period, &of_a, bias).map_err(|error| failed(error.to_string()))?;
    let (derivatives, correlations) = derivatives(found, inputs, &covariance, own);
    let lags = lags(found, &covariance, sizes);
    let model = StateSpace::<Discrete>::new(matrices.a, matrices.b, matrices.c, matrices.d, period)
        .map_err(|error| failed(error.to_string()))?;
    let readings = found.readings(spectra);
    let all = residuals.into_iter().zip(readings).zip(spectra);
    let records = all.map(|((residuals, measured), spectrum)| RecordFit {
        frequencies_rad_s: spectrum.frequencies.clone(),
        explained: explained(&residuals, &measured),
        coherence: coherence(&measured, &spectrum.u).0,
        measured,
        residuals,
    });
    let mut fit = Fit {
        model,
        modes,
        derivatives,
        correlations,
        sensor_lags: lags.0,
        input_lags: lags.1,
        hold: hold_of(found),
        hold_evidence,
        band,
        drift,
        criterion: found.criterion,
        compared,
        model_error: error,
        records: records.collect(),
        doubts: Vec::new(),
    };
    fit.doubts = doubts(&fit, found, context);
    Ok(fit)
}

/// Of the parameters, on the directions that the records determine. Weights from residuals that are averaged over so many products are themselves uncertain, and
/// follow the residuals, which makes the inverse too small on average.
fn covariance(found: &Candidate) -> DMatrix<f64> {
    let size = found.evaluation.parameters.len();
    let inverse = found.evaluation.newton().map(|(_, inverse)| inverse);
    let inverse = inverse.unwrap_or_else(|| DMatrix::from_element(size, size, f64::INFINITY));
    let sensors = found.parametrisation.sizes().sensors as f64;
    let averaged = found.weightings.iter().map(|own| own.averaged).fold(f64::INFINITY, f64::min);
    let inflation = if averaged > 2.0 * sensors { averaged / (averaged - sensors) } else { 2.0 };
    inverse * inflation
}

fn derivatives(
    found: &Candidate,
    inputs: &RecordedInputs,
    covariance: &DMatrix<f64>,
    model_error: f64,
) -> (Vec<Derivative>, DMatrix<f64>) {
    if !matches!(found.parametrisation.form, Form::Lateral(_)) {
        return (Vec::new(), DMatrix::zeros(0, 0));
    }
    let mut names: Vec<String> = NAMES.iter().map(|&name| name.to_owned()).collect();
    for input in &inputs.names {
        names.extend(["Y", "L", "N"].map(|row| format!("{row}_{input}")));
    }
    derivatives::derivatives(names, &found.evaluation.parameters, covariance, model_error)
}

/// The lags of sensors and inputs.
fn lags(
    found: &Candidate,
    covariance: &DMatrix<f64>,
    sizes: Sizes,
) -> (Vec<Estimate>, Vec<Estimate>) {
    let free = found.parametrisation.free_lags();
    let first = found.parametrisation.parameters() - free.len();
    let of = |lag: &Lag, cell: usize| match (lag, free.iter().position(|&own| own == cell)) {
        (Lag::Given(seconds), _) => Estimate { value: *seconds, standard_error: 0.0 },
        (Lag::Free, place) => {
            let k = first + place.unwrap_or_default();
            let standard_error = covariance[(k, k)].max(0.0).sqrt();
            Estimate { value: found.evaluation.parameters[k], standard_error }
        }
    };
    let sensors = found.parametrisation.sensor_lags.iter().enumerate();
    let inputs = found.parametrisation.input_lags.iter().enumerate();
    (
        sensors.map(|(sensor, lag)| of(lag, sizes.sensor_lag(sensor))).collect(),
        inputs.map(|(input, lag)| of(lag, sizes.input_lag(input))).collect(),
    )
}
