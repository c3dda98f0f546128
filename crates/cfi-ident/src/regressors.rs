//! From segments to equations: which sample stands in which column, and whether there are enough.

use hankel::Layout;

use crate::{FitError, Segment, Structure, orders::signed};

/// Whose samples a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Channel {
    Input,
    Output,
}

/// One column of the regressor matrix: `sign * channel(k + lag)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Column {
    pub(crate) channel: Channel,
    pub(crate) lag: isize,
    pub(crate) sign: f64,
}

/// The columns of [Phi' Psi'] in the order of (42): -y_o(k+i), then y_i(k-i) for i = -d .. r, then y_o(k+l).
pub(crate) fn columns(structure: &Structure) -> Vec<Column> {
    let orders = structure.orders;
    let output = |lag: usize, sign| Column { channel: Channel::Output, lag: signed(lag), sign };
    let mut columns: Vec<Column> =
        (structure.lowest_power()..orders.iir()).map(|i| output(i, -1.0)).collect();
    let past = -signed(orders.anticausal())..=signed(orders.causal());
    columns.extend(past.map(|i| Column { channel: Channel::Input, lag: -i, sign: 1.0 }));
    columns.push(output(orders.iir(), 1.0));
    columns
}

/// The same columns for the sums, which know no signs: channel 0 is the pseudo input.
pub(crate) fn layout(structure: &Structure) -> Layout {
    let columns = columns(structure).into_iter().map(|column| {
        let channel = match column.channel {
            Channel::Input => 0,
            Channel::Output => 1,
        };
        hankel::Column::new(channel, column.lag)
    });
    Layout::new(2, columns.collect()).expect("the orders are limited, and no column is named twice")
}

/// The sign that a parameter has on the right-hand side of the model equation.
pub(crate) fn sign(structure: &Structure, parameter: usize) -> f64 {
    if parameter < structure.denominator_count() { -1.0 } else { 1.0 }
}

/// What the segments amount to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Counts {
    /// Equations, that is columns of Phi.
    pub(crate) equations: usize,
    /// Samples of the segments that give equations.
    pub(crate) samples_used: usize,
    /// Samples of all segments.
    pub(crate) samples: usize,
    pub(crate) segments: usize,
    /// Segments too short for an equation.
    pub(crate) segments_without_equation: usize,
}

impl Counts {
    /// One more segment.
    pub(crate) fn add(&mut self, structure: &Structure, samples: usize) {
        let equations = structure.orders.equations(samples);
        self.segments += 1;
        self.samples += samples;
        self.equations += equations;
        if equations > 0 {
            self.samples_used += samples;
        } else {
            self.segments_without_equation += 1;
        }
    }

    /// Those of another accumulator on top.
    pub(crate) fn merge(&mut self, other: &Self) {
        self.equations += other.equations;
        self.samples_used += other.samples_used;
        self.samples += other.samples;
        self.segments += other.segments;
        self.segments_without_equation += other.segments_without_equation;
    }

    /// Checks that there are at least `needed` equations: for plain least squares the number of parameters.
    pub(crate) fn suffice(&self, structure: &Structure, needed: usize) -> Result<(), FitError> {
        let orders = structure.orders;
        if self.segments == 0 {
            return Err(FitError::NoSegment);
        }
        if self.equations < needed {
            return Err(FitError::TooFewSamples {
                samples: self.samples,
                segments: self.segments,
                equations: self.equations,
                parameters: structure.parameter_count(),
                orders,
                needed: orders.samples_needed(needed),
            });
        }
        Ok(())
    }
}

/// Checks that the segments can determine the parameters.
pub(crate) fn check(
    segments: &[Segment<'_>],
    structure: &Structure,
    needed: usize,
) -> Result<Counts, FitError> {
    let mut counts = Counts::default();
    for segment in segments {
        counts.add(structure, segment.samples());
    }
    counts.suffice(structure, needed)?;
    let used = segments.iter().filter(|s| structure.orders.equations(s.samples()) > 0);
    let mut constant = Constancy::default();
    for segment in used {
        constant.add_segment(constant_value(segment.input()), segment.input()[0]);
    }
    constant.check()?;
    Ok(counts)
}

/// The value of a signal that does not vary; `None` for one that does.
pub(crate) fn constant_value(signal: &[f64]) -> Option<f64> {
    let first = *signal.first()?;
    signal.iter().all(|x| equal(*x, first)).then_some(first)
}

/// Zero has two signs, and they are equal.
pub(crate) fn equal(a: f64, b: f64) -> bool {
    a.partial_cmp(&b) == Some(std::cmp::Ordering::Equal)
}

/// Whether the pseudo input varies within any of the segments that give equations.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Constancy {
    /// First value of the first segment.
    first: Option<f64>,
    varies: bool,
}

impl Constancy {
    /// One more segment that gives equations: its value if that is constant, and its first value.
    pub(crate) fn add_segment(&mut self, constant: Option<f64>, first: f64) {
        self.first.get_or_insert(first);
        self.varies |= constant.is_none();
    }

    /// Both together.
    pub(crate) fn merge(&mut self, other: Self) {
        self.first = self.first.or(other.first);
        self.varies |= other.varies;
    }

    /// Refuses a pseudo input that never varies: its shifted copies are all the same.
    pub(crate) fn check(&self) -> Result<(), FitError> {
        match self.first {
            Some(value) if !self.varies => Err(FitError::ConstantInput { value }),
            _ => Ok(()),
        }
    }
}

/// The exponent e with 2^e <= magnitude < 2^(e+1); 0 for 0. Subnormal numbers count as the smallest normal one.
pub(crate) fn exponent(magnitude: f64) -> i32 {
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
