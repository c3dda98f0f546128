//! What one record sees of the system, prepared for the loop over frequencies: A in Schur form, so that zI - A is triangular.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::record_system::RecordSystem;
use super::spectrum::{Entry, RecordSpectrum};

/// What does not change with frequency: A in Schur form, A = Q T Q^H, and everything in its basis.
pub(crate) struct SchurForm {
    pub(crate) n: usize,
    pub(crate) m: usize,
    pub(crate) factors: usize,
    /// T, row by row, and the size below which z - T_ii is a rounding error.
    pub(crate) t: Vec<Complex<f64>>,
    pub(crate) floor: f64,
    /// Q, row by row.
    pub(crate) q: Vec<Complex<f64>>,
    /// C Q, row by row.
    pub(crate) c: Vec<Complex<f64>>,
    pub(crate) b: Vec<f64>,
    /// Q^H b.
    pub(crate) b_schur: Vec<Complex<f64>>,
    pub(crate) d: Vec<f64>,
    pub(crate) gain: Vec<f64>,
    /// For each factor the part into the state, Q^H tau; `None` where there is none.
    pub(crate) into_state: Vec<Option<Vec<Complex<f64>>>>,
    /// For each factor the part into the sensors.
    pub(crate) into_sensors: Vec<Option<Vec<f64>>>,
    pub(crate) white: Vec<f64>,
    pub(crate) white_at_zero: Vec<f64>,
    /// Whether the noise covariance is diagonal.
    pub(crate) diagonal: bool,
}

impl SchurForm {
    pub(crate) fn new(record: &RecordSpectrum, seen: &RecordSystem) -> Option<Self> {
        const ITERATIONS: usize = 10_000;
        let (n, m) = (seen.b.len(), seen.d.len());
        let complex = |matrix: &DMatrix<f64>| matrix.map(|x| Complex::new(x, 0.0));
        let schur = nalgebra::linalg::Schur::try_new(complex(&seen.a), f64::EPSILON, ITERATIONS)?;
        let (q, t) = schur.unpack();
        let by_rows = |matrix: &DMatrix<Complex<f64>>| matrix.transpose().as_slice().to_vec();
        let in_schur = |vector: &DVector<f64>| {
            (q.adjoint() * vector.map(|x| Complex::new(x, 0.0))).as_slice().to_vec()
        };
        let parts = || seen.coefficients.iter().zip(&record.entries);
        let inverse = |variance: &f64| 1.0 / variance;
        Some(Self {
            n,
            m,
            factors: record.entries.len(),
            t: by_rows(&t),
            floor: f64::EPSILON * seen.a.amax().max(1.0),
            c: by_rows(&(complex(&seen.c) * &q)),
            b: seen.b.as_slice().to_vec(),
            b_schur: in_schur(&seen.b),
            d: seen.d.as_slice().to_vec(),
            gain: seen.gain.as_slice().to_vec(),
            into_state: parts()
                .map(|(tau, entry)| {
                    (*entry != Entry::Sensors)
                        .then(|| in_schur(&DVector::from_column_slice(&tau[..n])))
                })
                .collect(),
            into_sensors: parts()
                .map(|(tau, entry)| (*entry != Entry::State).then(|| tau[n..].to_vec()))
                .collect(),
            white: seen.variances.iter().map(inverse).collect(),
            white_at_zero: seen
                .variances
                .iter()
                .zip(&record.offset_variance)
                .map(|(variance, offset)| 1.0 / (variance + offset))
                .collect(),
            diagonal: record.precision.is_none(),
            q: by_rows(&q),
        })
    }
}
