//! What a fitted system makes of each frequency of a record: response, noise, and what is left over.
//!
//! With H = C (zI - A)^-1, g = H b + d, S the noise covariance and Phi = S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g): known signals enter as Y = F t + g U + noise,
//! their coefficients t minimise the sum of (Y - F t)^H Phi (Y - F t), and U = g^H S^-1 (Y - F t) / (g^H S^-1 g) is the excitation.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;
use realfft::RealFftPlanner;

use crate::likelihood::cost::parameters::System;
use crate::likelihood::cost::record_system::RecordSystem;
use crate::likelihood::cost::spectrum::{Entry, RecordSpectrum, transform};
use crate::likelihood::options::{Noise, Options};
use crate::{ReconstructError, Record, SharedModel};

/// The spectrum of one record beside that of a fitted system.
///
/// Powers are squared moduli of N^(-1/2) sum y(i) exp(-j omega T i), in the sensor's unit squared: white noise of standard deviation s has s^2 at all
/// frequencies. Times 2 T they are one-sided densities per Hz.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SpectralFit {
    /// The record's name.
    pub record: String,
    /// The frequencies used, in rad/s, ascending.
    pub frequencies_rad_s: Vec<f64>,
    /// The sensors, in the order of the channels.
    pub sensors: Vec<SensorSpectrum>,
    /// What noise alone has to explain, over what it is expected to be: (Y - F t)^H Phi (Y - F t) / (m - 1) at each frequency. On average 1 where the model
    /// holds; gamma distributed with shape m - 1.
    pub residuals: Vec<f64>,
}

/// One sensor's part of a [`SpectralFit`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SensorSpectrum {
    /// The sensor's power at each frequency.
    pub measured: Vec<f64>,
    /// The power of the response to the excitation's estimate and to known signals.
    pub response: Vec<f64>,
    /// The part of the response's power that noise adds on average, since the excitation's estimate follows it: |g_s|^2 / (g^H S^-1 g). Response less this
    /// plus noise is what the model expects of the sensor.
    pub absorbed: Vec<f64>,
    /// The power of the noise.
    pub noise: Vec<f64>,
}

/// The noise levels are those of the options where they are given, otherwise `levels`; `direct` are the sensors that read inputs directly.
pub(crate) fn spectral_fit(
    records: &[Record],
    model: &SharedModel,
    levels: &[f64],
    model_error: Option<f64>,
    direct: &[usize],
    options: &Options,
) -> Result<Vec<SpectralFit>, ReconstructError> {
    let sensors = model.c.nrows();
    let (units, mut planner) = (vec![1.0; sensors], RealFftPlanner::new());
    let levels = match &options.noise {
        Noise::Given(given) => given,
        _ => levels,
    };
    let variances: Vec<f64> =
        levels.iter().copied().chain(model_error).map(|level| level.powi(2)).collect();
    let mut fits = Vec::with_capacity(records.len());
    for (index, record) in records.iter().enumerate() {
        let mut spectrum = transform(record, index, &units, options, &mut planner)?;
        let fitted = Fitted { model, record: index, variances: &variances, direct };
        fill_missing(&mut spectrum, &fitted)?;
        fits.push(one(record, &spectrum, &fitted)?);
    }
    Ok(fits)
}

/// What is known of one record's system.
pub(super) struct Fitted<'a> {
    pub(super) model: &'a SharedModel,
    pub(super) record: usize,
    /// Of white noise, and the square of the model error where there is one.
    pub(super) variances: &'a [f64],
    /// The sensors that read inputs directly.
    pub(super) direct: &'a [usize],
}

/// Everything at one frequency.
pub(super) struct At {
    /// g.
    gain: DVector<Complex<f64>>,
    /// F, one column for each coefficient.
    pub(super) known: DMatrix<Complex<f64>>,
    /// S^-1.
    precision: DMatrix<Complex<f64>>,
    /// The diagonal of S.
    noise: Vec<f64>,
    /// Y.
    pub(super) measured: DVector<Complex<f64>>,
}

