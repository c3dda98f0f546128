//! The disturbance's spectrum from a quiet record, by a vector autoregression.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::noise_spectrum::NoiseSpectrum;
use super::record::Record;
use super::record::rms;
use crate::ReconstructError;

/// v(k) = A_1 v(k-1) + .. + A_p v(k-p) + e(k), e white with covariance Sigma, fitted by least squares.
///
/// A quiet record is one in which nobody moves the controls on purpose: what the sensors read there is turbulence and sensor noise alone. Its
/// spectrum S(z) = F(z)^-1 Sigma F(z)^-H, F(z) = I - A_1 z^-1 - .. - A_p z^-p, tells the likelihood how to weigh frequencies and sensors. Means are
/// taken off first: a constant belongs to the offsets. Where samples are missing, the equations that they are in are left out.
///
/// Source: Lutkepohl, New Introduction to Multiple Time Series Analysis (2005), 3.2 (least squares) and 4.3 (choice of the order).
///
/// # Example
///
/// Every other sample of this record is the same with its sign changed: v(k) = -v(k-1).
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::likelihood::{AutoregressionOrder, VectorAutoregression};
/// use reconstruct::{Channel, Record};
///
/// let wobble = |k: i32| f64::from(k * k % 7) * 1e-3;
/// let values = (0..200).map(|k| f64::from(1 - 2 * (k % 2)) + wobble(k)).collect();
/// let record = Record::new("quiet", SamplePeriod::new(0.1)?, vec![Channel::new("beta", values)])?;
/// let fitted = VectorAutoregression::fit(&record, AutoregressionOrder::Fixed(1))?;
/// assert!((fitted.coefficients()[0][(0, 0)] + 1.0).abs() < 1e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VectorAutoregression {
    coefficients: Vec<DMatrix<f64>>,
    innovation: DMatrix<f64>,
}

/// How many past samples the autoregression looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AutoregressionOrder {
    /// So many.
    Fixed(usize),
    /// The number up to this one with the smallest Akaike criterion ln det Sigma + 2 p m^2 / N. It errs on the long side, which a spectrum bears
    /// better than an order that is too short.
    Akaike {
        /// The largest number that is tried.
        largest: usize,
    },
}

impl VectorAutoregression {
    /// Fits an autoregression to all channels of a record.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::Noise`] where the record has fewer than 2 m equations per unknown row, m p + 1, or where its samples do not determine the
    /// fit: a channel that is constant, or the copy of another.
    pub fn fit(record: &Record, order: AutoregressionOrder) -> Result<Self, ReconstructError> {
        let mut largest = match order {
            AutoregressionOrder::Fixed(order) => order,
            AutoregressionOrder::Akaike { largest } => largest,
        };
        let sensors = record.channels().len();
        let (samples, unknowns) =
            (record.samples(), largest.saturating_mul(sensors).saturating_add(1));
        let equations_needed = unknowns.saturating_mul(2);
        let too_few = |what: &str, largest: usize, needed: usize| {
            fault(format!(
                "record {:?} has {what}, an autoregression of order {largest} with {sensors} sensors needs {needed}",
                record.name(),
            ))
        };
        if samples < largest.saturating_add(equations_needed) {
            let needed = largest.saturating_add(equations_needed);
            return Err(too_few(&format!("{samples} samples"), largest, needed));
        }
        let signals = standardised(record)?;
        let mut rows = complete_equations(&signals, largest);
        // Missing samples leave few long runs: of the orders that may be chosen, those are tried that they allow.
        while matches!(order, AutoregressionOrder::Akaike { .. })
            && largest > 0
            && rows.len() < 2 * (largest * sensors + 1)
        {
            largest -= 1;
            rows = complete_equations(&signals, largest);
        }
        if rows.len() < 2 * (largest * sensors + 1) {
            let found = rows.len();
            let what = format!("{found} runs of {} samples of which none is missing", largest + 1);
            return Err(too_few(&what, largest, 2 * (largest * sensors + 1)));
        }
        let factor = triangle(&signals, largest, &rows);
        let equations = rows.len() as f64;
        let fit = |order: usize| solve(&factor, order, largest, sensors, equations);
        let (coefficients, innovation) = match order {
            AutoregressionOrder::Fixed(order) => fit(order),
            AutoregressionOrder::Akaike { .. } => {
                let mut best: Option<(f64, usize)> = None;
                for order in 0..=largest {
                    let Some((_, innovation)) = fit(order) else { continue };
                    let parameters = (order * sensors * sensors) as f64;
                    // With the maximum likelihood estimate of Sigma, that is without the correction for parameters.
                    let shrink = sensors as f64
                        * ((equations - (order * sensors) as f64) / equations).ln();
                    let criterion =
                        innovation.determinant().ln() + shrink + 2.0 * parameters / equations;
                    if best.is_none_or(|(least, _)| criterion < least) {
                        best = Some((criterion, order));
                    }
                }
                best.and_then(|(_, order)| fit(order))
            }
        }
        .ok_or_else(|| {
            fault(format!(
                "record {:?} does not determine an autoregression: is a channel the copy of another?",
                record.name()
            ))
        })?;
        let units: Vec<f64> = signals.iter().map(|signal| signal.unit).collect();
        let scaled = |matrix: DMatrix<f64>, power: i32| {
            DMatrix::from_fn(sensors, sensors, |i, k| {
                matrix[(i, k)] * units[i] * units[k].powi(power)
            })
        };
        Ok(Self {
            coefficients: coefficients.into_iter().map(|matrix| scaled(matrix, -1)).collect(),
            innovation: scaled(innovation, 1),
        })
    }

