//! State-space models, checked once when they are built.

use nalgebra::DMatrix;

use crate::{Continuous, Discrete, LtiError, SamplePeriod, TimeDomain};

/// A linear time-invariant system with real matrices.
///
/// Continuous time: `dx/dt = A x + B u`, `y = C x + D u`.
/// Discrete time: `x(k+1) = A x(k) + B u(k)`, `y(k) = C x(k) + D u(k)`.
///
/// | symbol | shape | |
/// |---|---|---|
/// | A | n x n | state matrix |
/// | B | n x m | input matrix |
/// | C | p x n | output matrix |
/// | D | p x m | feedthrough |
///
/// Shapes fit and every entry is finite, always. n = 0 (a constant gain), m = 0 and p = 0 are allowed.
///
/// # Example
///
/// ```
/// use lti::{Continuous, StateSpace};
/// use nalgebra::dmatrix;
/// let integrator =
///     StateSpace::<Continuous>::new(dmatrix![0.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])?;
/// assert_eq!((integrator.order(), integrator.inputs(), integrator.outputs()), (1, 1, 1));
/// # Ok::<(), lti::LtiError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct StateSpace<T: TimeDomain> {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    d: DMatrix<f64>,
    time: T,
}

impl StateSpace<Continuous> {
    /// A continuous-time system; see the shapes above. The paper's model with one input and the two outputs
    /// y_i and y_o is this one with m = 1 and p = 2.
    ///
    /// Source: paper eq. (1) (state), and the scalar outputs there are rows of C and D.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotSquare`], [`LtiError::Shape`] or [`LtiError::NotFinite`].
    pub fn new(
        a: DMatrix<f64>,
        b: DMatrix<f64>,
        c: DMatrix<f64>,
        d: DMatrix<f64>,
    ) -> Result<Self, LtiError> {
        Self::checked(a, b, c, d, Continuous)
    }
}

impl StateSpace<Discrete> {
    /// A discrete-time system sampled with `period`.
    ///
    /// # Errors
    ///
    /// [`LtiError::NotSquare`], [`LtiError::Shape`] or [`LtiError::NotFinite`].
    pub fn new(
        a: DMatrix<f64>,
        b: DMatrix<f64>,
        c: DMatrix<f64>,
        d: DMatrix<f64>,
        period: SamplePeriod,
    ) -> Result<Self, LtiError> {
        Self::checked(a, b, c, d, Discrete { period })
    }

    /// The sample period.
    #[must_use]
    pub fn period(&self) -> SamplePeriod {
        self.time.period
    }
}

impl<T: TimeDomain> StateSpace<T> {
    pub(crate) fn checked(
        a: DMatrix<f64>,
        b: DMatrix<f64>,
        c: DMatrix<f64>,
        d: DMatrix<f64>,
        time: T,
    ) -> Result<Self, LtiError> {
        check_square("A", &a)?;
        let (n, m, p) = (a.nrows(), b.ncols(), c.nrows());
        check_shape("B", &b, n, m)?;
        check_shape("C", &c, p, n)?;
        check_shape("D", &d, p, m)?;
        for (name, matrix) in [("A", &a), ("B", &b), ("C", &c), ("D", &d)] {
            check_finite(name, matrix)?;
        }
        Ok(Self { a, b, c, d, time })
    }

    /// The state matrix A, n x n.
    #[must_use]
    pub fn a(&self) -> &DMatrix<f64> {
        &self.a
    }

    /// The input matrix B, n x m.
    #[must_use]
    pub fn b(&self) -> &DMatrix<f64> {
        &self.b
    }

    /// The output matrix C, p x n.
    #[must_use]
    pub fn c(&self) -> &DMatrix<f64> {
        &self.c
    }

    /// The feedthrough D, p x m.
    #[must_use]
    pub fn d(&self) -> &DMatrix<f64> {
        &self.d
    }

    /// The number of states n.
    #[must_use]
    pub fn order(&self) -> usize {
        self.a.nrows()
    }

    /// The number of inputs m.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.b.ncols()
    }

    /// The number of outputs p.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.c.nrows()
    }

    /// The time domain: [`Continuous`], or [`Discrete`] with its period.
    #[must_use]
    pub fn time(&self) -> &T {
        &self.time
    }

    /// The system from some of the inputs to some of the outputs, in the order given. The states stay.
    ///
    /// Indices count from 0 and may repeat.
    ///
    /// # Errors
    ///
    /// [`LtiError::NoSuchChannel`] for an index out of range.
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::dmatrix;
    /// let system = StateSpace::<Continuous>::new(
    ///     dmatrix![-1.0], dmatrix![1.0, 2.0], dmatrix![3.0; 4.0], dmatrix![5.0, 6.0; 7.0, 8.0])?;
    /// let part = system.subsystem(&[1], &[0])?;
    /// assert_eq!((part.c()[0], part.b()[0], part.d()[0]), (4.0, 1.0, 7.0));
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn subsystem(&self, outputs: &[usize], inputs: &[usize]) -> Result<Self, LtiError> {
        for &index in outputs {
            self.check_output(index)?;
        }
        for &index in inputs {
            self.check_input(index)?;
        }
        Ok(Self {
            a: self.a.clone(),
            b: self.b.select_columns(inputs),
            c: self.c.select_rows(outputs),
            d: self.d.select_rows(outputs).select_columns(inputs),
            time: self.time.clone(),
        })
    }

    pub(crate) fn check_output(&self, index: usize) -> Result<(), LtiError> {
        check_channel("output", index, self.outputs())
    }

    pub(crate) fn check_input(&self, index: usize) -> Result<(), LtiError> {
        check_channel("input", index, self.inputs())
    }
}

fn check_channel(kind: &'static str, index: usize, count: usize) -> Result<(), LtiError> {
    if index < count { Ok(()) } else { Err(LtiError::NoSuchChannel { kind, index, count }) }
}

pub(crate) fn check_square<S>(name: &'static str, matrix: &DMatrix<S>) -> Result<(), LtiError> {
    let (rows, columns) = matrix.shape();
    if rows == columns { Ok(()) } else { Err(LtiError::NotSquare { matrix: name, rows, columns }) }
}

pub(crate) fn check_shape<S>(
    name: &'static str,
    matrix: &DMatrix<S>,
    needed_rows: usize,
    needed_columns: usize,
) -> Result<(), LtiError> {
    let (rows, columns) = matrix.shape();
    if (rows, columns) == (needed_rows, needed_columns) {
        Ok(())
    } else {
        Err(LtiError::Shape { matrix: name, rows, columns, needed_rows, needed_columns })
    }
}

pub(crate) fn check_finite(name: &'static str, matrix: &DMatrix<f64>) -> Result<(), LtiError> {
    for column in 0..matrix.ncols() {
        for row in 0..matrix.nrows() {
            let value = matrix[(row, column)];
            if !value.is_finite() {
                return Err(LtiError::NotFinite { matrix: name, row, column, value });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
