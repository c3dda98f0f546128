//! A row of a real matrix times a complex vector in doubled precision: what the residuals of this crate are made of.

use doubled::DoubleDoubleComplex;
use nalgebra::DMatrix;
use num_complex::Complex;

/// sum over j of `matrix[(i, j)] vector[j]`; each product is exact, and the sum is not rounded to doubles.
pub(crate) fn row_product<'a>(
    matrix: &DMatrix<f64>,
    i: usize,
    vector: impl IntoIterator<Item = &'a Complex<f64>>,
) -> DoubleDoubleComplex {
    let terms = matrix.row(i).into_iter().zip(vector);
    terms.map(|(&entry, &x)| DoubleDoubleComplex::real_product(entry, x)).sum()
}

#[cfg(test)]
mod tests;