    /// A_1 .. A_p, each m x m.
    #[must_use]
    pub fn coefficients(&self) -> &[DMatrix<f64>] {
        &self.coefficients
    }

    /// Sigma, m x m, corrected for the number of fitted coefficients.
    #[must_use]
    pub fn innovation_covariance(&self) -> &DMatrix<f64> {
        &self.innovation
    }

    /// The spectrum at the frequencies of a record with so many samples.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::Noise`] where F(z) is singular at one of them, an undamped disturbance.
    pub fn spectrum(&self, samples: usize) -> Result<NoiseSpectrum, ReconstructError> {
        let sensors = self.innovation.nrows();
        let complex = |matrix: &DMatrix<f64>| matrix.map(|entry| Complex::new(entry, 0.0));
        let innovation = complex(&self.innovation);
        let coefficients: Vec<_> = self.coefficients.iter().map(complex).collect();
        let step = std::f64::consts::TAU / samples as f64;
        let at = |k: usize| {
            let back = Complex::from_polar(1.0, -step * k as f64);
            // Horner's rule in z^-1.
            let zero = DMatrix::zeros(sensors, sensors);
            let sum = coefficients.iter().rev().fold(zero, |sum, matrix| (sum + matrix) * back);
            let filter = DMatrix::identity(sensors, sensors) - sum;
            let inverse = filter.try_inverse().ok_or_else(|| {
                fault(format!("the autoregression has a pole on the unit circle at frequency {k}"))
            })?;
            let covariance = &inverse * &innovation * inverse.adjoint();
            Ok((&covariance + covariance.adjoint()) * Complex::new(0.5, 0.0))
        };
        let covariances =
            (0..=samples / 2).map(at).collect::<Result<Vec<_>, ReconstructError>>()?;
        NoiseSpectrum::new(samples, covariances)
    }
}

/// A channel without its mean, of unit deviation; NaN where a sample is missing.
struct Signal {
    values: Vec<f64>,
    unit: f64,
}

