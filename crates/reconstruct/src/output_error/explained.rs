//! How much of what a sensor reads does the model explain?

use nalgebra::DMatrix;
use num_complex::Complex;

use super::fit::RecordFit;
use super::spectra::Spectrum;

/// The part of each sensor's power, from what the model leaves and what the sensors read, m x F.
pub(super) fn explained(
    left: &DMatrix<Complex<f64>>,
    measured: &DMatrix<Complex<f64>>,
) -> Vec<f64> {
    let all = left.ncols();
    (0..left.nrows()).map(|row| 1.0 - ratio(left, measured, row, all)).collect()
}

/// The same of the records in which inputs move, by their index, at the frequencies that hold nearly all of a sensor's response: noise beyond them says nothing
/// about the inputs.
pub(super) fn explained_where_it_responds(
    records: &[RecordFit],
    spectra: &[Spectrum],
) -> Vec<(usize, Vec<f64>)> {
    /// Of the power of the response.
    const NEARLY_ALL: f64 = 0.95;
    let moves = |record: &usize| spectra[*record].u.iter().any(|u| u.norm_sqr() > 0.0);
    let of_record = |record: usize| {
        let own = &records[record];
        let part = |sensor: usize| {
            let (measured, left) = (own.measured.row(sensor), own.residuals.row(sensor));
            let response: Vec<f64> =
                measured.iter().zip(left.iter()).map(|(y, e)| (y - e).norm_sqr()).collect();
            let all: f64 = response.iter().sum();
            let mut sum = 0.0;
            let within = response.iter().take_while(|power| {
                let before = sum;
                sum += **power;
                before < NEARLY_ALL * all
            });
            1.0 - ratio(&own.residuals, &own.measured, sensor, within.count())
        };
        (record, (0..own.measured.nrows()).map(part).collect())
    };
    (0..records.len()).filter(moves).map(of_record).collect()
}

/// The power of a sensor's residuals over that of the sensor, at the first `count` frequencies.
fn ratio(
    left: &DMatrix<Complex<f64>>,
    measured: &DMatrix<Complex<f64>>,
    sensor: usize,
    count: usize,
) -> f64 {
    let power = |of: &DMatrix<Complex<f64>>| {
        of.row(sensor).iter().take(count).map(Complex::norm_sqr).sum::<f64>()
    };
    power(left) / power(measured).max(f64::MIN_POSITIVE)
}