fn one(
    record: &Record,
    spectrum: &RecordSpectrum,
    fitted: &Fitted<'_>,
) -> Result<SpectralFit, ReconstructError> {
    let sensors = fitted.model.c.nrows();
    let at = |k: usize| At::new(spectrum, k, fitted);
    let coefficients = coefficients(spectrum, fitted)?;
    let nothing = || SensorSpectrum {
        measured: Vec::new(),
        response: Vec::new(),
        absorbed: Vec::new(),
        noise: Vec::new(),
    };
    let period = record.period().seconds();
    let mut fit = SpectralFit {
        record: record.name().to_owned(),
        frequencies_rad_s: Vec::with_capacity(spectrum.frequencies()),
        sensors: (0..sensors).map(|_| nothing()).collect(),
        residuals: Vec::with_capacity(spectrum.frequencies()),
    };
    for k in 0..spectrum.frequencies() {
        let at = at(k)?;
        let explained = &at.known * &coefficients;
        let rest = &at.measured - &explained;
        let response = explained + &at.gain * at.excitation(&rest);
        let left = at.project(&DMatrix::from_column_slice(sensors, 1, rest.as_slice()));
        let cost = rest.dotc(&left.column(0)).re;
        fit.residuals.push(cost / (sensors - 1) as f64);
        fit.frequencies_rad_s.push(spectrum.z[k].arg().abs() / period);
        for (sensor, into) in fit.sensors.iter_mut().enumerate() {
            into.measured.push(at.measured[sensor].norm_sqr());
            into.response.push(response[sensor].norm_sqr());
            into.absorbed.push(at.gain[sensor].norm_sqr() / at.gain_power());
            into.noise.push(at.noise[sensor]);
        }
    }
    Ok(fit)
}

/// The coefficients of the known signals, t, in the columns of F.
fn coefficients(
    spectrum: &RecordSpectrum,
    fitted: &Fitted<'_>,
) -> Result<DVector<Complex<f64>>, ReconstructError> {
    let at = |k: usize| At::new(spectrum, k, fitted);
    let unknowns = at(0)?.known.ncols();
    let mut gram = DMatrix::<f64>::zeros(unknowns, unknowns);
    let mut right = DMatrix::<f64>::zeros(unknowns, 1);
    for k in 0..spectrum.frequencies() {
        let at = at(k)?;
        let weighted = at.project(&at.known).adjoint() * Complex::from(spectrum.weight[k]);
        gram += (&weighted * &at.known).map(|entry| entry.re);
        right += (&weighted * &at.measured).map(|entry| entry.re);
    }
    Ok(least_squares(&gram, &right).column(0).map(Complex::from))
}

/// Puts the most likely values into the places of missing samples: in turns with the coefficients of the known signals, which hardly depend on them.
pub(super) fn fill_missing(
    spectrum: &mut RecordSpectrum,
    fitted: &Fitted<'_>,
) -> Result<(), ReconstructError> {
    const TURNS: usize = 5;
    let Some(missing) = spectrum.missing.clone() else { return Ok(()) };
    let Fitted { model, record, variances, direct } = *fitted;
    let (n, m) = (model.a.nrows(), model.c.nrows());
    let feedthrough = model.feedthrough.as_ref().map(|all| all[record].clone());
    let system = System {
        a: model.a.clone(),
        c: model.c.clone(),
        b: vec![model.b[record].clone()],
        d: vec![feedthrough.unwrap_or_else(|| DVector::zeros(m))],
        derivatives: None,
    };
    for _ in 0..TURNS {
        let found = coefficients(spectrum, fitted)?;
        let mut found = found.iter().map(|coefficient| coefficient.re);
        let mut spread = Vec::with_capacity(spectrum.entries.len());
        for entry in &spectrum.entries {
            let rows: Vec<usize> = match entry {
                Entry::State => (0..n).collect(),
                Entry::StateAndFeedthrough => (0..n).chain(direct.iter().map(|s| n + s)).collect(),
                Entry::Sensors => (n..n + m).collect(),
            };
            let mut own = vec![0.0; n + m];
            rows.into_iter().zip(&mut found).for_each(|(row, value)| own[row] = value);
            spread.push(own);
        }
        let system = RecordSystem::new(&system, 0, &spread, variances);
        let Some(filled) = missing.filled(spectrum, &system, None) else { return Ok(()) };
        spectrum.y = filled.y;
    }
    Ok(())
}

