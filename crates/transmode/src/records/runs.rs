//! Stretches of two signals without gaps. A NaN marks a gap.

use std::ops::Range;

/// An infinite sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Infinite {
    pub(crate) index: usize,
    pub(crate) side: Side,
    pub(crate) value: f64,
}

/// Which of two signals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Input,
    Output,
}

/// The stretches in which both signals, equally long, are finite, in their order; none is empty.
pub(crate) fn runs(input: &[f64], output: &[f64]) -> Result<Vec<Range<usize>>, Infinite> {
    let finite = |values: &[f64]| values.iter().fold(true, |all, x| all & x.is_finite());
    if !input.is_empty() && finite(input) && finite(output) {
        return Ok(std::iter::once(0..input.len()).collect());
    }
    let mut found = Vec::new();
    let mut start = 0;
    for (index, (&x, &y)) in input.iter().zip(output).enumerate() {
        for (value, side) in [(x, Side::Input), (y, Side::Output)] {
            if value.is_infinite() {
                return Err(Infinite { index, side, value });
            }
        }
        if x.is_nan() || y.is_nan() {
            found.push(start..index);
            start = index + 1;
        }
    }
    found.push(start..input.len().min(output.len()));
    found.retain(|run| !run.is_empty());
    Ok(found)
}

#[cfg(test)]
mod tests;
