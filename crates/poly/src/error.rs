//! What can go wrong, with the numbers that explain it.

use num_complex::Complex;

/// An input that has no answer here.
///
/// Numerical doubt is not an error: results carry condition numbers, residuals and a `converged` mark.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolyError {
    /// The zero polynomial has every number as a root.
    #[error("the polynomial is zero, so every number is a root; a nonzero polynomial is needed")]
    ZeroPolynomial,
    /// A coefficient is NaN or infinite.
    #[error("the coefficient of degree {degree} is {value}; finite coefficients are needed")]
    NonFiniteCoefficient {
        /// Its degree.
        degree: usize,
        /// Its value.
        value: Complex<f64>,
    },
    /// A root or a gain is NaN or infinite.
    #[error("the {what} of index {index} is {value}; a finite number is needed")]
    NonFiniteValue {
        /// "root" or "gain".
        what: &'static str,
        /// Its index in its list.
        index: usize,
        /// Its value.
        value: Complex<f64>,
    },
    /// A division by the zero polynomial.
    #[error("division by the zero polynomial")]
    DivisionByZero,
    /// A quotient was promised to be exact and is not.
    #[error("a remainder of degree {degree} is left; an exact division is needed")]
    InexactDivision {
        /// The degree of what is left.
        degree: usize,
    },
    /// A rational function has a zero denominator.
    #[error("the denominator is the zero polynomial; a nonzero denominator is needed")]
    ZeroDenominator,
    /// The number of entries does not fit the shape.
    #[error("{found} entries for a {rows} x {columns} matrix; {} are needed", rows.saturating_mul(*columns))]
    EntryCount {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// Number of entries found.
        found: usize,
    },
    /// A square matrix is needed.
    #[error("the matrix is {rows} x {columns}; a square matrix is needed")]
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// Two shapes do not fit together.
    #[error("shapes {} x {} and {} x {} do not fit for the {operation}", left.0, left.1, right.0, right.1)]
    ShapeMismatch {
        /// "sum", "difference" or "product".
        operation: &'static str,
        /// Rows and columns of the left operand.
        left: (usize, usize),
        /// Rows and columns of the right operand.
        right: (usize, usize),
    },
    /// A row or column index lies outside the matrix.
    #[error("index {index} lies outside 0..{length}")]
    IndexOutOfRange {
        /// The index.
        index: usize,
        /// The number of rows or columns.
        length: usize,
    },
    /// A root is too large or too small for a 64-bit float.
    #[error("a root has modulus 2^{log2_modulus:.0}; 64-bit floats reach from 2^-1022 to 2^1024")]
    RootOutOfRange {
        /// Binary logarithm of the modulus.
        log2_modulus: f64,
    },
    /// Roots of a real polynomial must be real or come in conjugate pairs.
    #[error("{value} has no conjugate partner in the list; a real polynomial needs one")]
    NotConjugateClosed {
        /// The value without a partner.
        value: Complex<f64>,
    },
    /// A tolerance must be finite and not negative.
    #[error("{name} is {value}; a finite number that is not negative is needed")]
    InvalidTolerance {
        /// The option's name.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Coefficients left the range of 64-bit floats.
    #[error("the coefficient of degree {degree} overflows a 64-bit float")]
    Overflow {
        /// Degree of the first coefficient that overflows.
        degree: usize,
    },
}
