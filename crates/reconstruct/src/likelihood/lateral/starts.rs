//! Where the search for the derivatives starts: a black box turned into the states of the equations, null vectors of the moment equations, and derivatives of
//! aircraft as they mostly are.

use lti::logarithm;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use crate::SharedModel;
use crate::likelihood::cost::lateral::LateralParameters;
use crate::likelihood::cost::spectrum::RecordSpectrum;
use crate::model::lateral_equations::{G_OVER_U, MOMENTS, NAMES, STATES, TAN_THETA};

/// L and N by beta, p and r: slow and fast aircraft in 1/s^2 and 1/s.
const USUAL_MOMENTS: [[f64; 6]; 2] =
    [[-8.0, -2.0, 0.5, 2.0, -0.1, -0.3], [-20.0, -4.0, 1.0, 6.0, -0.1, -0.5]];
const USUAL_SIDE: [f64; 4] = [-0.15, 0.05, -1.0, 0.08];
const USUAL_TAN: f64 = 0.05;
const RANGE_OF_G_OVER_U: (f64, f64) = (0.03, 0.5);
const RANGE_OF_Y_P: (f64, f64) = (-0.1, 0.25);
const RANGE_OF_Y_R: (f64, f64) = (-1.1, -0.9);

/// The starts of a search, the most promising first.
pub(super) fn starts(
    own: &LateralParameters,
    model: &SharedModel,
    spectra: &[RecordSpectrum],
) -> Vec<DVector<f64>> {
    let mut starts: Vec<_> = from_black_box(own, model).into_iter().collect();
    let of_null_vectors = from_null_vectors(own, spectra);
    let controls = starts.first().or(of_null_vectors.as_ref()).cloned();
    starts.extend(of_null_vectors);
    if let Some(controls) = controls {
        let usual = |moments: &[f64; 6]| {
            let mut start = controls.clone();
            start.rows_mut(0, STATES).copy_from_slice(&USUAL_SIDE);
            start.rows_mut(STATES, 2 * MOMENTS).copy_from_slice(moments);
            start[TAN_THETA] = USUAL_TAN;
            start
        };
        starts.extend(USUAL_MOMENTS.iter().map(usual));
    }
    starts
}

/// A black box in the states beta, p, r as its sensors read them, and phi, whose rate is p + tan(theta) r.
fn from_black_box(own: &LateralParameters, model: &SharedModel) -> Option<DVector<f64>> {
    let n = model.a.nrows();
    if n < STATES {
        return None;
    }
    let a = logarithm(&model.a).ok()?.value / own.period();
    let [beta, p, r] = own.sensors()?;
    let rate = model.c.row(p) + model.c.row(r) * USUAL_TAN;
    let phi = a.transpose().svd(true, true).solve(&rate.transpose(), 1e-9).ok()?;
    let states = DMatrix::from_rows(&[
        model.c.row(beta).into_owned(),
        model.c.row(p).into_owned(),
        model.c.row(r).into_owned(),
        phi.transpose(),
    ]);
    let inverse = states.clone().pseudo_inverse(1e-9).ok()?;
    let turned = &states * &a * inverse;
    let mut start = DVector::zeros(NAMES.len());
    for column in 0..MOMENTS {
        start[column] = turned[(0, column)];
        start[STATES + column] = turned[(1, column)];
        start[STATES + MOMENTS + column] = turned[(2, column)];
    }
    start[1] = start[1].clamp(RANGE_OF_Y_P.0, RANGE_OF_Y_P.1);
    start[2] = start[2].clamp(RANGE_OF_Y_R.0, RANGE_OF_Y_R.1);
    start[G_OVER_U] = turned[(0, 3)].clamp(RANGE_OF_G_OVER_U.0, RANGE_OF_G_OVER_U.1);
    start[TAN_THETA] = USUAL_TAN;
    // Over one period a control moves the states by about T times its derivatives.
    let controls: Vec<_> =
        model.b.iter().map(|b| &states * b).map(|b| [b[0], b[1], b[2]]).collect();
    let start = own.of_derivatives(&start, &controls);
    start.iter().all(|value| value.is_finite()).then_some(start)
}

/// One combination of the two moment equations is free of each record's control: the combination of p', r', beta, p, r and a constant that is smallest (total least
/// squares). Two records make both equations.
fn from_null_vectors(own: &LateralParameters, spectra: &[RecordSpectrum]) -> Option<DVector<f64>> {
    let [beta, p, r] = own.sensors()?;
    let (mut rates, mut derivatives) = (Vec::new(), Vec::new());
    for spectrum in spectra {
        let count = spectrum.frequencies();
        let mut rows = DMatrix::<f64>::zeros(2 * count, 2 + MOMENTS);
        let mut constant = DVector::<f64>::zeros(2 * count);
        for (k, &z) in spectrum.z.iter().enumerate() {
            let y = |sensor: usize| own.reading(spectrum, k, sensor);
            // At most half the sampling frequency, whose angle may be minus pi.
            let s = Complex::new(0.0, z.arg().abs() / own.period());
            let row = [s * y(p), s * y(r), y(beta), y(p), y(r)];
            for (column, value) in row.into_iter().enumerate() {
                rows[(k, column)] = value.re;
                rows[(count + k, column)] = value.im;
            }
            constant[k] = 1.0;
        }
        let constant = constant.normalize();
        let along = constant.transpose() * &rows;
        let mut rows = rows - constant * along;
        let sizes: Vec<f64> = rows.column_iter().map(|column| column.norm()).collect();
        if sizes.iter().any(|size| *size <= 0.0 || size.is_nan()) {
            return None;
        }
        for (mut column, size) in rows.column_iter_mut().zip(&sizes) {
            column /= *size;
        }
        let eigen = rows.tr_mul(&rows).symmetric_eigen();
        let smallest = eigen.eigenvectors.column(eigen.eigenvalues.imin());
        let mut null: Vec<f64> = smallest.iter().zip(&sizes).map(|(v, size)| v / size).collect();
        let length = null[0].hypot(null[1]);
        null.iter_mut().for_each(|value| *value /= length);
        rates.push([null[0], null[1]]);
        derivatives.push([-null[2], -null[3], -null[4]]);
    }
    let left = DMatrix::from_fn(rates.len(), 2, |row, column| rates[row][column]);
    let right = DMatrix::from_fn(rates.len(), MOMENTS, |row, column| derivatives[row][column]);
    let moments = left.svd(true, true).solve(&right, 1e-9).ok()?;
    let mut start = DVector::zeros(NAMES.len());
    start.rows_mut(0, STATES).copy_from_slice(&USUAL_SIDE);
    for column in 0..MOMENTS {
        start[STATES + column] = moments[(0, column)];
        start[STATES + MOMENTS + column] = moments[(1, column)];
    }
    start[TAN_THETA] = USUAL_TAN;
    let controls: Vec<_> = rates.iter().map(|rate| [0.0, rate[1], -rate[0]]).collect();
    let start = own.of_derivatives(&start, &controls);
    start.iter().all(|value| value.is_finite()).then_some(start)
}
