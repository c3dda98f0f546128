//! What each column is, in a few words.

use std::fmt;

use super::file::Channel;
use crate::numbers::rounded;
use crate::records::copies::copies;
use crate::records::held;
use crate::records::wrap;

/// A counter goes up by one step this often, resets apart.
const COUNTS: f64 = 0.98;

/// The largest distance between a derivative and the differences of its integral, as a part of what varies of it.
const DERIVATIVE: f64 = 0.05;

/// Samples that a derivative is looked for in: two sensors of one motion agree as well over any of them.
const LOOKED_AT: usize = 20_000;

/// What a column is, beyond a signal.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// The column of time.
    Time,
    /// One value throughout.
    Constant,
    /// It holds words, or whatever else keeps it from being read.
    NotRead { why: String },
    /// It goes up by the same step from row to row.
    Counter,
    /// Each value is held for so many rows: it is sampled at a lower rate.
    Held { rows: usize },
    /// It jumps by a turn of so much.
    Wraps { turn: f64 },
    /// A multiple of another column.
    Copy { of: String, factor: f64 },
    /// The rate of change of another column, times a factor.
    Derivative { of: String, factor: f64 },
}

impl Verdict {
    /// A word for other programs.
    pub(super) fn word(&self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Constant => "constant",
            Self::NotRead { .. } => "not-read",
            Self::Counter => "counter",
            Self::Held { .. } => "held",
            Self::Wraps { .. } => "wraps",
            Self::Copy { .. } => "copy",
            Self::Derivative { .. } => "derivative",
        }
    }

    /// The column that it is said in terms of.
    pub(super) fn other(&self) -> Option<&str> {
        match self {
            Self::Copy { of, .. } | Self::Derivative { of, .. } => Some(of),
            _ => None,
        }
    }

    /// The number that belongs to it.
    pub(super) fn number(&self) -> Option<f64> {
        match self {
            Self::Held { rows } => Some(*rows as f64),
            Self::Wraps { turn } => Some(*turn),
            Self::Copy { factor, .. } | Self::Derivative { factor, .. } => Some(*factor),
            _ => None,
        }
    }
}

impl fmt::Display for Verdict {
    /// In a cell of a table.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let times = |factor: f64| {
            if (factor - 1.0).abs() < 0.05 {
                String::new()
            } else {
                format!("{} x ", rounded(factor, 4))
            }
        };
        match self {
            Self::Time => f.write_str("time"),
            Self::Constant => f.write_str("constant"),
            Self::NotRead { .. } => f.write_str("not read"),
            Self::Counter => f.write_str("counter"),
            Self::Held { rows } => write!(f, "held for {rows} rows"),
            Self::Wraps { turn } => write!(f, "wraps at {}", rounded(*turn, 4)),
            Self::Copy { of, factor } => write!(f, "{} x {of}", rounded(*factor, 4)),
            Self::Derivative { of, factor } => write!(f, "{}rate of {of}", times(*factor)),
        }
    }
}

/// Fills in what each of the channels is, whose samples are `values`, evenly spaced where there is a period.
pub(super) fn judge(channels: &mut [Channel], values: &[&[f64]], period_s: Option<f64>) {
    let names: Vec<String> = channels.iter().map(|channel| channel.name.clone()).collect();
    for (channel, values) in channels.iter_mut().zip(values) {
        channel.verdict = alone(channel, values);
    }
    for found in copies(&[values.to_vec()]) {
        let of = names[found.original].clone();
        channels[found.copy].verdict = Some(Verdict::Copy { of, factor: found.factor });
    }
    let Some(period_s) = period_s else { return };
    for index in 0..values.len() {
        if channels[index].verdict.is_some() {
            continue;
        }
        let integrals = (0..values.len()).filter(|other| *other != index);
        let of = |other: usize| {
            let is_signal = channels[other].verdict.is_none();
            let factor =
                is_signal.then(|| derivative(values[other], values[index], period_s))??;
            Some(Verdict::Derivative { of: names[other].clone(), factor })
        };
        channels[index].verdict = integrals.into_iter().find_map(of);
    }
}

/// What its own samples say of a channel.
fn alone(channel: &Channel, values: &[f64]) -> Option<Verdict> {
    if channel.signal.is_constant() {
        return Some(Verdict::Constant);
    }
    if let Some(turn) = wrap::turn(values, channel.si) {
        return Some(Verdict::Wraps { turn });
    }
    if is_counter(values) {
        return Some(Verdict::Counter);
    }
    held::length(values).map(|rows| Verdict::Held { rows })
}

/// Whether it goes up by the same step from row to row, as a time or a number of rows does.
fn is_counter(values: &[f64]) -> bool {
    let mut steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.retain(|step| !step.is_nan());
    if steps.len() < 10 {
        return false;
    }
    let middle = steps.len() / 2;
    let usual = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let close = (1e-3 * usual.abs()).max(4.0 * f64::EPSILON * largest);
    let regular = steps.iter().filter(|step| (*step - usual).abs() <= close).count();
    usual > 0.0 && regular as f64 >= COUNTS * steps.len() as f64
}

/// The factor from the rate of change of `integral` to `rate`, if the one explains the other.
///
/// Differences over two steps are compared with the mean of the rate over them (Simpson's rule), so that noise hardly counts.
fn derivative(integral: &[f64], rate: &[f64], period_s: f64) -> Option<f64> {
    let length = integral.len().min(rate.len()).min(LOOKED_AT);
    let pairs: Vec<[f64; 2]> = integral[..length]
        .windows(3)
        .zip(rate[..length].windows(3))
        .map(|(x, y)| [(x[2] - x[0]) / (2.0 * period_s), (y[0] + 4.0 * y[1] + y[2]) / 6.0])
        .filter(|pair| !pair[0].is_nan() && !pair[1].is_nan())
        .collect();
    if pairs.len() < 50 {
        return None;
    }
    let mean = |side: usize| pairs.iter().map(|pair| pair[side]).sum::<f64>() / pairs.len() as f64;
    let [mean_x, mean_y] = [mean(0), mean(1)];
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for [x, y] in &pairs {
        let (x, y) = (x - mean_x, y - mean_y);
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
    }
    let factor = xy / xx;
    let left = yy - factor * xy;
    // In an oscillation each rate is a rate of change of the other; the negative one is its echo.
    (factor.is_finite() && factor > 0.0 && left <= DERIVATIVE * DERIVATIVE * yy).then_some(factor)
}

#[cfg(test)]
mod tests;
