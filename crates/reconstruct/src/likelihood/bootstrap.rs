//! Deviations of modes from repeated noise: a check of those that the covariance gives to first order.

use nalgebra::{DMatrix, DVector, Matrix2};
use num_complex::Complex;
use realfft::RealFftPlanner;

use super::identify::identify;
use super::inference::refit::{Refit, refit};
use super::inference::uncertainty::ComplexEstimate;
use crate::likelihood::cost::feedback::feedback;
use crate::likelihood::cost::parameters::System;
use crate::likelihood::cost::spectrum::{Entry, RecordSpectrum};
use crate::likelihood::inference::fit::Fit;
use crate::likelihood::options::{Noise, Options};
use crate::model::matching::closest_pairs;
use crate::model::noise_spectrum::inverse_of_hermitian;
use crate::{Channel, ReconstructError, Record};

/// How modes scatter when the noise is drawn anew.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Bootstrap {
    /// The modes, in the order of [`Fit::modes`].
    pub modes: Vec<BootstrapMode>,
    /// Repetitions whose modes could not be told: no fit, or another number of modes.
    pub lost: usize,
}

/// How one mode scatters.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BootstrapMode {
    /// Mean and covariance of the eigenvalue s in rad/s over the repetitions.
    pub continuous: ComplexEstimate,
    /// Its value in each repetition that counts.
    pub values: Vec<Complex<f64>>,
}

/// Repeats a fit with noise drawn anew: the parametric bootstrap.
///
/// What the fit explains of each record, with the excitation at its best, is taken for the truth; noise of the fitted levels (or of the
/// given spectra) is added, and the fit is repeated from the fitted system. The scatter of the modes needs no linearisation, but its own sampling error
/// is 1 / sqrt(2 R) of a deviation after R repetitions. The excitation at its best holds a part of the noise, so that at signal-to-noise ratios near 1 the
/// repetitions are a little too well excited.
///
/// `fit` is the result of [`identify`](crate::likelihood::identify) for the same records and options. `normal` is called for independent standard normal numbers; the same numbers
/// give the same result.
///
/// Source: Efron & Tibshirani, An Introduction to the Bootstrap (1993), 6.5.
///
/// # Errors
///
/// Those of [`identify`](crate::likelihood::identify) for records and options, and [`ReconstructError::Option`] for fewer than two repetitions or where fewer than two could be told.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../doctest/two_decays.md")]
/// use reconstruct::likelihood::{Bootstrap, Options, bootstrap, identify};
/// use reconstruct::subspace;
///
/// let records = two_decays(0.9, 300, 0.01)?;
/// let start = subspace::identify(&records, &subspace::Options::default())?.model;
/// let fit = identify(&records, &[start], &Options::default())?;
/// let mut random = flight::Stream::new(1, 1);
/// let Bootstrap { modes, lost, .. } = bootstrap(&records, &fit, 30, &mut || random.normal())?;
/// assert_eq!(lost, 0);
/// // The scatter of the slow mode agrees with its standard error within the sampling error of 30 repetitions.
/// let ratio = modes[1].continuous.real_standard_error() / fit.modes[1].continuous.real_standard_error();
/// assert!((0.5..2.0).contains(&ratio), "{ratio}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bootstrap(
    records: &[Record],
    fit: &Fit,
    repetitions: usize,
    normal: &mut dyn FnMut() -> f64,
) -> Result<Bootstrap, ReconstructError> {
    if repetitions < 2 {
        return Err(too_few(format!("{repetitions}, at least 2 are needed")));
    }
    let again = refitted(fit);
    let starts = std::slice::from_ref(&fit.model);
    let mut planner = RealFftPlanner::new();
    let Refit { problem, evaluation, variances, units } = refit(records, fit)?;
    let parts = problem
        .spectra
        .iter()
        .enumerate()
        .map(|(j, spectrum)| {
            parts(spectrum, &evaluation.system, j, &evaluation.coefficients[j], &variances)
        })
        .collect::<Result<Vec<_>, _>>()?;

    let found: Vec<Complex<f64>> = fit.modes.iter().map(|mode| mode.discrete.value).collect();
    let mut values = vec![Vec::new(); found.len()];
    let mut lost = 0;
    for _ in 0..repetitions {
        let repeated = records
            .iter()
            .zip(&problem.spectra)
            .zip(&parts)
            .map(|((record, spectrum), parts)| {
                repeat(record, spectrum, parts, &units, &mut planner, normal)
            })
            .collect::<Result<Vec<_>, _>>()?;
        let modes = match identify(&repeated, starts, &again) {
            Ok(fit) if fit.modes.len() == found.len() => fit.modes,
            _ => {
                lost += 1;
                continue;
            }
        };
        let new: Vec<_> = modes.iter().map(|mode| mode.discrete.value).collect();
        for pair in closest_pairs(&found, &new) {
            values[pair.left].push(modes[pair.right].continuous.value);
        }
    }
    if repetitions - lost < 2 {
        return Err(too_few(format!("{lost} of {repetitions} could not be told")));
    }
    Ok(Bootstrap { modes: values.into_iter().map(scatter).collect(), lost })
}

