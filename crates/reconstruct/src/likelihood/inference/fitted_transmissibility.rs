//! The transmissibilities of a fitted system: response, zeros and poles of every pair of sensors in each record, with their uncertainty.

use lti::{Discrete, StateSpace};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::fit::Fit;
use super::uncertainty::ComplexEstimate;
use crate::{ReconstructError, SharedModel};

/// The transmissibility T = G_to / G_from between two sensors in one record, as a fitted system has it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FittedTransmissibility {
    /// Index of the record.
    pub record: usize,
    /// Index of the sensor that plays the input.
    pub from: usize,
    /// Index of the sensor that is to follow from it.
    pub to: usize,
    /// T at the frequencies asked for, in the unit of `to` over that of `from`.
    pub response: Vec<ComplexEstimate>,
    /// The zeros of T in the z plane: those of the excitation's transfer function to sensor `to`. A conjugate pair is there twice.
    pub zeros: Vec<ComplexEstimate>,
    /// The poles of T: the zeros of the transfer function to sensor `from`.
    pub poles: Vec<ComplexEstimate>,
}

/// The transmissibilities of each record, for every pair of sensors with `from < to`.
///
/// With R = (zI - A)^-1 and g_s = c_s R b_j + d_js the transfer function from record j's unknown excitation to sensor s, T = g_to / g_from at
/// z = exp(j omega T_s), whatever the scale of b_j. Deviations follow to first order from the covariance of (A, C, b_j, d_j):
///
/// ```text
/// dg_s = c_s R dA R b + dc_s R b + c_s R db + dd_s,   dT = (dg_to - T dg_from) / g_from,   dz_0 = dg_s(z_0) / (c_s R^2 b)
/// ```
///
/// where g_s(z_0) = 0. The zeros are the invariant zeros of (A, b_j, c_s, d_js), at most n - 1 without feedthrough; their order is that of
/// [`StateSpace::invariant_zeros`]. Where noise has made a vanishing leading coefficient small instead of zero, there are zeros far out, with
/// deviations as large.
///
/// # Errors
///
/// [`ReconstructError::Step`] for a frequency that is not finite or at which A has an eigenvalue exactly.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../../doctest/two_decays.md")]
/// use reconstruct::likelihood::fitted_transmissibilities;
/// use reconstruct::{Options, reconstruct};
///
/// let records = two_decays(0.9, 500, 0.01)?;
/// let found = reconstruct(&records, &Options::default())?;
/// let all = fitted_transmissibilities(found.fit().ok_or("no fit")?, &[0.0])?;
/// // From y1 to y2 in the first record: T(z) = 0.4 / (2 z - 1.4), and T(1) = 2/3.
/// let first = &all[0];
/// assert_eq!((first.record, first.from, first.to), (0, 0, 1));
/// let response = first.response[0];
/// assert!((response.value.re - 2.0 / 3.0).abs() < 4.0 * response.real_standard_error());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fitted_transmissibilities(
    fit: &Fit,
    frequencies_rad_s: &[f64],
) -> Result<Vec<FittedTransmissibility>, ReconstructError> {
    let model = &fit.model;
    let sensors = model.c.nrows();
    let free = Parameters::of(fit);
    let mut found = Vec::new();
    for record in 0..model.b.len() {
        let mut gains = Vec::with_capacity(frequencies_rad_s.len());
        for &frequency in frequencies_rad_s {
            if !frequency.is_finite() {
                return Err(failed(format!("{frequency} rad/s is not a finite frequency")));
            }
            let z = Complex::from_polar(1.0, frequency * model.period.seconds());
            let at = At::new(model, record, z).ok_or_else(|| {
                failed(format!("an eigenvalue lies at {frequency} rad/s exactly"))
            })?;
            let each = (0..sensors).map(|sensor| at.gain(model, &free, record, sensor));
            gains.push(each.collect::<Vec<_>>());
        }
        let zeros = (0..sensors)
            .map(|sensor| zeros(fit, &free, record, sensor))
            .collect::<Result<Vec<_>, _>>()?;
        for (from, to) in (0..sensors).flat_map(|to| (0..to).map(move |from| (from, to))) {
            let response = gains.iter().map(|gains| ratio(&gains[from], &gains[to], fit));
            found.push(FittedTransmissibility {
                record,
                from,
                to,
                response: response.collect(),
                zeros: zeros[to].clone(),
                poles: zeros[from].clone(),
            });
        }
    }
    Ok(found)
}

