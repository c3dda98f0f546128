//! The algorithm itself: Hankel matrix, singular values, balanced matrices.

use faer::MatRef;
use nalgebra::DMatrix;

use crate::hankel::{Blocks, block_hankel};
use crate::order::{Floor, OrderReason};
use crate::{EraError, EraOptions};

/// Matrices of `H_k = C A^(k-1) B` and what is known about them.
#[derive(Debug, Clone)]
pub(crate) struct Balanced {
    pub(crate) a: DMatrix<f64>,
    pub(crate) b: DMatrix<f64>,
    pub(crate) c: DMatrix<f64>,
    pub(crate) singular_values: Vec<f64>,
    pub(crate) floor: Floor,
    pub(crate) order: usize,
    pub(crate) reason: OrderReason,
    pub(crate) condition: f64,
    pub(crate) residual: f64,
    pub(crate) parameter_floor: f64,
}

/// A power of two near the square root of a magnitude: dividing by it twice brings numbers near 1 without rounding.
#[derive(Debug, Clone, Copy)]
struct HalfScale(f64);

impl HalfScale {
    fn of(magnitude: f64) -> Self {
        if magnitude > 0.0 { Self(magnitude.sqrt().log2().round().exp2()) } else { Self(1.0) }
    }

    fn down(self, value: f64) -> f64 {
        value / self.0 / self.0
    }

    fn up(self, value: f64) -> f64 {
        value * self.0 * self.0
    }
}

/// The largest absolute entry of a sequence.
pub(crate) fn magnitude(sequence: &[DMatrix<f64>]) -> f64 {
    sequence
        .iter()
        .flat_map(DMatrix::iter)
        .fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// Realizes `sequence[k - 1] = H_k`, `k = 1, 2, ..`.
///
/// All blocks have the shape `(outputs, inputs)` and are finite. `shared_magnitude` is the largest number that they were
/// found together with; rounding errors are relative to it.
pub(crate) fn balance(
    sequence: &[DMatrix<f64>],
    (outputs, inputs): (usize, usize),
    shared_magnitude: f64,
    options: &EraOptions,
) -> Result<Balanced, EraError> {
    let blocks =
        Blocks::choose(options.block_rows, options.block_columns, sequence.len(), outputs, inputs)?;
    let scale = HalfScale::of(magnitude(sequence));
    let scaled: Vec<DMatrix<f64>> =
        sequence.iter().map(|block| block.map(|value| scale.down(value))).collect();

    let hankel = block_hankel(&scaled, blocks, 0);
    let shifted = block_hankel(&scaled, blocks, 1);
    let ThinSvd { left, values, right } = ThinSvd::of(&hankel)?;

    let (rows, columns) = hankel.shape();
    let largest = values.first().copied().unwrap_or(0.0);
    let noise = options.noise_floor.map(|level| scale.down(level));
    let floor = Floor::new(rows, columns, largest, scale.down(shared_magnitude), noise);
    let (order, reason) = options.order.select(&values, floor);

    // H = U S V', A = S^-1/2 U' H_shifted V S^-1/2, B = first block column of S^1/2 V', C = first block row of U S^1/2.
    let roots: Vec<f64> = values[..order].iter().map(|value| value.sqrt()).collect();
    let left = left.columns(0, order);
    let right = right.columns(0, order);
    let middle = left.transpose() * shifted * right;
    let a = DMatrix::from_fn(order, order, |i, j| middle[(i, j)] / roots[i] / roots[j]);
    let b = DMatrix::from_fn(order, inputs, |i, j| roots[i] * right[(j, i)]);
    let c = DMatrix::from_fn(outputs, order, |i, j| left[(i, j)] * roots[j]);

    let residual = relative_residual(&scaled, &a, &b, &c);
    let condition = if order == 0 { 1.0 } else { values[0] / values[order - 1] };
    Ok(Balanced {
        a,
        b: b * scale.0,
        c: c * scale.0,
        singular_values: values.iter().map(|&value| scale.up(value)).collect(),
        floor: Floor { value: scale.up(floor.value), ..floor },
        order,
        reason: reason.map_floor(|value| scale.up(value)),
        condition,
        residual,
        parameter_floor: scale.up(floor.of_one_entry(rows, columns)),
    })
}

/// `matrix = left diag(values) right'`, values in descending order.
struct ThinSvd {
    left: DMatrix<f64>,
    values: Vec<f64>,
    right: DMatrix<f64>,
}

impl ThinSvd {
    /// The sign of a pair of vectors is free; it is chosen so that the largest entry of the left vector is positive.
    fn of(matrix: &DMatrix<f64>) -> Result<Self, EraError> {
        let (rows, columns) = matrix.shape();
        let view = MatRef::from_column_major_slice(matrix.as_slice(), rows, columns);
        let svd = view.thin_svd().map_err(|_| EraError::NoConvergence { rows, columns })?;
        let count = rows.min(columns);
        let larger = |kept: f64, &value: &f64| if value.abs() > kept.abs() { value } else { kept };
        let signs: Vec<f64> = (0..count)
            .map(|j| svd.U().col(j).iter().fold(0.0, larger))
            .map(|peak| 1.0_f64.copysign(peak))
            .collect();
        Ok(Self {
            left: DMatrix::from_fn(rows, count, |i, j| svd.U()[(i, j)] * signs[j]),
            values: svd.S().column_vector().iter().copied().collect(),
            right: DMatrix::from_fn(columns, count, |i, j| svd.V()[(i, j)] * signs[j]),
        })
    }
}

/// The relative difference between `C A^(k-1) B` and the given parameters; infinite where the model overflows.
fn relative_residual(
    sequence: &[DMatrix<f64>],
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    c: &DMatrix<f64>,
) -> f64 {
    let mut state = b.clone();
    let (mut error, mut total) = (0.0, 0.0);
    for block in sequence {
        error += (c * &state - block).norm_squared();
        total += block.norm_squared();
        state = a * state;
    }
    let relative = if total > 0.0 { (error / total).sqrt() } else { 0.0 };
    if relative.is_finite() { relative } else { f64::INFINITY }
}
