//! The errors of this crate: what was found, and what is needed.

use num_complex::Complex;
use thiserror::Error;

/// Why an operation on a system could not be carried out.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LtiError {
    /// A sample period that isn't a positive finite number.
    #[error("the sample period is {seconds} s; a positive finite number is needed")]
    SamplePeriod {
        /// The rejected period.
        seconds: f64,
    },
    /// A matrix that has to be square isn't.
    #[error("{matrix} is {rows} x {columns}; a square matrix is needed")]
    NotSquare {
        /// Which matrix.
        matrix: &'static str,
        /// Its number of rows.
        rows: usize,
        /// Its number of columns.
        columns: usize,
    },
    /// A matrix doesn't fit the others.
    #[error("{matrix} is {rows} x {columns}; {needed_rows} x {needed_columns} is needed")]
    Shape {
        /// Which matrix.
        matrix: &'static str,
        /// Its number of rows.
        rows: usize,
        /// Its number of columns.
        columns: usize,
        /// The number of rows that fits.
        needed_rows: usize,
        /// The number of columns that fits.
        needed_columns: usize,
    },
    /// An entry that isn't a finite number.
    #[error("{matrix}[{row}, {column}] is {value}; finite entries are needed")]
    NotFinite {
        /// Which matrix.
        matrix: &'static str,
        /// Row, counted from 0.
        row: usize,
        /// Column, counted from 0.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// An argument that has to be a finite number isn't.
    #[error("{quantity} is {value}; a finite number is needed")]
    NotFiniteArgument {
        /// Which argument.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// An input or output that the system doesn't have.
    #[error("{kind} {index} was asked for; the system has {count}, counted from 0")]
    NoSuchChannel {
        /// `"input"` or `"output"`.
        kind: &'static str,
        /// The index asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// Two sampled systems with different periods were connected.
    #[error("the systems are sampled every {left} s and every {right} s; one period is needed")]
    PeriodMismatch {
        /// Period of the first system in seconds.
        left: f64,
        /// Period of the second system in seconds.
        right: f64,
    },
    /// The loop has no solution: `I + D2 D1` is singular.
    #[error("the feedback loop has no unique solution: I + D2 D1 is singular")]
    AlgebraicLoop,
    /// A result is outside the range of floating-point numbers.
    #[error("{operation} leaves the range of floating-point numbers")]
    Overflow {
        /// What was computed.
        operation: &'static str,
    },
    /// No real principal logarithm exists (or none can be told from rounding errors).
    #[error(
        "the state matrix has the eigenvalue {eigenvalue}; a real principal logarithm needs every \
         eigenvalue off the closed negative real axis"
    )]
    NoRealLogarithm {
        /// The eigenvalue that is zero, zero within rounding, or negative.
        eigenvalue: Complex<f64>,
    },
    /// An iteration of the linear algebra did not converge.
    #[error("{operation} did not converge (relative residual {residual:e})")]
    NotConverged {
        /// What was computed.
        operation: &'static str,
        /// The residual reached, relative to the norm of the data.
        residual: f64,
    },
    /// A frequency response was asked for at a pole.
    #[error("the system has a pole at {frequency_rad_s} rad/s; the response there is infinite")]
    PoleAtFrequency {
        /// The frequency.
        frequency_rad_s: f64,
    },
    /// A transfer function was asked for at a pole.
    #[error("the system has a pole at {point}; its transfer function is infinite there")]
    PoleAtPoint {
        /// The point of the s or z plane.
        point: Complex<f64>,
    },
    /// A discrete pole at 0 has no counterpart in continuous time.
    #[error("z = 0 has no logarithm: a deadbeat pole has no counterpart in continuous time")]
    ZeroHasNoLogarithm,
    /// The denominator of a transmissibility vanishes.
    #[error(
        "the input of the transmissibility doesn't respond to the excitation: every coefficient of its \
         numerator is zero (largest {largest:e}, rounding level {rounding_level:e})"
    )]
    ZeroDenominator {
        /// Largest coefficient found (0 over exact rings).
        largest: f64,
        /// The level below which it can't be told from zero (0 over exact rings).
        rounding_level: f64,
    },
    /// A polynomial could not be treated.
    #[error("{operation}: {source}")]
    Polynomial {
        /// What was computed.
        operation: &'static str,
        /// What the polynomial crate found.
        source: poly::PolyError,
    },
}
