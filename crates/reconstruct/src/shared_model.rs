//! What all records have in common, and the direction in which each was excited: the result of both stages, and the start of the second.

use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};

/// Dynamics common to all records, with the direction in which each record was excited. Discrete time.
///
/// Record j obeys x(k+1) = A x(k) + b_j u_j(k), y(k) = C x(k) + d_j u_j(k), with u_j(k) unknown. The basis of the states is free, and so are
/// length and sign of each (b_j, d_j).
///
/// | part | shape | unit |
/// |---|---|---|
/// | `a` | n x n | |
/// | `c` | m x n | the sensors' |
/// | `b` | one per record, n | |
/// | `feedthrough` | one per record, m; `None` where no sensor reads the excitation directly | the sensors' |
#[derive(Clone, Debug, PartialEq)]
pub struct SharedModel {
    /// The state matrix A.
    pub a: DMatrix<f64>,
    /// The output matrix C, one row per sensor.
    pub c: DMatrix<f64>,
    /// The direction b_j in which the excitation of each record enters the state.
    pub b: Vec<DVector<f64>>,
    /// The direction d_j in which it enters the sensors at once (accelerometers).
    pub feedthrough: Option<Vec<DVector<f64>>>,
    /// Time between two samples.
    pub period: SamplePeriod,
}
