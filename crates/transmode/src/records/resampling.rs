//! Uneven samples -> even ones: the band-limited signal that comes closest to them.
//!
//! A signal without content above half the sampling frequency 1 / q is y(t) = sum over k of c_k h(t / q - k),
//! h a windowed sinc. The c_k are found by least squares from the samples where they are, and the sum is
//! then taken at the new times. Least squares is what makes it right for samples at any times; it
//! also keeps content that the new rate cannot carry from folding back, as it is not in the span of
//! the h. Libraries for rate conversion (rubato) take even samples to even samples, and splines
//! fold.
//!
//! Each channel has a q of its own, so that one that is recorded at a lower rate, with empty cells
//! or values held in between, is interpolated from its own samples.

use std::f64::consts::PI;
use std::ops::Range;
use std::path::Path;

use super::clock::Clock;
use super::held;
use super::table::{Places, Table};
use super::timing::Times;
use crate::CommandError;
use crate::error::TimeError;

/// Half the length of h, in its own steps.
const REACH: usize = 12;

/// Shape of its Kaiser window: 90 dB, below the noise of any sensor.
const SHAPE: f64 = 0.1102 * (90.0 - 8.7);

/// Unknowns lie so much further apart than the samples of their channel, so that there are more
/// equations than unknowns also where samples are scarce.
const SPACING: f64 = 1.25;

/// Added to the equations, as a part of their weight: what no sample determines is zero.
const RIDGE: f64 = 1e-6;

/// Where samples are further apart than so many steps q, nothing is interpolated.
const LONGEST_HOLE: f64 = 3.0;

/// Channels at even times.
#[derive(Clone, Debug)]
pub(crate) struct Resampled {
    pub(crate) start_s: f64,
    /// Equally long; NaN in holes.
    pub(crate) values: Vec<Vec<f64>>,
}

/// Interpolates channels that were sampled at `time_s`, ascending, to a period. A NaN is no sample.
///
/// `None` where the channels have less than two periods in common.
pub(crate) fn resample(time_s: &[f64], channels: &[&[f64]], period_s: f64) -> Option<Resampled> {
    let own: Vec<Samples> = channels.iter().map(|values| Samples::of(time_s, values)).collect();
    let ends = own.iter().map(|samples| Some([*samples.time_s.first()?, *samples.time_s.last()?]));
    let ends: Vec<[f64; 2]> = ends.collect::<Option<_>>()?;
    let start_s = ends.iter().map(|[first, _]| *first).fold(f64::NEG_INFINITY, f64::max);
    let end_s = ends.iter().map(|[_, last]| *last).fold(f64::INFINITY, f64::min);
    // A last sample that rounding puts behind the end belongs to it.
    let steps = ((end_s - start_s) / period_s + 1e-6).floor();
    let most = 16.0 * time_s.len() as f64 * channels.len() as f64 + 1e6;
    if !(2.0..=most).contains(&steps) {
        return None;
    }
    let count = crate::numbers::whole(steps)? + 1;
    let grid: Vec<f64> = (0..count).map(|k| start_s + k as f64 * period_s).collect();
    let values = own.iter().map(|samples| samples.at(&grid, period_s)).collect::<Option<_>>()?;
    Some(Resampled { start_s, values })
}

/// The rows of a table at a period.
pub(super) fn of_table(
    file: &Path,
    table: &Table,
    times: &Times,
    rows: Range<usize>,
    period_s: f64,
) -> Result<(Table, Times), CommandError> {
    let time_s: Vec<f64> = rows.clone().map(|row| times.at(row)).collect();
    if let Some(row) = time_s.windows(2).position(|pair| pair[1] < pair[0]) {
        let (place, step_s) =
            (table.places.of(rows.start + row + 1), time_s[row + 1] - time_s[row]);
        let (file, others) = (file.to_owned(), crate::error::Others::default());
        return Err(TimeError::Backward { file, place, step_s, others }.into());
    }
    let channels: Vec<&[f64]> = table.values.iter().map(|values| &values[rows.clone()]).collect();
    let Some(Resampled { start_s, values }) = resample(&time_s, &channels, period_s) else {
        return Err(TimeError::Resampling { file: file.to_owned(), period_s }.into());
    };
    let samples = values.first().map_or(0, Vec::len);
    let times = Times::Even { start_s, period_s, samples, clock: Clock::RESAMPLED };
    let mut even = table.without_values();
    (even.values, even.places) = (values, Places::Samples);
    Ok((even, times))
}

/// The samples that one channel really has.
struct Samples {
    time_s: Vec<f64>,
    values: Vec<f64>,
}

impl Samples {
    fn of(time_s: &[f64], values: &[f64]) -> Self {
        let is_held = held::length(values).is_some();
        let mut own = Self { time_s: Vec::new(), values: Vec::new() };
        let mut before = f64::NAN;
        for (time, value) in time_s.iter().zip(values) {
            let repeats = is_held && value.to_bits() == before.to_bits();
            if !value.is_nan() && !repeats {
                own.time_s.push(*time);
                own.values.push(*value);
                before = *value;
            }
        }
        own
    }

