//! What the variances of the noise are measured in, where they start, what they do not fall below, and the power that a model error is a part of.

use num_complex::Complex;

use crate::Record;
use crate::likelihood::options::{Noise, Options};
use crate::model::record::{deviation, over_all, rms};

/// Where nothing is known, the noise starts at this part of a sensor's root mean square over all records.
const FIRST_GUESS: f64 = 0.01;

/// The least relative model error, where there is one.
pub(crate) const LEAST_MODEL_ERROR: f64 = 1e-3;
/// Beside a model error no level is below this part of its sensor's root mean square.
const LEAST_LEVEL: f64 = 1e-3;

/// What each sensor is divided by: its noise level as far as it is known.
pub(crate) fn sensor_units(records: &[Record], options: &Options) -> Vec<f64> {
    let sensors = records.first().map_or(0, |record| record.channels().len());
    match &options.noise {
        Noise::Given(levels)
        | Noise::Estimated { first_guess: Some(levels) }
        | Noise::ModelError { first_guess: Some(levels) } => levels.clone(),
        Noise::Estimated { first_guess: None } | Noise::ModelError { first_guess: None } => {
            let size =
                |sensor: usize| over_all(records, |record| rms(&record.channels()[sensor].values));
            (0..sensors).map(|sensor| FIRST_GUESS * size(sensor)).collect()
        }
        Noise::Spectra(spectra) => (0..sensors)
            .map(|sensor| {
                let all = spectra.iter().flat_map(|spectrum| spectrum.covariances());
                let (sum, number) = all.fold((0.0, 0.0), |(sum, number), covariance| {
                    (sum + covariance[(sensor, sensor)].re, number + 1.0)
                });
                (sum / number).sqrt()
            })
            .collect(),
    }
}

/// What no variance of the noise falls below, in the units of the sensors. White noise stops at rounding errors; with a model error each level stops at
/// a thousandth of its sensor's root mean square, and the model error itself at a thousandth.
pub(crate) fn floors(records: &[Record], units: &[f64], options: &Options) -> Vec<f64> {
    const ROUNDING: f64 = 1e-24;
    if !matches!(options.noise, Noise::ModelError { .. }) {
        return vec![ROUNDING; units.len()];
    }
    let level =
        |(sensor, unit): (usize, &f64)| (LEAST_LEVEL * deviation(records, sensor) / unit).powi(2);
    let mut floors: Vec<f64> = units.iter().enumerate().map(level).collect();
    floors.push(LEAST_MODEL_ERROR * LEAST_MODEL_ERROR);
    floors
}

/// Variances to start from, in the units of the sensors: 1 for each, which its unit is made for, and a model error of one per cent.
pub(crate) fn first_variances(floors: &[f64], sensors: usize) -> Vec<f64> {
    const MODEL_ERROR: f64 = 0.01;
    let mut variances = vec![1.0; sensors];
    if floors.len() > sensors {
        variances.push(MODEL_ERROR * MODEL_ERROR);
    }
    variances
}

/// The periodogram of one sensor, smoothed by a triangle over five frequencies: two to each side. An offset counts for nothing where it is not part of
/// the motion.
pub(crate) fn smoothed_power(transform: &[Complex<f64>], offset: bool) -> Vec<f64> {
    const TRIANGLE: [(isize, f64); 5] =
        [(-2, 1.0 / 9.0), (-1, 2.0 / 9.0), (0, 3.0 / 9.0), (1, 2.0 / 9.0), (2, 1.0 / 9.0)];
    let last = transform.len() as isize - 1;
    let at = |k: isize| {
        // Reflected at both ends, where the spectrum of a real signal goes on as its mirror image.
        let k = if k < 0 { -k } else { k };
        let k = if k > last { (2 * last - k).max(0) } else { k };
        let k = if k == 0 && offset { 1.min(last) } else { k };
        transform[k.unsigned_abs()].norm_sqr()
    };
    (0..=last).map(|k| TRIANGLE.iter().map(|(lag, weight)| weight * at(k + lag)).sum()).collect()
}
