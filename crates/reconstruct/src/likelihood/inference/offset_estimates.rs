//! How large are the offsets that a fit left free? One constant for each sensor, common to all records.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;
use realfft::RealFftPlanner;

use super::fit::Fit;
use super::spectral_fit::{At, Fitted, least_squares};
use super::uncertainty::Estimate;
use crate::likelihood::cost::spectrum::transform;
use crate::likelihood::options::Options;
use crate::{Measurement, Offsets, ReconstructError, Record};

/// The constant that each sensor adds to its readings, in its unit, where the fit took offsets as free; empty otherwise, and where a mode at z = 1 is itself a
/// constant.
///
/// One record does not tell an offset from an excitation that stays what it is; records with different directions of excitation do, if their sensors are offset by the
/// same. The standard errors hold for noise and model error, with the system as it was fitted.
///
/// # Errors
///
/// Those of [`identify`](crate::likelihood::identify) for records and options.
pub fn offset_estimates(records: &[Record], fit: &Fit) -> Result<Vec<Estimate>, ReconstructError> {
    if fit.options.measurement.offsets != Offsets::Free {
        return Ok(Vec::new());
    }
    // With frequency zero, and no idea of what it holds.
    let measurement = Measurement { offsets: Offsets::AsNeeded, ..fit.options.measurement.clone() };
    let options = Options { measurement, ..fit.options.clone() };
    let sensors = fit.model.c.nrows();
    let (units, mut planner) = (vec![1.0; sensors], RealFftPlanner::new());
    let variances = fit.variances();
    let mut information = DMatrix::<f64>::zeros(sensors, sensors);
    let mut right = DVector::<f64>::zeros(sensors);
    for (index, record) in records.iter().enumerate() {
        let spectrum = transform(record, index, &units, &options, &mut planner)?;
        let direct = &fit.feedthrough_sensors;
        let fitted = Fitted { model: &fit.model, record: index, variances: &variances, direct };
        let Ok(zero) = At::new(&spectrum, 0, &fitted) else { return Ok(Vec::new()) };
        // Coefficients of known signals, then the offsets.
        let coefficients = zero.known.ncols();
        let unknowns = coefficients + sensors;
        let (mut gram, mut own) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
        for k in 0..spectrum.frequencies() {
            let at = At::new(&spectrum, k, &fitted)?;
            let mut columns = at.known.clone().resize_horizontally(unknowns, Complex::default());
            if k == 0 {
                let height = Complex::from((record.samples() as f64).sqrt());
                columns.columns_mut(coefficients, sensors).fill_diagonal(height);
            }
            let weighted = at.project(&columns).adjoint() * Complex::from(spectrum.weight[k]);
            gram += (&weighted * &columns).map(|entry| entry.re);
            own += (&weighted * &at.measured).map(|entry| entry.re);
        }
        // What the coefficients can take over is not the offsets'.
        let gram_of =
            |row, column, rows, columns| gram.view((row, column), (rows, columns)).into_owned();
        let among = gram_of(0, 0, coefficients, coefficients);
        let mixed = gram_of(0, coefficients, coefficients, sensors);
        let taken = least_squares(&among, &mixed);
        information += gram_of(coefficients, coefficients, sensors, sensors) - mixed.tr_mul(&taken);
        right += own.rows(coefficients, sensors) - taken.tr_mul(&own.rows(0, coefficients));
    }
    let Some(covariance) = information.try_inverse() else { return Ok(Vec::new()) };
    let values = &covariance * right;
    let estimate = |sensor: usize| Estimate {
        value: values[sensor],
        standard_error: covariance[(sensor, sensor)].max(0.0).sqrt(),
    };
    Ok((0..sensors).map(estimate).collect())
}

#[cfg(test)]
mod tests;
