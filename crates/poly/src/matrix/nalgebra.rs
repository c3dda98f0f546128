//! Conversions between nalgebra's matrices and matrices of constant polynomials.

use super::PolyMatrix;
use crate::{PolyError, Ring};
use nalgebra::{DMatrix, Scalar};

impl<T: Ring + Scalar> PolyMatrix<T> {
    /// The matrix of constants with the entries of `matrix`.
    pub fn from_dmatrix(matrix: &DMatrix<T>) -> Self {
        let entries = row_major(matrix).into_iter().map(crate::Poly::constant).collect();
        Self { rows: matrix.nrows(), columns: matrix.ncols(), entries }
    }

    /// The pencil `p E - A`.
    ///
    /// # Errors
    /// [`PolyError::ShapeMismatch`] if the shapes differ.
    ///
    /// # Example
    /// ```
    /// use nalgebra::DMatrix;
    /// use poly::{Poly, PolyMatrix};
    ///
    /// let a = DMatrix::from_row_slice(2, 2, &[0, 1, -6, 5]);
    /// let pencil = PolyMatrix::pencil(&DMatrix::from_row_slice(2, 2, &[1, 0, 0, 1]), &a)?;
    /// assert_eq!(pencil.coefficient_matrix(0), -a);
    /// assert_eq!(pencil.determinant()?, Poly::from_descending(&[1, -5, 6]));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn pencil(e: &DMatrix<T>, a: &DMatrix<T>) -> Result<Self, PolyError> {
        if e.shape() != a.shape() {
            let (left, right) = (e.shape(), a.shape());
            return Err(PolyError::ShapeMismatch { operation: "difference", left, right });
        }
        Self::linear(e.nrows(), e.ncols(), &row_major(e), &row_major(a))
    }

    /// The coefficients of `x^degree` of all entries; a zero matrix beyond the degree.
    ///
    /// Degree 0 gives back the matrix that [`PolyMatrix::from_dmatrix`] was made from.
    pub fn coefficient_matrix(&self, degree: usize) -> DMatrix<T> {
        DMatrix::from_row_iterator(
            self.rows,
            self.columns,
            self.entries.iter().map(|entry| entry.coefficient(degree)),
        )
    }
}

fn row_major<T: Scalar>(matrix: &DMatrix<T>) -> Vec<T> {
    matrix.transpose().iter().cloned().collect()
}
