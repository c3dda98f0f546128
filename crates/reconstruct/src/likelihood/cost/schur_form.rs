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
    /// The squared relative model error.
    pub(crate) relative: f64,
    pub(crate) has_relative: bool,
    /// Whether the noise covariance is diagonal.
    pub(crate) diagonal: bool,
}

impl SchurForm {
    pub(crate) fn new(record: &RecordSpectrum, system: &RecordSystem) -> Option<Self> {
        const ITERATIONS: usize = 10_000;
        let (n, m) = (system.b.len(), system.d.len());
        let complex = |matrix: &DMatrix<f64>| matrix.map(|x| Complex::new(x, 0.0));
        let schur = nalgebra::linalg::Schur::try_new(complex(&system.a), f64::EPSILON, ITERATIONS)?;
        let (q, t) = schur.unpack();
        let by_rows = |matrix: &DMatrix<Complex<f64>>| matrix.transpose().as_slice().to_vec();
        let in_schur = |vector: &DVector<f64>| {
            (q.adjoint() * vector.map(|x| Complex::new(x, 0.0))).as_slice().to_vec()
        };
        let parts = || system.coefficients.iter().zip(&record.entries);
        let inverse = |variance: &f64| 1.0 / variance;
        Some(Self {
            n,
            m,
            factors: record.entries.len(),
            t: by_rows(&t),
            floor: f64::EPSILON * system.a.amax().max(1.0),
            c: by_rows(&(complex(&system.c) * &q)),
            b: system.b.as_slice().to_vec(),
            b_schur: in_schur(&system.b),
            d: system.d.as_slice().to_vec(),
            gain: system.gain.as_slice().to_vec(),
            into_state: parts()
                .map(|(tau, entry)| {
                    (*entry != Entry::Sensors)
                        .then(|| in_schur(&DVector::from_column_slice(&tau[..n])))
                })
                .collect(),
            into_sensors: parts()
                .map(|(tau, entry)| (*entry != Entry::State).then(|| tau[n..].to_vec()))
                .collect(),
            white: system.variances[..m].iter().map(inverse).collect(),
            white_at_zero: system
                .variances
                .iter()
                .zip(&record.offset_variance)
                .map(|(variance, offset)| 1.0 / (variance + offset))
                .collect(),
            relative: system.variances.get(m).copied().unwrap_or(0.0),
            has_relative: system.variances.len() > m,
            diagonal: record.precision.is_none(),
            q: by_rows(&q),
        })
    }
}
