//! The model that all records share, and what differs between them: the direction in which each was excited.

use lti::{Discrete, LtiError, SamplePeriod, StateSpace};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

/// Dynamics common to all records, with the direction in which each record was excited. Discrete time.
///
/// Record j obeys `x(k+1) = A x(k) + b_j u_j(k)`, `y(k) = C x(k) + d_j u_j(k)`, with an excitation `u_j` that nobody measured.
///
/// | part | symbol | shape | unit |
/// |---|---|---|---|
/// | [`a`](Self::a) | A | n x n | the states' |
/// | [`c`](Self::c) | C | m x n | the sensors' over the states' |
/// | [`b`](Self::b) | `b_j` | n, one per record | arbitrary: the excitation's scale is unknown |
/// | [`feedthrough`](Self::feedthrough) | `d_j` | m, one per record | the sensors', on the scale of `b_j` |
///
/// The states are determined up to a change of basis, each pair `(b_j, d_j)` up to a factor; eigenvalues and transmissibilities depend on
/// neither.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedModel {
    /// A, n x n.
    pub a: DMatrix<f64>,
    /// C, m x n.
    pub c: DMatrix<f64>,
    /// `b_j`, one vector of n entries per record.
    pub b: Vec<DVector<f64>>,
    /// `d_j`, one vector of m entries per record; `None` if no sensor reads the excitation directly.
    pub feedthrough: Option<Vec<DVector<f64>>>,
    /// The sample period.
    pub period: SamplePeriod,
}

impl SharedModel {
    /// The number of states, n.
    #[must_use]
    pub fn order(&self) -> usize {
        self.a.nrows()
    }

    /// The eigenvalues of A in the z plane, ordered as [`StateSpace::poles`].
    ///
    /// # Errors
    ///
    /// Those of [`StateSpace::new`] and [`StateSpace::poles`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::SamplePeriod;
    /// use nalgebra::{dmatrix, dvector};
    /// use reconstruct::SharedModel;
    ///
    /// let model = SharedModel {
    ///     a: dmatrix![0.5, 1.0; 0.0, 0.9],
    ///     c: dmatrix![1.0, 0.0; 0.0, 1.0; 1.0, 1.0],
    ///     b: vec![dvector![1.0, 0.0], dvector![0.0, 1.0]],
    ///     feedthrough: None,
    ///     period: SamplePeriod::new(0.1)?,
    /// };
    /// let poles = model.poles()?;
    /// assert_eq!((poles[0].re, poles[1].re), (0.5, 0.9));
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn poles(&self) -> Result<Vec<Complex<f64>>, LtiError> {
        let (n, m) = (self.a.nrows(), self.c.nrows());
        StateSpace::<Discrete>::new(
            self.a.clone(),
            DMatrix::zeros(n, 0),
            self.c.clone(),
            DMatrix::zeros(m, 0),
            self.period,
        )?
        .poles()
    }
}
