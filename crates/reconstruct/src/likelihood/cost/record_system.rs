//! The system as one record sees it.

use nalgebra::{DMatrix, DVector};

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
