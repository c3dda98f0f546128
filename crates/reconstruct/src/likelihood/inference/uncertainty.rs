//! How well the data determine the system: the covariance of its matrices and of its modes.

use lti::{Discrete, LtiError, SamplePeriod, StateSpace};
use nalgebra::{DMatrix, DVector, Matrix2, Vector2};
use num_complex::Complex;

use crate::likelihood::cost::evaluation::Evaluation;
use crate::likelihood::inference::near_double::{NearDouble, Root, near_doubles};

/// The covariance of the parameters, on the directions that the data can determine.
#[derive(Clone, Debug)]
pub(crate) struct ParameterCovariance {
    /// In the order of the Gram matrix; zero along the changes that leave the likelihood as it is.
    pub(crate) matrix: DMatrix<f64>,
    /// Directions that the data do determine.
    pub(crate) determined: usize,
}

/// Directions with less information than this part of the largest, columns scaled, count as undetermined.
const RANK_TOLERANCE: f64 = 1e-13;

/// The covariance H^-1 S H^-1 with S the Gram matrix and H = S - N, where N is what noise alone adds to it.
///
/// The excitation is one unknown per frequency, so that the estimate's noise enters the Gram matrix: S is the variance of the gradient,
/// but the curvature of the likelihood is H on average. At signal to noise ratios above 30 the two hardly differ.
///
/// `invariants` are the changes that leave the likelihood as it is, one a column.
pub(crate) fn covariance(
    gram: &DMatrix<f64>,
    noise_part: &DMatrix<f64>,
    invariants: &DMatrix<f64>,
) -> ParameterCovariance {
    let scale = gram.diagonal().map(|entry| if entry > 0.0 { 1.0 / entry.sqrt() } else { 1.0 });
    let basis = complement(&scaled_rows(invariants, &scale.map(|entry| 1.0 / entry)));
    let reduced = |matrix: &DMatrix<f64>| {
        let unit = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| {
            matrix[(i, k)] * scale[i] * scale[k]
        });
        basis.transpose() * unit * &basis
    };
    let (gram, noise) = (reduced(gram), reduced(noise_part));
    let (inverse, determined) = pseudo_inverse(&gram);
    // Where noise makes up most of the Gram matrix, H is not positive definite and nothing better than S^-1 can be said.
    let curvature = &gram - &noise;
    let middle = match curvature.cholesky() {
        Some(factor) if determined == gram.nrows() => {
            let inverse = factor.inverse();
            &inverse * &gram * &inverse
        }
        _ => inverse,
    };
    let full = scaled_rows(&basis, &scale);
    let full = &full * middle * full.transpose();
    // The part along changes of basis depends on the scale; without it the covariance belongs to the basis alone.
    let matrix = if invariants.ncols() > 0 {
        let q = invariants.clone().qr().q();
        let project = |matrix: DMatrix<f64>| &matrix - &q * (q.transpose() * &matrix);
        project(project(full).transpose())
    } else {
        full
    };
    ParameterCovariance { matrix: 0.5 * (&matrix + matrix.transpose()), determined }
}

fn scaled_rows(matrix: &DMatrix<f64>, scale: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| matrix[(i, k)] * scale[i])
}

/// An orthonormal basis of the orthogonal complement of the columns, which are independent.
fn complement(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, count) = columns.shape();
    let mut transposed = DMatrix::identity(rows, rows);
    if count == 0 {
        return transposed;
    }
    columns.clone().qr().q_tr_mul(&mut transposed);
    transposed.rows(count, rows - count).transpose()
}

fn pseudo_inverse(matrix: &DMatrix<f64>) -> (DMatrix<f64>, usize) {
    let (mut inverse, mut rank) = (DMatrix::zeros(matrix.nrows(), matrix.ncols()), 0);
    if matrix.nrows() == 0 {
        return (inverse, rank);
    }
    let eigen = matrix.clone().symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    for (k, &value) in eigen.eigenvalues.iter().enumerate() {
        if value > RANK_TOLERANCE * largest {
            let vector = eigen.eigenvectors.column(k);
            inverse += vector * vector.transpose() / value;
            rank += 1;
        }
    }
    (inverse, rank)
}

/// A number with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its standard error, to first order.
    pub standard_error: f64,
}

/// The normal distribution holds 95 % within this many deviations.
const NORMAL_95: f64 = 1.959_963_984_540_054;
/// The chi-squared distribution with two degrees of freedom holds 95 % below this: -2 ln 0.05.
const CHI_SQUARED_TWO_95: f64 = 5.991_464_547_107_98;

impl Estimate {
    /// Lower and upper end of the 95 % interval.
    #[must_use]
    pub fn interval_95(&self) -> [f64; 2] {
        [self.value - NORMAL_95 * self.standard_error, self.value + NORMAL_95 * self.standard_error]
    }
}

/// A complex number with the covariance of its real and imaginary part.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ComplexEstimate {
    /// The number.
    pub value: Complex<f64>,
    /// Covariance of (real part, imaginary part), to first order.
    pub covariance: Matrix2<f64>,
}

