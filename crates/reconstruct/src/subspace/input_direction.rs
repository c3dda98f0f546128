//! The direction in which a record was excited.

use nalgebra::{DMatrix, DVector};

use super::dense::{Eigen, eigen_of_square};
use super::limits::DirectPath;
use crate::ReconstructError;

/// How much of the sum of the columns so far goes into the next: a low pass.
///
/// Most excitations have their power at low frequencies, and sensors that integrate see little of the rest, so that the sums of the columns of
/// `T_L(b)` are determined better than their differences. On the paper's aircraft this brings the error of `b_2` from 27 to 17 degrees
/// (white excitation, signal to noise 10) and from 74 to 9 degrees (3-2-1-1 multistep, 100); any leak from 0.8 to 0.97 does.
const LEAK: f64 = 0.9;

/// `b_j` and `d_j`, and how well they are determined.
#[derive(Clone, Debug)]
pub(super) struct InputDirection {
    pub(super) b: DVector<f64>,
    pub(super) d: Option<DVector<f64>>,
    /// How much better this direction fits than the next: 0 for one that is determined exactly, near 1 for one that is arbitrary.
    pub(super) ambiguity: f64,
}

/// Solves `N' T_L(b) = 0` for b, up to its length and sign.
///
/// Column c of `T_L` is the impulse response `C b, C A b, ..` below c + 1 zero blocks, so that it is linear in b: `T_L(b) e_c = S_c b`, with
/// `S_c` the observability matrix moved down. The leaking sums `Y_c = S_c + 0.9 Y_(c-1)` give
///
/// ```text
/// b = argmin sum_c |N' Y_c b|^2 / sum_c |Y_c b|^2,
/// ```
///
/// a singular vector. With a direct path the unknowns are `(d, b)`, and d stands in the block above the response.
pub(super) fn input_direction(
    annihilators: &DMatrix<f64>,
    observability: &DMatrix<f64>,
    sensors: usize,
    path: DirectPath,
) -> Result<InputDirection, ReconstructError> {
    let (rows, order) = observability.shape();
    let (direct, columns) = match path {
        DirectPath::Absent => (0, rows / sensors - 1),
        DirectPath::Present => (sensors, rows / sensors),
    };
    let unknowns = direct + order;
    let noise = annihilators.ncols();
    let transposed = annihilators.transpose();
    let mut sum = DMatrix::zeros(rows, unknowns);
    let mut gram = DMatrix::zeros(unknowns, unknowns);
    let mut stacked = DMatrix::zeros(columns * noise, unknowns);
    for c in 0..columns {
        sum *= LEAK;
        if direct > 0 {
            for i in 0..sensors {
                sum[(c * sensors + i, i)] += 1.0;
            }
        }
        let start = (c + 1) * sensors;
        let mut part = sum.view_mut((start, direct), (rows - start, order));
        part += observability.rows(0, rows - start);
        gram.gemm_tr(1.0, &sum, &sum, 1.0);
        stacked.rows_mut(c * noise, noise).gemm(1.0, &transposed, &sum, 0.0);
    }
    let scale = gram.cholesky().ok_or_else(|| ReconstructError::Step {
        step: "direction of an excitation",
        message: "the observability matrix has dependent columns".to_owned(),
    })?;
    // stacked * R^-1 with R' R = gram.
    let mut scaled = stacked.transpose();
    let solved = scale.l().solve_lower_triangular_mut(&mut scaled);
    debug_assert!(solved, "the diagonal of a Cholesky factor is positive");
    let triangle = scaled.transpose().qr().r();
    let Eigen { values, vectors } = eigen_of_square(&triangle)?;
    let mut unknown = vectors.column(0).into_owned();
    let solved = scale.l().tr_solve_lower_triangular_mut(&mut unknown);
    debug_assert!(solved, "the diagonal of a Cholesky factor is positive");
    // Unit length, largest entry positive.
    let length = unknown.rows(direct, order).norm().max(f64::MIN_POSITIVE);
    let sign = if unknown[unknown.icamax()] < 0.0 { -1.0 } else { 1.0 };
    unknown *= sign / length;
    let d = (direct > 0).then(|| unknown.rows(0, direct).into_owned());
    // Of a single unknown there is no next.
    let next = values.get(1).copied().unwrap_or(f64::INFINITY).max(f64::MIN_POSITIVE);
    let ambiguity = (values[0] / next).sqrt();
    Ok(InputDirection { b: unknown.rows(direct, order).into_owned(), d, ambiguity })
}

#[cfg(test)]
mod tests;
