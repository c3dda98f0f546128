//! The spectrum of a disturbance at the frequencies of a record's discrete Fourier transform.

use nalgebra::DMatrix;
use num_complex::Complex;

use crate::ReconstructError;

/// One Hermitian, positive definite covariance for each frequency 2 pi k / N, k = 0 ..= N/2.
///
/// Entry k is the covariance of V_k = N^(-1/2) sum_i v(i) exp(-2 pi j k i / N): for white noise of standard deviation s it is s^2 at all
/// frequencies. Its unit is the product of the sensors' units.
///
/// # Example
///
/// ```
/// use nalgebra::DMatrix;
/// use num_complex::Complex;
/// use reconstruct::likelihood::NoiseSpectrum;
///
/// let white = vec![DMatrix::from_diagonal_element(2, 2, Complex::new(0.04, 0.0)); 3];
/// let spectrum = NoiseSpectrum::new(4, white)?; // N = 4 has the frequencies 0, 1 and 2
/// assert_eq!((spectrum.samples(), spectrum.sensors()), (4, 2));
/// # Ok::<(), reconstruct::ReconstructError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseSpectrum {
    samples: usize,
    covariances: Vec<DMatrix<Complex<f64>>>,
}

impl NoiseSpectrum {
    /// Checks the covariances of a record with so many samples.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::Noise`] unless there is one square, finite, Hermitian and positive definite matrix for each of the N/2 + 1
    /// frequencies, all of one size.
    pub fn new(
        samples: usize,
        covariances: Vec<DMatrix<Complex<f64>>>,
    ) -> Result<Self, ReconstructError> {
        let needed = samples / 2 + 1;
        if samples == 0 || covariances.len() != needed {
            return Err(noise(format!(
                "{} covariances for the {needed} frequencies of {samples} samples",
                covariances.len()
            )));
        }
        let sensors = covariances[0].nrows();
        for (frequency, covariance) in covariances.iter().enumerate() {
            if sensors == 0 || covariance.shape() != (sensors, sensors) {
                let (rows, columns) = covariance.shape();
                return Err(noise(format!(
                    "covariance {frequency} is {rows} x {columns}, the first is {sensors} x {sensors}"
                )));
            }
            if inverse_of_hermitian(covariance).is_none() {
                return Err(noise(format!(
                    "covariance {frequency} is not Hermitian and positive definite"
                )));
            }
        }
        Ok(Self { samples, covariances })
    }

    /// The number of samples N of the record it belongs to.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// The number of sensors m.
    #[must_use]
    pub fn sensors(&self) -> usize {
        self.covariances.first().map_or(0, DMatrix::nrows)
    }

    /// The covariances, by frequency.
    #[must_use]
    pub fn covariances(&self) -> &[DMatrix<Complex<f64>>] {
        &self.covariances
    }
}

/// The inverse of a Hermitian, positive definite matrix; `None` where it is not one up to rounding.
pub(crate) fn inverse_of_hermitian(
    matrix: &DMatrix<Complex<f64>>,
) -> Option<DMatrix<Complex<f64>>> {
    const ASYMMETRY: f64 = 1e-9;
    let finite = matrix.iter().all(|entry| entry.is_finite());
    if !finite || (matrix - matrix.adjoint()).norm() > ASYMMETRY * matrix.norm() {
        return None;
    }
    // Sensors of different units: with a unit diagonal the test for definiteness does not depend on them.
    let scale = matrix.diagonal().map(|entry| 1.0 / entry.re.sqrt());
    if !scale.iter().all(|entry| entry.is_finite() && *entry > 0.0) {
        return None;
    }
    let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| {
        0.5 * (matrix[(i, k)] + matrix[(k, i)].conj()) * (scale[i] * scale[k])
    });
    let factor = scaled.cholesky()?;
    // The square root of a negative pivot is imaginary, which is no error over complex numbers.
    let definite =
        factor.l_dirty().diagonal().iter().all(|x| x.re > x.im.abs() && x.re.is_finite());
    if !definite {
        return None;
    }
    let inverse = factor.inverse();
    let result = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| {
        inverse[(i, k)] * (scale[i] * scale[k])
    });
    result.iter().all(|entry| entry.is_finite()).then_some(result)
}

fn noise(message: String) -> ReconstructError {
    ReconstructError::Noise { message }
}

#[cfg(test)]
mod tests;