/// An ellipse in the complex plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Ellipse {
    /// The longer half axis.
    pub major: f64,
    /// The shorter half axis: 0 for a real number.
    pub minor: f64,
    /// Angle from the real axis to the longer half axis in rad, in (-pi/2, pi/2].
    pub angle_rad: f64,
}

impl ComplexEstimate {
    /// The standard deviation of the real part.
    #[must_use]
    pub fn real_standard_error(&self) -> f64 {
        self.covariance[(0, 0)].max(0.0).sqrt()
    }

    /// The standard deviation of the imaginary part.
    #[must_use]
    pub fn imaginary_standard_error(&self) -> f64 {
        self.covariance[(1, 1)].max(0.0).sqrt()
    }

    /// The ellipse that holds the number with 95 %.
    #[must_use]
    pub fn ellipse_95(&self) -> Ellipse {
        let (a, b, c) = (self.covariance[(0, 0)], self.covariance[(0, 1)], self.covariance[(1, 1)]);
        let (middle, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        let axis = |variance: f64| (CHI_SQUARED_TWO_95 * variance.max(0.0)).sqrt();
        Ellipse {
            major: axis(middle + half),
            minor: axis(middle - half),
            angle_rad: 0.5 * (2.0 * b).atan2(a - c),
        }
    }

    /// To first order, from the derivatives by all parameters.
    pub(crate) fn from_slopes(
        value: Complex<f64>,
        slopes: &DVector<Complex<f64>>,
        covariance: &DMatrix<f64>,
    ) -> Self {
        let (re, im) = (slopes.map(|slope| slope.re), slopes.map(|slope| slope.im));
        let (cov_re, cov_im) = (covariance * &re, covariance * &im);
        let mixed = re.dot(&cov_im);
        let covariance = Matrix2::new(re.dot(&cov_re), mixed, mixed, im.dot(&cov_im));
        Self { value, covariance }
    }
}

/// A mode with its uncertainty.
///
/// With s = sigma + j omega: natural frequency |s|, damping ratio -sigma/|s|, time constant -1/sigma.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// The mode; its vectors belong to the fitted A.
    pub mode: lti::Mode,
    /// The eigenvalue z of the sampled system.
    pub discrete: ComplexEstimate,
    /// s = log(z)/T in rad/s.
    pub continuous: ComplexEstimate,
    /// |s| in rad/s.
    pub natural_frequency_rad_s: Estimate,
    /// -re(s)/|s|.
    pub damping_ratio: Estimate,
    /// -1/re(s) in s.
    pub time_constant_s: Estimate,
    /// The 95 % interval of the time constant, from that of re(s): `None` where that contains zero, so that the time constant may be
    /// anything beyond two limits of opposite sign.
    pub time_constant_interval_95: Option<[f64; 2]>,
    /// Another eigenvalue from which the records hardly tell this one, and what they tell of the two. The standard errors above are then the farthest that the eigenvalue may be off, over
    /// 1.96, since the slopes that they come from elsewhere mean nothing.
    pub near_double: Option<NearDouble>,
}

/// What a relative model error adds to the uncertainty of modes, which no scatter shows: it is the same at all times.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ModelBias {
    /// The relative model error, eps; 0 for none.
    pub(crate) model_error: f64,
    /// What records can resolve, 2 pi over the length of the longest, in rad/s.
    pub(crate) resolution: f64,
}

impl ModelBias {
    /// The standard deviation of an eigenvalue of this size, in rad/s. A model that is wrong by eps at every frequency has modes that are wrong by a
    /// few eps of their size; among simulated flights of six aircraft, twice eps leaves 84 to 89 % of the modes within two standard errors, the
    /// scatter alone 39 to 83 %.
    pub(crate) fn deviation(self, size: f64) -> f64 {
        const TIMES: f64 = 2.0;
        TIMES * self.model_error * size.max(self.resolution)
    }
}

/// The modes of A with the covariance of A (its entries by columns).
pub(crate) fn modes(
    a: &DMatrix<f64>,
    period: SamplePeriod,
    covariance: &DMatrix<f64>,
    bias: ModelBias,
) -> Result<Vec<Mode>, LtiError> {
    let n = a.nrows();
    let system = StateSpace::<Discrete>::new(
        a.clone(),
        DMatrix::zeros(n, 0),
        DMatrix::zeros(0, n),
        DMatrix::zeros(0, 0),
        period,
    )?;
    let modes = system.modes()?;
    let roots: Vec<Option<Root>> = modes.iter().map(|mode| root(mode, n, period)).collect();
    let doubles = near_doubles(&roots, covariance, bias);
    let all = modes.into_iter().zip(&roots).zip(doubles);
    Ok(all
        .map(|((mode, root), double)| {
            estimate(mode, root.as_ref(), double, period, covariance, bias)
        })
        .collect())
}

