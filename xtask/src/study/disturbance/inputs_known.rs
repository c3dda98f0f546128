//! The yardstick: a regression that is told what the controls did.
//!
//! y(k) = sum A_i y(k-i) + B_i u(k-i) + e(k) by least squares: with enough lags e is white whatever
//! the gusts are, for the past outputs predict them. What the controls alone do is then a sequence
//! of Markov parameters, H_k = B_k + sum A_i H_(k-i), which the eigensystem realization algorithm
//! turns into eigenvalues.
//!
//! Source: Juang, Phan, Horta & Longman (1993), Identification of observer/Kalman filter Markov
//! parameters.

use lti::{Discrete, SamplePeriod, StateSpace, z_to_s};
use nalgebra::DMatrix;
use num_complex::Complex;

use super::flights::Flight;
use crate::shared::paper_aircraft::{SENSORS, SURFACES};

/// Lags: 2 s.
const LAGS: usize = 20;
/// Block rows and columns of the Hankel matrix: 5 s, three periods of the Dutch roll and as many
/// time constants of the roll mode.
const BLOCKS: usize = 50;
const ORDER: usize = 4;

/// The eigenvalues in 1/s; `None` where the equations have no solution.
pub(crate) fn eigenvalues(flight: &Flight, period: SamplePeriod) -> Option<Vec<Complex<f64>>> {
    let a = realised(&markov_parameters(&regression(flight)?))?;
    let n = a.nrows();
    let (none, empty) = (DMatrix::zeros(n, 0), DMatrix::zeros(0, n));
    let system = StateSpace::<Discrete>::new(a, none, empty, DMatrix::zeros(0, 0), period).ok()?;
    let poles = system.poles().ok()?;
    poles.into_iter().map(|z| z_to_s(z, period).ok()).collect()
}

/// A_i and B_i, lag by lag.
fn regression(flight: &Flight) -> Option<Vec<(DMatrix<f64>, DMatrix<f64>)>> {
    let (m, q) = (SENSORS.len(), SURFACES.len());
    let width = m + q;
    let mut rows = Vec::new();
    for (surface, record) in flight.records.iter().enumerate() {
        let y = |sensor: usize, k: usize| record.channels()[sensor].values[k];
        let u = |input: usize, k: usize| {
            if input == surface { flight.controls[surface][k] } else { 0.0 }
        };
        let (y, u) = (&y, &u);
        for k in LAGS..record.samples() {
            let past = (1..=LAGS).flat_map(|lag| {
                let sensors = (0..m).map(move |sensor| y(sensor, k - lag));
                sensors.chain((0..q).map(move |input| u(input, k - lag)))
            });
            rows.extend(past.chain((0..m).map(|sensor| y(sensor, k))));
        }
    }
    let columns = LAGS * width;
    let all = DMatrix::from_row_slice(rows.len() / (columns + m), columns + m, &rows);
    let factor = all.qr().r();
    let lead = factor.view((0, 0), (columns, columns)).into_owned();
    let solution =
        lead.solve_upper_triangular(&factor.view((0, columns), (columns, m)).into_owned())?;
    let lag = |lag: usize| {
        let block = |from: usize, size: usize| solution.rows(lag * width + from, size).transpose();
        (block(0, m), block(m, q))
    };
    Some((0..LAGS).map(lag).collect())
}

/// H_1, H_2, ..: the response of the sensors to one sample of each surface.
fn markov_parameters(lags: &[(DMatrix<f64>, DMatrix<f64>)]) -> Vec<DMatrix<f64>> {
    let mut found: Vec<DMatrix<f64>> = Vec::new();
    for k in 0..2 * BLOCKS {
        let direct = DMatrix::zeros(SENSORS.len(), SURFACES.len());
        let mut next = lags.get(k).map_or(direct, |(_, b)| b.clone());
        for (i, (a, _)) in lags.iter().enumerate().take(k) {
            next += a * &found[k - 1 - i];
        }
        found.push(next);
    }
    found
}

fn realised(markov: &[DMatrix<f64>]) -> Option<DMatrix<f64>> {
    let (m, q) = (SENSORS.len(), SURFACES.len());
    let hankel = |shift: usize| {
        DMatrix::from_fn(BLOCKS * m, BLOCKS * q, |i, k| {
            markov.get(i / m + k / q + shift).map_or(0.0, |h| h[(i % m, k % q)])
        })
    };
    if markov.iter().any(|h| h.iter().any(|entry| !entry.is_finite())) {
        return None;
    }
    let svd = hankel(0).svd(true, true);
    let (u, v) = (svd.u?, svd.v_t?.transpose());
    // nalgebra does not promise an order.
    let mut places: Vec<usize> = (0..svd.singular_values.len()).collect();
    places.sort_by(|i, k| svd.singular_values[*k].total_cmp(&svd.singular_values[*i]));
    places.truncate(ORDER);
    let (u, v) = (u.select_columns(&places), v.select_columns(&places));
    let weight = DMatrix::from_diagonal(&nalgebra::DVector::from_iterator(
        ORDER,
        places.iter().map(|place| 1.0 / svd.singular_values[*place].sqrt()),
    ));
    Some(&weight * u.transpose() * hankel(1) * v * &weight)
}

#[cfg(test)]
mod tests;
