//! Determinant, minors and adjugate of a polynomial matrix, without division.
//!
//! Small matrices are expanded along rows, each minor computed once (n 2^n products): every result is a plain
//! sum of products of entries, so floating-point errors stay within rounding of the sum of absolute products.
//! Larger ones go through the Samuelson-Berkowitz algorithm over the ring of polynomials.

use super::PolyMatrix;
use crate::{Poly, PolyError, Ring, characteristic_polynomial};

/// Up to this size minors are expanded: at 8 that is 1024 products, fewer than Berkowitz needs.
const EXPANSION_LIMIT: usize = 8;

impl<T: Ring> PolyMatrix<T> {
    /// The determinant; 1 for the empty matrix.
    ///
    /// Exact over exact rings. Over floating-point numbers a coefficient's error is a small multiple of the
    /// rounding unit times the same coefficient of the sum of absolute products.
    ///
    /// # Errors
    /// [`PolyError::NotSquare`].
    ///
    /// # Example
    /// ```
    /// use num_bigint::BigInt;
    /// use poly::{Poly, PolyMatrix};
    ///
    /// // The matrix of numerators of two transmissibilities; its determinant holds the poles' polynomial
    /// // p^3 - 4p^2 + 6p - 3, times p + 7.
    /// let p = |c: &[i64]| Poly::from_descending(&c.iter().map(|&c| BigInt::from(c)).collect::<Vec<_>>());
    /// let delta = PolyMatrix::new(2, 2, vec![p(&[2, -4, 3]), p(&[3, -6, 6]), p(&[3, -9, 5]), p(&[5, -11, 3])])?;
    /// let determinant = delta.determinant()?;
    /// assert_eq!(determinant, p(&[1, 3, -22, 39, -21]));
    /// assert_eq!(determinant, p(&[1, -4, 6, -3]) * p(&[1, 7]));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn determinant(&self) -> Result<Poly<T>, PolyError> {
        self.check_square()?;
        let n = self.rows;
        if n <= EXPANSION_LIMIT {
            return Ok(self.expand());
        }
        let characteristic = characteristic_polynomial(&self.entries, n)?;
        let constant = characteristic.coefficient(0);
        Ok(if n.is_multiple_of(2) { constant } else { -constant })
    }

    /// Expansion along the rows; `minors[set]` is the minor of the first rows and the columns in `set`.
    fn expand(&self) -> Poly<T> {
        let n = self.rows;
        let mut minors = vec![Poly::zero(); 1 << n];
        minors[0] = Poly::one();
        for set in 1_usize..1 << n {
            let row = set.count_ones() as usize - 1;
            let mut sum = Poly::zero();
            for column in (0..n).filter(|c| set >> c & 1 == 1) {
                let term = &self[(row, column)] * &minors[set & !(1 << column)];
                // Columns of the set to the right of this one give the sign.
                if (set >> (column + 1)).count_ones().is_multiple_of(2) {
                    sum += term;
                } else {
                    sum -= term;
                }
            }
            minors[set] = sum;
        }
        minors.pop().unwrap_or_else(Poly::one)
    }

    /// The matrix without one row and one column.
    ///
    /// # Errors
    /// [`PolyError::IndexOutOfRange`].
    pub fn without(&self, row: usize, column: usize) -> Result<Self, PolyError> {
        for (index, length) in [(row, self.rows), (column, self.columns)] {
            if index >= length {
                return Err(PolyError::IndexOutOfRange { index, length });
            }
        }
        let entries = (0..self.rows)
            .filter(|&i| i != row)
            .flat_map(|i| (0..self.columns).filter(|&j| j != column).map(move |j| (i, j)))
            .map(|index| self[index].clone())
            .collect();
        Ok(Self { rows: self.rows - 1, columns: self.columns - 1, entries })
    }

    /// The minor: the determinant without one row and one column.
    ///
    /// # Errors
    /// [`PolyError::NotSquare`] or [`PolyError::IndexOutOfRange`].
    pub fn minor(&self, row: usize, column: usize) -> Result<Poly<T>, PolyError> {
        self.check_square()?;
        self.without(row, column)?.determinant()
    }

    /// The adjugate: `M adj(M) = adj(M) M = det(M) I`; `[1]` for a 1 x 1 matrix.
    ///
    /// # Errors
    /// [`PolyError::NotSquare`].
    ///
    /// # Example
    /// ```
    /// use poly::PolyMatrix;
    ///
    /// let m = PolyMatrix::linear(3, 3, &[1, 0, 0, 0, 1, 0, 0, 0, 1], &[1, 1, 1, 0, 2, -1, 0, 1, 1])?;
    /// let identity = PolyMatrix::identity(3);
    /// assert_eq!(m.product(&m.adjugate()?)?, identity.scale(&m.determinant()?));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn adjugate(&self) -> Result<Self, PolyError> {
        self.check_square()?;
        let n = self.rows;
        if n <= EXPANSION_LIMIT {
            let mut entries = Vec::with_capacity(n * n);
            for i in 0..n {
                for j in 0..n {
                    let minor = self.minor(j, i)?;
                    entries.push(if (i + j).is_multiple_of(2) { minor } else { -minor });
                }
            }
            return Self::new(n, n, entries);
        }
        // With det(xI - M) = x^n + c_1 x^(n-1) + ...: adj(M) = (-1)^(n-1) (M^(n-1) + c_1 M^(n-2) + ... + c_(n-1) I).
        let characteristic = characteristic_polynomial(&self.entries, n)?;
        let identity = Self::identity(n);
        let mut sum = identity.clone();
        for degree in (1..n).rev() {
            let term = identity.scale(&characteristic.coefficient(degree));
            sum = self.product(&sum)?.sum(&term)?;
        }
        Ok(if n % 2 == 1 { sum } else { sum.map(|entry| -entry) })
    }

    pub(crate) fn check_square(&self) -> Result<(), PolyError> {
        if self.rows == self.columns {
            Ok(())
        } else {
            Err(PolyError::NotSquare { rows: self.rows, columns: self.columns })
        }
    }
}