impl At {
    pub(super) fn new(
        spectrum: &RecordSpectrum,
        k: usize,
        fitted: &Fitted<'_>,
    ) -> Result<Self, ReconstructError> {
        let Fitted { model, record, variances, direct } = *fitted;
        let (n, m) = (model.a.nrows(), model.c.nrows());
        let matrix =
            DMatrix::from_diagonal_element(n, n, spectrum.z[k]) - model.a.map(Complex::from);
        let resolvent =
            matrix.try_inverse().filter(|inverse| inverse.iter().all(|x| x.is_finite()));
        let resolvent = resolvent.ok_or_else(|| ReconstructError::Step {
            step: "spectra of the fitted system",
            message: "an eigenvalue lies on a frequency of the record exactly".to_owned(),
        })?;
        let h = model.c.map(Complex::from) * resolvent;
        let mut gain = &h * model.b[record].map(Complex::from);
        if let Some(feedthrough) = &model.feedthrough {
            gain += feedthrough[record].map(Complex::from);
        }
        let mut columns: Vec<DVector<Complex<f64>>> = Vec::new();
        let factors = &spectrum.factors[k * spectrum.entries.len()..];
        for (entry, factor) in spectrum.entries.iter().zip(factors) {
            let unit = |sensor: usize| {
                DVector::from_fn(
                    m,
                    |row, _| if row == sensor { *factor } else { Complex::default() },
                )
            };
            if *entry != Entry::Sensors {
                columns.extend(h.column_iter().map(|column| column * *factor));
            }
            match entry {
                Entry::State => {}
                Entry::StateAndFeedthrough => columns.extend(direct.iter().map(|&s| unit(s))),
                Entry::Sensors => columns.extend((0..m).map(unit)),
            }
        }
        let (precision, noise) = match &spectrum.precision {
            Some(all) => {
                let own = DMatrix::from_row_slice(m, m, &all[k * m * m..(k + 1) * m * m]);
                let covariance = crate::model::noise_spectrum::inverse_of_hermitian(&own);
                let diagonal = |s: usize| covariance.as_ref().map_or(f64::NAN, |c| c[(s, s)].re);
                let noise = (0..m).map(diagonal).collect();
                (own, noise)
            }
            None => {
                let variance = |sensor| spectrum.variance(k, sensor, variances);
                let noise: Vec<f64> = (0..m).map(variance).collect();
                let inverse = noise.iter().map(|variance| Complex::new(1.0 / variance, 0.0));
                (DMatrix::from_diagonal(&DVector::from_iterator(m, inverse)), noise)
            }
        };
        Ok(Self {
            gain,
            known: if columns.is_empty() {
                DMatrix::zeros(m, 0)
            } else {
                DMatrix::from_columns(&columns)
            },
            precision,
            noise,
            measured: DVector::from_column_slice(&spectrum.y[k * m..(k + 1) * m]),
        })
    }

    /// g^H S^-1 g, positive.
    fn gain_power(&self) -> f64 {
        self.gain.dotc(&(&self.precision * &self.gain)).re.max(f64::MIN_POSITIVE)
    }

    /// U.
    fn excitation(&self, rest: &DVector<Complex<f64>>) -> Complex<f64> {
        self.gain.dotc(&(&self.precision * rest)) / self.gain_power()
    }

    /// Phi times the columns.
    pub(super) fn project(&self, columns: &DMatrix<Complex<f64>>) -> DMatrix<Complex<f64>> {
        let weighted = &self.precision * columns;
        let along = &self.precision * &self.gain / Complex::from(self.gain_power());
        &weighted - along * (self.gain.adjoint() * &weighted)
    }
}

/// The shortest solutions of normal equations, in scaled unknowns: one for each right side, which is a column.
pub(super) fn least_squares(gram: &DMatrix<f64>, right: &DMatrix<f64>) -> DMatrix<f64> {
    /// What the records do not determine is left at zero.
    const RANK_TOLERANCE: f64 = 1e-12;
    let scale = gram.diagonal().map(|entry| if entry > 0.0 { 1.0 / entry.sqrt() } else { 0.0 });
    let scaled =
        DMatrix::from_fn(gram.nrows(), gram.ncols(), |i, k| gram[(i, k)] * scale[i] * scale[k]);
    let mut solution = DMatrix::zeros(right.nrows(), right.ncols());
    if gram.nrows() == 0 {
        return solution;
    }
    let scale = DMatrix::from_diagonal(&scale);
    let (eigen, right) = (scaled.symmetric_eigen(), &scale * right);
    for (k, &value) in eigen.eigenvalues.iter().enumerate() {
        if value > RANK_TOLERANCE {
            let vector = eigen.eigenvectors.column(k);
            solution += vector * (vector.transpose() * &right / value);
        }
    }
    scale * solution
}

#[cfg(test)]
mod tests;
