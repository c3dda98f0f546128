//! A record as text that identify reads.

use std::io::Write;

use nalgebra::DMatrix;

use super::flights::Simulator;
use crate::numbers::{rounded, without_rounding};

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
        let _ = write!(text, "\n{}", without_rounding(k as f64 * simulator.period.seconds()));
        for value in column.iter() {
            let value = if noisy { rounded(*value, DIGITS_WITH_NOISE) } else { *value };
            let _ = write!(text, ",{value}");
        }
    }
    text.push(b'\n');
    text
}