fn standardised(record: &Record) -> Result<Vec<Signal>, ReconstructError> {
    record
        .marked()
        .iter()
        .map(|channel| {
            let present: Vec<f64> =
                channel.values.iter().copied().filter(|value| !value.is_nan()).collect();
            let number = present.len() as f64;
            let mean = present.iter().map(|value| value / number).sum::<f64>();
            let centred: Vec<f64> = channel.values.iter().map(|value| value - mean).collect();
            let unit = rms(&present.iter().map(|value| value - mean).collect::<Vec<f64>>());
            let constant = present.windows(2).all(|pair| pair[0].total_cmp(&pair[1]).is_eq());
            if constant || !unit.is_finite() {
                return Err(fault(format!(
                    "channel {:?} of record {:?} is constant",
                    channel.name,
                    record.name()
                )));
            }
            Ok(Signal { values: centred.iter().map(|value| value / unit).collect(), unit })
        })
        .collect()
}

/// The k = p .. N-1 for which v(k-p) .. v(k) are all there.
fn complete_equations(signals: &[Signal], largest: usize) -> Vec<usize> {
    let samples = signals.first().map_or(0, |signal| signal.values.len());
    let mut complete = 0;
    let mut found = Vec::new();
    for k in 0..samples {
        let is_there = signals.iter().all(|signal| !signal.values[k].is_nan());
        complete = if is_there { complete + 1 } else { 0 };
        if complete > largest {
            found.push(k);
        }
    }
    found
}

/// The triangular factor of [v(k-1)', .., v(k-p)', v(k)'] for these k, gathered in blocks of rows so that memory does not grow with N.
fn triangle(signals: &[Signal], largest: usize, equations: &[usize]) -> DMatrix<f64> {
    let sensors = signals.len();
    let columns = sensors * (largest + 1);
    let mut factor = DMatrix::<f64>::zeros(0, columns);
    for block in equations.chunks(4 * columns) {
        let mut stacked = DMatrix::zeros(factor.nrows() + block.len(), columns);
        stacked.rows_mut(0, factor.nrows()).copy_from(&factor);
        for (row, k) in block.iter().enumerate() {
            for lag in 0..=largest {
                // Past samples first, the present one last.
                let column = if lag == 0 { largest } else { lag - 1 };
                for (sensor, signal) in signals.iter().enumerate() {
                    stacked[(factor.nrows() + row, column * sensors + sensor)] =
                        signal.values[k - lag];
                }
            }
        }
        factor = stacked.qr().r();
    }
    factor
}

/// Least squares for one order from the factor of the largest one; Sigma over equations less unknowns of each row.
fn solve(
    factor: &DMatrix<f64>,
    order: usize,
    largest: usize,
    sensors: usize,
    equations: f64,
) -> Option<(Vec<DMatrix<f64>>, DMatrix<f64>)> {
    // A regressor of which less than this part is new is a copy of the others.
    const COPY: f64 = 1e-10;
    let past = order * sensors;
    let columns: Vec<usize> = (0..past).chain(largest * sensors..(largest + 1) * sensors).collect();
    let reduced = factor.select_columns(&columns).qr().r();
    let lead = reduced.view((0, 0), (past, past)).into_owned();
    for column in 0..past {
        if lead[(column, column)].abs() <= COPY * lead.column(column).norm() {
            return None;
        }
    }
    let right = reduced.view((0, past), (past, sensors)).into_owned();
    let solution =
        if past == 0 { DMatrix::zeros(0, sensors) } else { lead.solve_upper_triangular(&right)? };
    let rest = reduced.view((past, past), (reduced.nrows() - past, sensors)).into_owned();
    let innovation = rest.transpose() * rest / (equations - past as f64).max(1.0);
    let deviations: DVector<f64> = innovation.diagonal().map(f64::sqrt);
    let definite = innovation.clone().cholesky()?;
    if (0..sensors).any(|i| definite.l()[(i, i)] <= COPY * deviations[i]) {
        return None;
    }
    let coefficients =
        (0..order).map(|lag| solution.rows(lag * sensors, sensors).transpose()).collect();
    Some((coefficients, innovation))
}

fn fault(message: String) -> ReconstructError {
    ReconstructError::Noise { message }
}

#[cfg(test)]
mod tests;
