//! A record as text that identify reads.

use std::io::Write;

use nalgebra::DMatrix;

use super::flights::{Simulator, number};

/// Significant digits of readings with noise: it hides the others.
const DIGITS_WITH_NOISE: usize = 9;

/// A header with units, then one row for each sample. Without noise the numbers are written in full.
pub(super) fn render(simulator: &Simulator<'_>, readings: &DMatrix<f64>) -> Vec<u8> {
    let mut text = b"time [s]".to_vec();
    for sensor in &simulator.args.outputs {
        // Writing to memory does not fail.
        let _ = write!(text, ",{} [{}]", sensor.name(), sensor.state().unit());
    }
    let noisy = simulator.args.noise != super::Noise::Absent;
    for (k, column) in readings.column_iter().enumerate() {
        // Twelve digits, so that 3 periods of 0.1 s are 0.3 s.
        let _ = write!(text, "\n{}", rounded(number(k) * simulator.period.seconds(), 12));
        for value in column.iter() {
            let value = if noisy { rounded(*value, DIGITS_WITH_NOISE) } else { *value };
            let _ = write!(text, ",{value}");
        }
    }
    text.push(b'\n');
    text
}

/// To so many significant digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