    /// The median step.
    fn usual_step(&self) -> Option<f64> {
        let mut steps: Vec<f64> = self
            .time_s
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .filter(|step| *step > 0.0)
            .collect();
        let middle = steps.len() / 2;
        (!steps.is_empty()).then(|| *steps.select_nth_unstable_by(middle, f64::total_cmp).1)
    }

    /// The signal at ascending times within its own.
    fn at(&self, grid: &[f64], period_s: f64) -> Option<Vec<f64>> {
        let (first_s, last_s) = (*self.time_s.first()?, *self.time_s.last()?);
        let step_s = period_s.max(SPACING * self.usual_step()?);
        // Room for the kernels that reach in from outside.
        let unknowns = crate::numbers::whole(((last_s - first_s) / step_s).ceil())? + 2 * REACH;
        let place = |time: f64| (time - first_s) / step_s + REACH as f64 - 0.5;
        let mean = self.values.iter().sum::<f64>() / self.values.len() as f64;
        let mut equations = Banded::new(unknowns);
        for (time, value) in self.time_s.iter().zip(&self.values) {
            equations.add(&weights(place(*time), unknowns), value - mean);
        }
        let solution = equations.solve(RIDGE * self.values.len() as f64 / unknowns as f64);
        let mut next = 0;
        let value = |time: &f64| {
            while next + 1 < self.time_s.len() && self.time_s[next + 1] < *time {
                next += 1;
            }
            let behind = self.time_s.get(next + 1).copied().unwrap_or(last_s);
            let is_sample =
                (behind - time).abs().min((time - self.time_s[next]).abs()) <= 1e-6 * step_s;
            if behind - self.time_s[next] > LONGEST_HOLE * step_s && !is_sample {
                return f64::NAN;
            }
            let (from, weights) = weights(place(*time), unknowns);
            mean + weights.iter().zip(&solution[from..]).map(|(w, c)| w * c).sum::<f64>()
        };
        Some(grid.iter().map(value).collect())
    }
}

/// The weights of the unknowns around a place, and the first of these.
fn weights(place: f64, unknowns: usize) -> (usize, Vec<f64>) {
    let reach = REACH as f64;
    let from = crate::numbers::whole((place - reach).ceil().max(0.0)).unwrap_or(0);
    let to = crate::numbers::whole((place + reach).floor().max(0.0)).unwrap_or(0) + 1;
    let weights = (from..to.min(unknowns)).map(|k| kernel(place - k as f64)).collect();
    (from, weights)
}

/// A sinc with a Kaiser window.
fn kernel(distance: f64) -> f64 {
    let part = distance / REACH as f64;
    if part.abs() >= 1.0 {
        return 0.0;
    }
    let sinc = if distance.abs() < 1e-9 { 1.0 } else { (PI * distance).sin() / (PI * distance) };
    let window = |shape: f64| super::decimation::bessel_i0(shape);
    sinc * window(SHAPE * (1.0 - part * part).sqrt()) / window(SHAPE)
}

/// Normal equations in which unknowns meet their neighbours only.
struct Banded {
    /// `rows[k][d]` is the entry of k and k + d.
    rows: Vec<[f64; BAND]>,
    right: Vec<f64>,
}

/// An equation has two reaches of unknowns.
const BAND: usize = 2 * REACH + 1;

impl Banded {
    fn new(unknowns: usize) -> Self {
        Self { rows: vec![[0.0; BAND]; unknowns], right: vec![0.0; unknowns] }
    }

    fn add(&mut self, (from, weights): &(usize, Vec<f64>), value: f64) {
        for (index, weight) in weights.iter().enumerate() {
            let row = &mut self.rows[from + index];
            for (entry, other) in row.iter_mut().zip(&weights[index..]) {
                *entry += weight * other;
            }
            self.right[from + index] += weight * value;
        }
    }

    /// By Cholesky's factors within the band.
    fn solve(mut self, ridge: f64) -> Vec<f64> {
        let count = self.rows.len();
        for k in 0..count {
            let pivot = (self.rows[k][0] + ridge).max(f64::MIN_POSITIVE).sqrt();
            self.rows[k][0] = pivot;
            self.rows[k][1..].iter_mut().for_each(|entry| *entry /= pivot);
            self.right[k] /= pivot;
            let row = self.rows[k];
            for (distance, factor) in row.iter().enumerate().skip(1) {
                let Some(below) = self.rows.get_mut(k + distance) else { break };
                for (entry, other) in below.iter_mut().zip(&row[distance..]) {
                    *entry -= factor * other;
                }
                self.right[k + distance] -= factor * self.right[k];
            }
        }
        for k in (0..count).rev() {
            let known: f64 = self.rows[k][1..]
                .iter()
                .zip(&self.right[(k + 1).min(count)..])
                .map(|(a, x)| a * x)
                .sum();
            self.right[k] = (self.right[k] - known) / self.rows[k][0];
        }
        self.right
    }
}

#[cfg(test)]
mod tests;
