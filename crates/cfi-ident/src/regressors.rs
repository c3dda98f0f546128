//! From segments to equations: which sample stands in which column, and the scaling of the two channels.

use nalgebra::DMatrix;

use crate::{FitError, Segment, Structure, orders::signed, triangle::Triangle};

/// Rows folded into the triangle at a time: a block of 128 rows and 55 columns stays in the L2 cache.
const BLOCK_ROWS: usize = 128;

/// Whose samples a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Channel {
    Input,
    Output,
}

/// One column of the regressor matrix: `sign * channel(k + shift)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Column {
    pub(crate) channel: Channel,
    pub(crate) shift: isize,
    pub(crate) sign: f64,
}

/// The columns of [Phi' Psi'] in the order of (42): -y_o(k+i), then y_i(k-i) for i = -d .. r, then y_o(k+l).
pub(crate) fn columns(structure: &Structure) -> Vec<Column> {
    let orders = structure.orders;
    let output =
        |shift: usize, sign| Column { channel: Channel::Output, shift: signed(shift), sign };
    let mut columns: Vec<Column> =
        (structure.lowest_power()..orders.iir()).map(|i| output(i, -1.0)).collect();
    let past = -signed(orders.anticausal())..=signed(orders.causal());
    columns.extend(past.map(|i| Column { channel: Channel::Input, shift: -i, sign: 1.0 }));
    columns.push(output(orders.iir(), 1.0));
    columns
}

/// A segment whose channels are scaled by powers of two to a largest magnitude in [1, 2). The scaling is exact.
#[derive(Debug, Clone)]
pub(crate) struct ScaledSegment {
    input: Vec<f64>,
    output: Vec<f64>,
}

impl ScaledSegment {
    pub(crate) fn input(&self) -> &[f64] {
        &self.input
    }

    pub(crate) fn output(&self) -> &[f64] {
        &self.output
    }

    /// Index of the sample that a column holds in the equation at `step`.
    pub(crate) fn start(&self, column: Column, step: usize) -> usize {
        step.checked_add_signed(column.shift).expect("an equation's samples lie in the segment")
    }

    /// The samples of a column in `count` equations from `step` on.
    pub(crate) fn slice(&self, column: Column, step: usize, count: usize) -> &[f64] {
        let from = self.start(column, step);
        match column.channel {
            Channel::Input => &self.input[from..from + count],
            Channel::Output => &self.output[from..from + count],
        }
    }
}

/// Checked and scaled equations, ready to be folded into a triangle or walked through again.
#[derive(Debug, Clone)]
pub(crate) struct Equations {
    pub(crate) structure: Structure,
    pub(crate) columns: Vec<Column>,
    pub(crate) segments: Vec<ScaledSegment>,
    /// The channels were multiplied by 2^-exponent.
    pub(crate) input_exponent: i32,
    pub(crate) output_exponent: i32,
    pub(crate) rows: usize,
    pub(crate) samples_used: usize,
    pub(crate) segments_without_equation: usize,
}

impl Equations {
    /// Checks that the segments can determine the parameters, and scales them.
    ///
    /// `needed` is the smallest number of equations: for plain least squares the number of parameters.
    pub(crate) fn new(
        segments: &[Segment<'_>],
        structure: &Structure,
        needed: usize,
    ) -> Result<Self, FitError> {
        let orders = structure.orders;
        if segments.is_empty() {
            return Err(FitError::NoSegment);
        }
        let used: Vec<&Segment<'_>> =
            segments.iter().filter(|s| orders.equations(s.samples()) > 0).collect();
        let rows = used.iter().map(|s| orders.equations(s.samples())).sum();
        let parameters = structure.parameter_count();
        if rows < needed {
            return Err(FitError::TooFewSamples {
                samples: segments.iter().map(Segment::samples).sum(),
                segments: segments.len(),
                equations: rows,
                parameters,
                orders,
                needed: needed + orders.causal() + orders.reach(),
            });
        }
        if used.iter().all(|s| s.input().iter().all(|x| x.total_cmp(&s.input()[0]).is_eq())) {
            return Err(FitError::ConstantInput { value: used[0].input()[0] });
        }
        let largest =
            |pick: fn(&Segment<'_>) -> f64| used.iter().map(|s| pick(s)).fold(0.0, f64::max);
        let input_exponent = exponent(largest(|s| amax(s.input())));
        let output_exponent = exponent(largest(|s| amax(s.output())));
        let scaled = used.iter().map(|s| ScaledSegment {
            input: s.input().iter().map(|x| scale(*x, -input_exponent)).collect(),
            output: s.output().iter().map(|x| scale(*x, -output_exponent)).collect(),
        });
        Ok(Self {
            structure: *structure,
            columns: columns(structure),
            segments: scaled.collect(),
            input_exponent,
            output_exponent,
            rows,
            samples_used: used.iter().map(|s| s.samples()).sum(),
            segments_without_equation: segments.len() - used.len(),
        })
    }

    /// Runs through all equations in blocks: `visit(index of the segment, step of the block's first equation, equations in the block)`.
    pub(crate) fn for_each_block(&self, rows: usize, mut visit: impl FnMut(usize, usize, usize)) {
        let orders = self.structure.orders;
        for (index, segment) in self.segments.iter().enumerate() {
            let equations = orders.equations(segment.input.len());
            let mut done = 0;
            while done < equations {
                let count = rows.min(equations - done);
                visit(index, orders.causal() + done, count);
                done += count;
            }
        }
    }

    /// Folds all equations into one triangle.
    pub(crate) fn triangle(&self) -> Triangle {
        let mut triangle = Triangle::new(self.columns.len() - 1);
        let mut block = DMatrix::zeros(0, self.columns.len());
        self.for_each_block(BLOCK_ROWS, |index, step, count| {
            let segment = &self.segments[index];
            if block.nrows() != count {
                block = DMatrix::zeros(count, self.columns.len());
            }
            for (target, column) in block.as_mut_slice().chunks_exact_mut(count).zip(&self.columns)
            {
                let source = segment.slice(*column, step, count);
                target.iter_mut().zip(source).for_each(|(x, y)| *x = column.sign * y);
            }
            triangle.absorb(&mut block);
        });
        triangle
    }

    /// The power of two that turns a parameter of the scaled problem into one of the given signals.
    pub(crate) fn parameter_exponent(&self, column: Column) -> i32 {
        match column.channel {
            Channel::Output => 0,
            Channel::Input => self.output_exponent - self.input_exponent,
        }
    }
}

/// Largest magnitude, 0 if there is none.
fn amax(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

/// The exponent e with 2^e <= magnitude < 2^(e+1); 0 for 0. Subnormal numbers count as the smallest normal one.
fn exponent(magnitude: f64) -> i32 {
    if magnitude == 0.0 {
        return 0;
    }
    let biased = (magnitude.to_bits() >> 52) & 0x7ff;
    i32::try_from(biased).expect("eleven bits").max(1) - 1023
}

/// `value * 2^exponent` without intermediate overflow.
pub(crate) fn scale(value: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    value * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

#[cfg(test)]
mod tests;
