//! The system as one record sees it.

use nalgebra::{DMatrix, DVector};

use super::feedback::feedback;
use super::parameters::System;

/// What one record sees of the system: A and C with a feedback (see `feedback.rs`).
#[derive(Debug)]
pub(crate) struct RecordSystem {
    pub(crate) a: DMatrix<f64>,
    pub(crate) c: DMatrix<f64>,
    pub(crate) b: DVector<f64>,
    pub(crate) d: DVector<f64>,
    /// The feedback's gain.
    pub(crate) gain: DVector<f64>,
    /// For each known factor, n + m coefficients: into the state, into the sensors.
    pub(crate) coefficients: Vec<Vec<f64>>,
    /// Noise variances of the sensors; not used where the spectrum has its own covariances.
    pub(crate) variances: Vec<f64>,
}

impl RecordSystem {
    pub(crate) fn new(
        system: &System,
        record: usize,
        coefficients: &[Vec<f64>],
        variances: &[f64],
    ) -> Self {
        let (b, d) = (&system.b[record], &system.d[record]);
        let gain = feedback(&system.a, b);
        Self {
            a: &system.a + b * gain.transpose(),
            c: &system.c + d * gain.transpose(),
            b: b.clone(),
            d: d.clone(),
            gain,
            coefficients: coefficients.to_vec(),
            variances: variances.to_vec(),
        }
    }
}
