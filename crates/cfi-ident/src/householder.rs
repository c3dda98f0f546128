//! The engine that folds rows by Householder reflections: slower, and independent of the other one.

use nalgebra::{DMatrix, DVector};

use crate::{
    FitError, FitOptions, Refinement, Segment, Structure,
    factor::Factor,
    regressors::{Channel, Column, columns, exponent, scale},
    solution::Solution,
    triangle::Triangle,
};

/// Rows folded into the triangle at a time: a block of 128 rows and 55 columns stays in the L2 cache.
const BLOCK_ROWS: usize = 128;

/// Folds all equations, and solves by the singular values of the triangle, as accurate as doubles alone allow.
pub(crate) fn solve(
    segments: &[Segment<'_>],
    structure: &Structure,
    options: &FitOptions,
) -> Result<Solution, FitError> {
    let rows = Rows::new(segments, structure);
    let triangle = rows.triangle();
    let parameters = triangle.columns();
    let rounding = f64::EPSILON * triangle.rows().max(parameters) as f64;
    let factor = Factor::new(&triangle, options.rank_tolerance.unwrap_or(rounding))?;
    let scaled = factor.solve(&triangle.right_hand_side());
    let theta: Vec<f64> = scaled
        .iter()
        .zip(&rows.columns)
        .map(|(x, c)| scale(*x, rows.parameter_exponent(*c)))
        .collect();
    if theta.iter().any(|x| !x.is_finite()) {
        return Err(FitError::Overflow { what: "a parameter" });
    }
    let target = triangle.target_norm();
    let explained = triangle.regressors() * &scaled;
    let missed = (triangle.right_hand_side() - explained).norm();
    let residual = missed.hypot(triangle.residual_norm());
    Ok(Solution {
        theta,
        residual_norm: scale(residual, rows.output_exponent),
        relative_residual: if target > 0.0 { residual / target } else { 0.0 },
        rank: factor.rank,
        condition: factor.condition(),
        singular_values: factor.singular_values.clone(),
        inverse: factor.inverse(),
        norms: rows
            .columns
            .iter()
            .zip(&factor.norms)
            .map(|(column, norm)| (*norm, rows.exponent_of(*column)))
            .collect(),
        null_directions: factor.null_directions(),
        expected_error: f64::EPSILON * factor.condition(),
        refinement: Refinement { steps: 0, last_correction: 0.0, converged: false },
    })
}

/// Segments whose channels are scaled by powers of two to a largest magnitude in [1, 2). The scaling is exact.
struct Rows {
    structure: Structure,
    columns: Vec<Column>,
    /// Input and output of each segment.
    segments: Vec<[Vec<f64>; 2]>,
    input_exponent: i32,
    output_exponent: i32,
}

impl Rows {
    fn new(segments: &[Segment<'_>], structure: &Structure) -> Self {
        let largest = |largest: f64, x: &f64| x.abs().max(largest);
        let input_exponent = exponent(segments.iter().flat_map(Segment::input).fold(0.0, largest));
        let output_exponent =
            exponent(segments.iter().flat_map(Segment::output).fold(0.0, largest));
        let scaled = |values: &[f64], exponent: i32| -> Vec<f64> {
            values.iter().map(|x| scale(*x, -exponent)).collect()
        };
        Self {
            structure: *structure,
            columns: columns(structure),
            segments: segments
                .iter()
                .map(|s| [scaled(s.input(), input_exponent), scaled(s.output(), output_exponent)])
                .collect(),
            input_exponent,
            output_exponent,
        }
    }

    fn exponent_of(&self, column: Column) -> i32 {
        match column.channel {
            Channel::Input => self.input_exponent,
            Channel::Output => self.output_exponent,
        }
    }

    /// The power of two that turns a parameter of the scaled problem into one of the given signals.
    fn parameter_exponent(&self, column: Column) -> i32 {
        self.output_exponent - self.exponent_of(column)
    }

    fn triangle(&self) -> Triangle {
        let mut triangle = Triangle::new(self.columns.len() - 1);
        let orders = self.structure.orders;
        for segment in &self.segments {
            let equations = orders.equations(segment[0].len());
            for first in (0..equations).step_by(BLOCK_ROWS) {
                let count = BLOCK_ROWS.min(equations - first);
                triangle.absorb(&mut self.block(segment, orders.causal() + first, count));
            }
        }
        triangle
    }

    /// The equations at `count` steps from `step` on.
    fn block(&self, segment: &[Vec<f64>; 2], step: usize, count: usize) -> DMatrix<f64> {
        let columns = self.columns.iter().map(|column| {
            let from = step
                .checked_add_signed(column.lag)
                .expect("an equation's samples lie in the segment");
            let channel = match column.channel {
                Channel::Input => &segment[0],
                Channel::Output => &segment[1],
            };
            DVector::from_iterator(
                count,
                channel[from..from + count].iter().map(|x| column.sign * x),
            )
        });
        DMatrix::from_columns(&columns.collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests;
