//! A matrix of polynomials.

mod determinant;
#[cfg(feature = "faer")]
pub(crate) mod finite_zeros;
pub(crate) mod floating;
#[cfg(feature = "nalgebra")]
mod nalgebra;
#[cfg(test)]
mod tests;

use crate::{Poly, PolyError, Ring};
use std::ops::Index;

/// A rows x columns matrix of polynomials, stored row by row.
///
/// # Example
/// ```
/// use poly::{Poly, PolyMatrix};
///
/// // pI - A with A = [0 1; -6 5]
/// let m = PolyMatrix::linear(2, 2, &[1, 0, 0, 1], &[0, 1, -6, 5])?;
/// assert_eq!(m[(1, 1)].display("p").to_string(), "p - 5");
/// assert_eq!(m.determinant()?, Poly::from_descending(&[1, -5, 6]));
/// # Ok::<(), poly::PolyError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct PolyMatrix<T> {
    rows: usize,
    columns: usize,
    entries: Vec<Poly<T>>,
}

impl<T: Ring> PolyMatrix<T> {
    /// The matrix with the given entries, row by row.
    ///
    /// # Errors
    /// [`PolyError::EntryCount`] unless there are `rows * columns` entries.
    pub fn new(rows: usize, columns: usize, entries: Vec<Poly<T>>) -> Result<Self, PolyError> {
        check_count(rows, columns, entries.len())?;
        Ok(Self { rows, columns, entries })
    }

    /// The matrix of constants with the given entries, row by row.
    ///
    /// # Errors
    /// [`PolyError::EntryCount`] unless there are `rows * columns` entries.
    pub fn from_constant(rows: usize, columns: usize, entries: &[T]) -> Result<Self, PolyError> {
        check_count(rows, columns, entries.len())?;
        let entries = entries.iter().map(|c| Poly::constant(c.clone())).collect();
        Ok(Self { rows, columns, entries })
    }

    /// The pencil `p E - A`, both given row by row.
    ///
    /// # Errors
    /// [`PolyError::EntryCount`] unless both have `rows * columns` entries.
    pub fn linear(rows: usize, columns: usize, e: &[T], a: &[T]) -> Result<Self, PolyError> {
        check_count(rows, columns, e.len())?;
        check_count(rows, columns, a.len())?;
        let entries =
            e.iter().zip(a).map(|(e, a)| Poly::new(vec![-a.clone(), e.clone()])).collect();
        Ok(Self { rows, columns, entries })
    }

    /// The n x n identity.
    pub fn identity(n: usize) -> Self {
        let entries =
            (0..n * n).map(|k| if k / n == k % n { Poly::one() } else { Poly::zero() }).collect();
        Self { rows: n, columns: n, entries }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The entries, row by row.
    pub fn entries(&self) -> &[Poly<T>] {
        &self.entries
    }

    /// The entry in the given row and column, counted from zero; `None` outside the matrix.
    pub fn get(&self, row: usize, column: usize) -> Option<&Poly<T>> {
        if row < self.rows && column < self.columns {
            self.entries.get(row * self.columns + column)
        } else {
            None
        }
    }

    /// The largest degree of an entry; `None` for a zero or empty matrix.
    pub fn degree(&self) -> Option<usize> {
        self.entries.iter().filter_map(Poly::degree).max()
    }

    /// The matrix with `f` applied to each entry.
    pub fn map<U: Ring>(&self, f: impl FnMut(&Poly<T>) -> Poly<U>) -> PolyMatrix<U> {
        let entries = self.entries.iter().map(f).collect();
        PolyMatrix { rows: self.rows, columns: self.columns, entries }
    }

    /// The transposed matrix.
    pub fn transpose(&self) -> Self {
        let entries = (0..self.columns)
            .flat_map(|j| (0..self.rows).map(move |i| self[(i, j)].clone()))
            .collect();
        Self { rows: self.columns, columns: self.rows, entries }
    }

    /// The matrix times a polynomial.
    pub fn scale(&self, factor: &Poly<T>) -> Self {
        self.map(|entry| factor * entry)
    }

    /// The value at `x`, row by row.
    pub fn eval(&self, x: &T) -> Vec<T> {
        self.entries.iter().map(|entry| entry.eval(x)).collect()
    }

    /// The sum of two matrices of the same shape.
    ///
    /// # Errors
    /// [`PolyError::ShapeMismatch`] if the shapes differ.
    pub fn sum(&self, other: &Self) -> Result<Self, PolyError> {
        self.entrywise(other, "sum", |a, b| a + b)
    }

    /// The difference of two matrices of the same shape.
    ///
    /// # Errors
    /// [`PolyError::ShapeMismatch`] if the shapes differ.
    pub fn difference(&self, other: &Self) -> Result<Self, PolyError> {
        self.entrywise(other, "difference", |a, b| a - b)
    }

    fn entrywise(
        &self,
        other: &Self,
        operation: &'static str,
        f: impl Fn(&Poly<T>, &Poly<T>) -> Poly<T>,
    ) -> Result<Self, PolyError> {
        if (self.rows, self.columns) != (other.rows, other.columns) {
            return Err(self.mismatch(other, operation));
        }
        let entries = self.entries.iter().zip(&other.entries).map(|(a, b)| f(a, b)).collect();
        Ok(Self { rows: self.rows, columns: self.columns, entries })
    }

    /// The matrix product.
    ///
    /// # Errors
    /// [`PolyError::ShapeMismatch`] unless the columns of the left are as many as the rows of the right.
    pub fn product(&self, other: &Self) -> Result<Self, PolyError> {
        if self.columns != other.rows {
            return Err(self.mismatch(other, "product"));
        }
        let entry = |i: usize, j: usize| -> Poly<T> {
            (0..self.columns).map(|k| &self[(i, k)] * &other[(k, j)]).sum()
        };
        let entries = (0..self.rows)
            .flat_map(|i| (0..other.columns).map(move |j| (i, j)))
            .map(|(i, j)| entry(i, j))
            .collect();
        Ok(Self { rows: self.rows, columns: other.columns, entries })
    }

    fn mismatch(&self, other: &Self, operation: &'static str) -> PolyError {
        PolyError::ShapeMismatch {
            operation,
            left: (self.rows, self.columns),
            right: (other.rows, other.columns),
        }
    }
}

fn check_count(rows: usize, columns: usize, found: usize) -> Result<(), PolyError> {
    if rows.checked_mul(columns) == Some(found) {
        Ok(())
    } else {
        Err(PolyError::EntryCount { rows, columns, found })
    }
}

impl<T> Index<(usize, usize)> for PolyMatrix<T> {
    type Output = Poly<T>;

    /// The entry in the given row and column, counted from zero.
    ///
    /// # Panics
    /// If the row or column lies outside the matrix; [`PolyMatrix::get`] does not panic.
    fn index(&self, (row, column): (usize, usize)) -> &Poly<T> {
        assert!(
            row < self.rows && column < self.columns,
            "entry ({row}, {column}) of a {} x {} matrix",
            self.rows,
            self.columns
        );
        &self.entries[row * self.columns + column]
    }
}
