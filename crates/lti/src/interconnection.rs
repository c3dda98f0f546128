//! Systems in series, in parallel, as a difference, and in a feedback loop.

use nalgebra::DMatrix;

use crate::state_space::check_shape;
use crate::{LtiError, StateSpace, TimeDomain};

impl<T: TimeDomain> StateSpace<T> {
    /// This system followed by `next`: G = G_next G_this. The states are stacked, this system's first.
    ///
    /// # Errors
    ///
    /// [`LtiError::Shape`] if `next` doesn't take as many inputs as this system has outputs,
    /// [`LtiError::PeriodMismatch`], [`LtiError::Overflow`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::{DMatrix, dmatrix};
    /// let gain = |k: f64| StateSpace::<Continuous>::new(
    ///     DMatrix::zeros(0, 0), DMatrix::zeros(0, 1), DMatrix::zeros(1, 0), dmatrix![k]);
    /// assert_eq!(gain(2.0)?.series(&gain(3.0)?)?.d()[0], 6.0);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn series(&self, next: &Self) -> Result<Self, LtiError> {
        self.time().check_same(next.time())?;
        check_shape("the input matrix of the next system", next.b(), next.order(), self.outputs())?;
        let a = blocks(
            self.a(),
            &DMatrix::zeros(self.order(), next.order()),
            &(next.b() * self.c()),
            next.a(),
        );
        let b = stack_rows(self.b(), &(next.b() * self.d()));
        let c = stack_columns(&(next.d() * self.c()), next.c());
        self.connected(a, b, c, next.d() * self.d())
    }

    /// The sum of both responses: G = G_this + G_other.
    ///
    /// # Errors
    ///
    /// [`LtiError::Shape`] if inputs or outputs differ in number, [`LtiError::PeriodMismatch`],
    /// [`LtiError::Overflow`].
    pub fn parallel(&self, other: &Self) -> Result<Self, LtiError> {
        self.side_by_side(other, 1.0)
    }

    /// The difference of both responses: G = G_this - G_other.
    ///
    /// # Errors
    ///
    /// As [`parallel`](Self::parallel).
    pub fn difference(&self, other: &Self) -> Result<Self, LtiError> {
        self.side_by_side(other, -1.0)
    }

    /// This system with `other` in a negative feedback loop: u = r - G_other y, so
    /// G = (I + G_this G_other)^-1 G_this.
    ///
    /// # Errors
    ///
    /// [`LtiError::AlgebraicLoop`] if I + D_other D_this is singular; [`LtiError::Shape`],
    /// [`LtiError::PeriodMismatch`], [`LtiError::Overflow`].
    ///
    /// # Example
    ///
    /// ```
    /// use lti::{Continuous, StateSpace};
    /// use nalgebra::{DMatrix, dmatrix};
    /// // An integrator with unit feedback is 1/(s + 1).
    /// let integrator =
    ///     StateSpace::<Continuous>::new(dmatrix![0.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])?;
    /// let one = StateSpace::<Continuous>::new(
    ///     DMatrix::zeros(0, 0), DMatrix::zeros(0, 1), DMatrix::zeros(1, 0), dmatrix![1.0])?;
    /// assert_eq!(integrator.feedback(&one)?.a()[0], -1.0);
    /// # Ok::<(), lti::LtiError>(())
    /// ```
    pub fn feedback(&self, other: &Self) -> Result<Self, LtiError> {
        self.time().check_same(other.time())?;
        check_shape("the feedthrough of the feedback", other.d(), self.inputs(), self.outputs())?;
        // u = M (r - C2 x2 - D2 C1 x1) with M = (I + D2 D1)^-1.
        let loop_matrix = DMatrix::identity(self.inputs(), self.inputs()) + other.d() * self.d();
        let inverse = loop_matrix.try_inverse().ok_or(LtiError::AlgebraicLoop)?;
        if inverse.iter().any(|x| !x.is_finite()) {
            return Err(LtiError::AlgebraicLoop);
        }
        let u_from_x1 = -(&inverse * other.d() * self.c());
        let u_from_x2 = -(&inverse * other.c());
        let y_from_x1 = self.c() + self.d() * &u_from_x1;
        let y_from_x2 = self.d() * &u_from_x2;
        let y_from_r = self.d() * &inverse;
        let a = blocks(
            &(self.a() + self.b() * &u_from_x1),
            &(self.b() * &u_from_x2),
            &(other.b() * &y_from_x1),
            &(other.a() + other.b() * &y_from_x2),
        );
        let b = stack_rows(&(self.b() * &inverse), &(other.b() * &y_from_r));
        self.connected(a, b, stack_columns(&y_from_x1, &y_from_x2), y_from_r)
    }

    fn side_by_side(&self, other: &Self, sign: f64) -> Result<Self, LtiError> {
        self.time().check_same(other.time())?;
        check_shape(
            "the feedthrough of the other system",
            other.d(),
            self.outputs(),
            self.inputs(),
        )?;
        let (n1, n2) = (self.order(), other.order());
        let a = blocks(self.a(), &DMatrix::zeros(n1, n2), &DMatrix::zeros(n2, n1), other.a());
        let b = stack_rows(self.b(), other.b());
        let c = stack_columns(self.c(), &(other.c() * sign));
        self.connected(a, b, c, self.d() + other.d() * sign)
    }

    fn connected(
        &self,
        a: DMatrix<f64>,
        b: DMatrix<f64>,
        c: DMatrix<f64>,
        d: DMatrix<f64>,
    ) -> Result<Self, LtiError> {
        Self::checked(a, b, c, d, self.time().clone()).map_err(|error| match error {
            LtiError::NotFinite { .. } => {
                LtiError::Overflow { operation: "the connection of two systems" }
            }
            other => other,
        })
    }
}

fn stack_rows(top: &DMatrix<f64>, bottom: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, columns) = top.shape();
    let mut stacked = DMatrix::zeros(rows + bottom.nrows(), columns);
    stacked.view_mut((0, 0), (rows, columns)).copy_from(top);
    stacked.view_mut((rows, 0), bottom.shape()).copy_from(bottom);
    stacked
}

fn stack_columns(left: &DMatrix<f64>, right: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, columns) = left.shape();
    let mut stacked = DMatrix::zeros(rows, columns + right.ncols());
    stacked.view_mut((0, 0), (rows, columns)).copy_from(left);
    stacked.view_mut((0, columns), right.shape()).copy_from(right);
    stacked
}

fn blocks(
    top_left: &DMatrix<f64>,
    top_right: &DMatrix<f64>,
    bottom_left: &DMatrix<f64>,
    bottom_right: &DMatrix<f64>,
) -> DMatrix<f64> {
    stack_rows(&stack_columns(top_left, top_right), &stack_columns(bottom_left, bottom_right))
}

#[cfg(test)]
mod tests;