fn too_few(message: String) -> ReconstructError {
    ReconstructError::Option { name: "repetitions", message }
}

/// The options of the repetitions: levels that were estimated are estimated again.
fn refitted(fit: &Fit) -> Options {
    let mut again = fit.options.clone();
    let Some(levels) = &fit.noise_levels else { return again };
    let first_guess = Some(levels.iter().map(|level| level.value).collect());
    match &fit.options.noise {
        Noise::Estimated { .. } => again.noise = Noise::Estimated { first_guess },
        Noise::ModelError { .. } => again.noise = Noise::ModelError { first_guess },
        Noise::Given(_) | Noise::Spectra(_) => {}
    }
    again
}

/// One frequency of a record: what the fit explains, and a factor L of the noise's covariance L L^H.
struct Part {
    explained: DVector<Complex<f64>>,
    factor: DMatrix<Complex<f64>>,
}

fn parts(
    spectrum: &RecordSpectrum,
    system: &System,
    record: usize,
    coefficients: &[Vec<f64>],
    variances: &[f64],
) -> Result<Vec<Part>, ReconstructError> {
    let (n, m) = (system.a.nrows(), system.c.nrows());
    let (b, d) = (&system.b[record], &system.d[record]);
    // Feedback of the states to the free excitation changes nothing, and takes eigenvalues off the unit circle.
    let gain = feedback(&system.a, b);
    let a = (&system.a + b * gain.transpose()).map(Complex::from);
    let c = (&system.c + d * gain.transpose()).map(Complex::from);
    let signals = spectrum.entries.len();
    let mut parts = Vec::with_capacity(spectrum.frequencies());
    for (k, &z) in spectrum.z.iter().enumerate() {
        let singular = || ReconstructError::Step {
            step: "bootstrap",
            message: format!("an eigenvalue lies on the unit circle at z = {z}"),
        };
        let inverse = (DMatrix::from_diagonal_element(n, n, z) - &a).try_inverse();
        let inverse = inverse.ok_or_else(singular)?;
        let (mut into_states, mut direct) = (DVector::zeros(n), DVector::zeros(m));
        for (signal, entry) in spectrum.entries.iter().enumerate() {
            let factor = spectrum.factors[k * signals + signal];
            let coefficient = &coefficients[signal];
            if !matches!(entry, Entry::Sensors) {
                into_states += DVector::from_fn(n, |i, _| factor * coefficient[i]);
            }
            if !matches!(entry, Entry::State) {
                direct += DVector::from_fn(m, |s, _| factor * coefficient[n + s]);
            }
        }
        let y = DVector::from_column_slice(&spectrum.y[k * m..(k + 1) * m]);
        let left = y.clone() - &c * (&inverse * into_states) - direct;
        let g = &c * (&inverse * b.map(Complex::from)) + d.map(Complex::from);
        let covariance = covariance(spectrum, k, variances).ok_or_else(singular)?;
        let weighed = inverse_of_hermitian(&covariance).ok_or_else(singular)? * &g;
        let power = weighed.dotc(&g);
        let excitation =
            if power.norm() > 0.0 { weighed.dotc(&left) / power } else { Complex::new(0.0, 0.0) };
        let factor = covariance.cholesky().ok_or_else(singular)?.l();
        // What is left without the excitation is noise; the rest is explained.
        parts.push(Part { explained: y - (left - g * excitation), factor });
    }
    Ok(parts)
}