/// The eigenvalue s with its derivatives by the entries of A; `None` where it is defective or has no logarithm.
fn root(mode: &lti::Mode, n: usize, period: SamplePeriod) -> Option<Root> {
    let slope = (mode.discrete_eigenvalue? * period.seconds()).inv();
    let (v, w) = (mode.eigenvector.as_ref()?, mode.left_eigenvector.as_ref()?);
    let usable = mode.condition.is_some_and(f64::is_finite);
    // d lambda = w^H dA v with w^H v = 1, and ds = dz / (z T). A defective eigenvalue moves infinitely fast.
    (usable && slope.is_finite() && mode.eigenvalue.is_finite()).then(|| Root {
        value: mode.eigenvalue,
        slopes: DVector::from_fn(n * n, |k, _| w[k % n].conj() * v[k / n] * slope),
    })
}

fn estimate(
    mode: lti::Mode,
    root: Option<&Root>,
    near_double: Option<NearDouble>,
    period: SamplePeriod,
    covariance: &DMatrix<f64>,
    bias: ModelBias,
) -> Mode {
    let z = mode.discrete_eigenvalue.unwrap_or_default();
    let s = mode.eigenvalue;
    let mut discrete = match root {
        Some(root) => {
            // dz = z T ds.
            let slopes = &root.slopes * (z * period.seconds());
            ComplexEstimate::from_slopes(z, &slopes, covariance)
        }
        _ => {
            ComplexEstimate { value: z, covariance: Matrix2::from_diagonal_element(f64::INFINITY) }
        }
    };
    // dz = z T ds.
    let deviation = bias.deviation(s.norm()) * z.norm() * period.seconds();
    discrete.covariance += Matrix2::from_diagonal_element(deviation * deviation);
    // ds = dz / (z T): a rotation and a stretching of the plane.
    let slope = (z * period.seconds()).inv();
    let turn = Matrix2::new(slope.re, -slope.im, slope.im, slope.re);
    let finite = root.is_some();
    let turned = match (&near_double, finite) {
        (Some(double), true) => double.variances(),
        (None, true) => turn * discrete.covariance * turn.transpose(),
        (_, false) => Matrix2::from_diagonal_element(f64::INFINITY),
    };
    if let (Some(_), Some(back)) = (&near_double, turn.try_inverse()) {
        discrete.covariance = back * turned * back.transpose();
    }
    let continuous = ComplexEstimate { value: s, covariance: turned };
    let along = |slope: Vector2<f64>| {
        if finite { slope.dot(&(turned * slope)).max(0.0).sqrt() } else { f64::INFINITY }
    };
    let size = s.norm();
    let (frequency, damping) = if size > 0.0 {
        (
            Vector2::new(s.re / size, s.im / size),
            Vector2::new(-(s.im * s.im), s.re * s.im) / size.powi(3),
        )
    } else {
        (Vector2::new(1.0, 0.0), Vector2::zeros())
    };
    let real = Estimate { value: s.re, standard_error: along(Vector2::new(1.0, 0.0)) };
    let [low, high] = real.interval_95();
    let interval = (finite && low * high > 0.0)
        .then(|| [-1.0 / low, -1.0 / high])
        .map(|[x, y]| [x.min(y), x.max(y)]);
    Mode {
        natural_frequency_rad_s: Estimate {
            value: mode.natural_frequency_rad_s,
            standard_error: along(frequency),
        },
        damping_ratio: Estimate { value: mode.damping_ratio, standard_error: along(damping) },
        time_constant_s: Estimate {
            value: -1.0 / s.re,
            standard_error: real.standard_error / (s.re * s.re),
        },
        time_constant_interval_95: interval,
        near_double,
        discrete,
        continuous,
        mode,
    }
}

/// The relative model error with its standard deviation, where the variances hold one behind those of the sensors.
pub(crate) fn model_error(
    evaluation: &Evaluation,
    variances: &[f64],
    sensors: usize,
) -> Option<Estimate> {
    let &square = variances.get(sensors)?;
    let value = square.sqrt();
    let standard_error = match evaluation.information.clone().try_inverse() {
        Some(covariance) => 0.5 * (2.0 * covariance[(sensors, sensors)].max(0.0)).sqrt() / value,
        None => f64::INFINITY,
    };
    Some(Estimate { value, standard_error })
}

/// Standard deviations in the sensors' units, with their own standard deviations where they were estimated.
pub(crate) fn noise_levels(
    evaluation: &Evaluation,
    variances: &[f64],
    units: &[f64],
    estimated: bool,
) -> Vec<Estimate> {
    let covariance = if estimated { evaluation.information.clone().try_inverse() } else { None };
    variances
        .iter()
        .zip(units)
        .enumerate()
        .map(|(sensor, (&variance, unit))| {
            let value = variance.sqrt() * unit;
            // The information about a variance is half the expected curvature of the objective above.
            let standard_error = match &covariance {
                Some(covariance) => {
                    let spread = (2.0 * covariance[(sensor, sensor)].max(0.0)).sqrt();
                    0.5 * value * spread / variance
                }
                None if estimated => f64::INFINITY,
                None => 0.0,
            };
            Estimate { value, standard_error }
        })
        .collect()
}

#[cfg(test)]
mod tests;