/// Where each parameter stands in the covariance: A by columns, C by columns, then b_j and the free entries of d_j of each record.
struct Parameters {
    count: usize,
    /// Entries of each record.
    own: usize,
    /// The sensors with feedthrough.
    feedthrough: Vec<usize>,
}

impl Parameters {
    fn of(fit: &Fit) -> Self {
        let (n, m) = (fit.model.a.nrows(), fit.model.c.nrows());
        let count = fit.covariance.nrows();
        let own = (count - n * (n + m)) / fit.model.b.len();
        Self { count, own, feedthrough: fit.feedthrough_sensors.clone() }
    }
}

/// R b and R at one point.
struct At {
    resolvent: DMatrix<Complex<f64>>,
    states: DVector<Complex<f64>>,
}

/// A transfer function's value and its derivatives by all parameters.
struct Gain {
    value: Complex<f64>,
    slopes: DVector<Complex<f64>>,
}

impl At {
    fn new(model: &SharedModel, record: usize, z: Complex<f64>) -> Option<Self> {
        let n = model.a.nrows();
        let matrix = DMatrix::from_diagonal_element(n, n, z) - model.a.map(Complex::from);
        let resolvent = matrix.try_inverse()?;
        let states = &resolvent * model.b[record].map(Complex::from);
        states.iter().all(|state| state.is_finite()).then_some(Self { resolvent, states })
    }

    fn gain(&self, model: &SharedModel, free: &Parameters, record: usize, sensor: usize) -> Gain {
        let (n, m) = (model.a.nrows(), model.c.nrows());
        let row = model.c.row(sensor).map(Complex::from) * &self.resolvent;
        let direct = model.feedthrough.as_ref().map_or(0.0, |all| all[record][sensor]);
        let value = (model.c.row(sensor).map(Complex::from) * &self.states)[0] + direct;
        let mut slopes = DVector::zeros(free.count);
        for l in 0..n {
            for i in 0..n {
                slopes[l * n + i] = row[i] * self.states[l];
            }
            slopes[n * n + l * m + sensor] = self.states[l];
        }
        let start = n * (n + m) + record * free.own;
        for i in 0..n {
            slopes[start + i] = row[i];
        }
        if let Some(place) = free.feedthrough.iter().position(|&other| other == sensor) {
            slopes[start + n + place] = Complex::new(1.0, 0.0);
        }
        Gain { value, slopes }
    }
}

fn ratio(from: &Gain, to: &Gain, fit: &Fit) -> ComplexEstimate {
    let value = to.value / from.value;
    let slopes = (&to.slopes - &from.slopes * value) / from.value;
    ComplexEstimate::from_slopes(value, &slopes, &fit.covariance)
}

/// The zeros of the transfer function from one record's excitation to one sensor.
fn zeros(
    fit: &Fit,
    free: &Parameters,
    record: usize,
    sensor: usize,
) -> Result<Vec<ComplexEstimate>, ReconstructError> {
    let model = &fit.model;
    let n = model.a.nrows();
    let direct = model.feedthrough.as_ref().map_or(0.0, |all| all[record][sensor]);
    let system = StateSpace::<Discrete>::new(
        model.a.clone(),
        DMatrix::from_column_slice(n, 1, model.b[record].as_slice()),
        model.c.rows(sensor, 1).into_owned(),
        DMatrix::from_element(1, 1, direct),
        model.period,
    )
    .map_err(|error| failed(error.to_string()))?;
    let values = system.invariant_zeros().map_err(|error| failed(error.to_string()))?.values();
    let estimate = |z: Complex<f64>| {
        // A zero on an eigenvalue cancels: there is no excitation or no sight of that mode, and its place has no derivative.
        let unknown = ComplexEstimate {
            value: z,
            covariance: nalgebra::Matrix2::from_diagonal_element(f64::INFINITY),
        };
        let Some(at) = At::new(model, record, z) else { return unknown };
        let slope = (model.c.row(sensor).map(Complex::from) * &at.resolvent * &at.states)[0];
        let gain = at.gain(model, free, record, sensor);
        let slopes = gain.slopes / slope;
        if !slopes.iter().all(|slope| slope.is_finite()) {
            return unknown;
        }
        ComplexEstimate::from_slopes(z, &slopes, &fit.covariance)
    };
    Ok(values.into_iter().map(estimate).collect())
}

fn failed(message: String) -> ReconstructError {
    ReconstructError::Step { step: "transmissibilities of the fitted system", message }
}

#[cfg(test)]
mod tests;