/// The noise's covariance at one frequency, in units of the sensors.
fn covariance(
    spectrum: &RecordSpectrum,
    k: usize,
    variances: &[f64],
) -> Option<DMatrix<Complex<f64>>> {
    let sensors = spectrum.offset_variance.len();
    if let Some(precision) = &spectrum.precision {
        let size = sensors * sensors;
        let entries = &precision[k * size..(k + 1) * size];
        return inverse_of_hermitian(&DMatrix::from_row_slice(sensors, sensors, entries));
    }
    let variance = |s: usize, _| Complex::from(spectrum.variance(k, s, variances));
    Some(DMatrix::from_diagonal(&DVector::from_fn(sensors, variance)))
}

/// A record with new noise. Frequencies that the fit does not use stay as they are.
fn repeat(
    record: &Record,
    spectrum: &RecordSpectrum,
    parts: &[Part],
    units: &[f64],
    planner: &mut RealFftPlanner<f64>,
    normal: &mut dyn FnMut() -> f64,
) -> Result<Record, ReconstructError> {
    let (samples, sensors) = (record.samples(), units.len());
    let mut changes = vec![vec![Complex::new(0.0, 0.0); samples / 2 + 1]; sensors];
    for (k, (part, z)) in parts.iter().zip(&spectrum.z).enumerate() {
        // Real at frequency zero and at half the sampling frequency.
        let real = spectrum.weight[k] < 2.0;
        let drawn = DVector::from_fn(sensors, |_, _| {
            if real {
                Complex::from(normal())
            } else {
                Complex::new(normal(), normal()) * std::f64::consts::FRAC_1_SQRT_2
            }
        });
        let now = &part.explained + &part.factor * drawn;
        let place = frequency_index(*z, samples);
        for (s, changes) in changes.iter_mut().enumerate() {
            let change = now[s] - spectrum.y[k * sensors + s];
            changes[place] = if real { Complex::from(change.re) } else { change };
        }
    }
    let inverse = planner.plan_fft_inverse(samples);
    let scale = 1.0 / (samples as f64).sqrt();
    let mut channels = Vec::with_capacity(sensors);
    for ((channel, mut change), unit) in record.channels().iter().zip(changes).zip(units) {
        let mut output = inverse.make_output_vec();
        inverse.process(&mut change, &mut output).map_err(|error| ReconstructError::Step {
            step: "inverse Fourier transform",
            message: error.to_string(),
        })?;
        let values =
            channel.values.iter().zip(&output).map(|(y, change)| y + change * scale * unit);
        channels.push(Channel::new(channel.name.clone(), values.collect()));
    }
    for (index, channel) in channels.iter_mut().enumerate() {
        record.missing(index).iter().for_each(|&sample| channel.values[sample] = f64::NAN);
    }
    Record::with_missing(record.name(), record.period(), channels)
}

/// k of z = exp(2 pi j k / N).
fn frequency_index(z: Complex<f64>, samples: usize) -> usize {
    let turns = z.arg().abs() / std::f64::consts::TAU;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and half the number of samples"
    )]
    let index = (turns * samples as f64).round() as usize;
    index
}

fn scatter(values: Vec<Complex<f64>>) -> BootstrapMode {
    let number = values.len() as f64;
    let mean = values.iter().sum::<Complex<f64>>() / number;
    let mut covariance = Matrix2::zeros();
    for value in &values {
        let (re, im) = ((value - mean).re, (value - mean).im);
        covariance += Matrix2::new(re * re, re * im, re * im, im * im) / (number - 1.0);
    }
    BootstrapMode { continuous: ComplexEstimate { value: mean, covariance }, values }
}

#[cfg(test)]
mod tests;
