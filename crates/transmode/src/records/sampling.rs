//! Time stamps -> one sample period, or the row where they stop being even.

use std::ops::RangeInclusive;

/// A step that differs from the usual one by more than this part of it is no jitter but a fault.
///
/// One per cent of a step shifts a sample of a signal at a tenth of the sampling frequency by less than one per cent of its
/// amplitude, which is the noise of a fair sensor; loggers that write time with few decimals stay below it.
const LARGEST_JITTER: f64 = 0.01;

/// The sample periods that are taken for what they say. Below and above, the column is no time in seconds: no sensor is read every
/// picosecond, and no record of one system has samples 30 000 years apart. Within, eigenvalues neither overflow nor vanish.
const PERIODS_S: RangeInclusive<f64> = 1e-12..=1e12;

/// What time stamps say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sampling {
    /// Equal steps of that many seconds.
    Even { period_s: f64 },
    /// The usual step is no sample period.
    OutOfRange { period_s: f64 },
    /// The first step that is at fault ends at sample `index` and is no step forward: negative or zero.
    Backward { index: usize, step_s: f64 },
    /// The first step that is at fault ends at sample `index` and differs from the usual one.
    Uneven { index: usize, step_s: f64, period_s: f64 },
}

/// Judges time stamps in seconds; `None` with fewer than two.
pub(crate) fn sampling(time_s: &[f64]) -> Option<Sampling> {
    let steps: Vec<f64> = time_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (first, last) = (time_s.first()?, time_s.last()?);
    let usual = median(&steps)?;
    if usual > 0.0 && !PERIODS_S.contains(&usual) {
        return Some(Sampling::OutOfRange { period_s: without_rounding(usual) });
    }
    let fault = steps
        .iter()
        .position(|step| !(*step > 0.0 && (step - usual).abs() <= LARGEST_JITTER * usual));
    Some(match fault {
        Some(index) if steps[index] <= 0.0 => {
            Sampling::Backward { index: index + 1, step_s: without_rounding(steps[index]) }
        }
        Some(index) => Sampling::Uneven {
            index: index + 1,
            step_s: without_rounding(steps[index]),
            period_s: without_rounding(usual),
        },
        // The mean step is the better estimate once no step is at fault. It is a decimal number where the stamps are,
        // so that records of different length have the same period.
        #[expect(clippy::cast_precision_loss, reason = "a count of steps is far below 2^53")]
        None => Sampling::Even { period_s: without_rounding((last - first) / steps.len() as f64) },
    })
}

fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}

/// The value with 12 significant digits: what is left of 0.1 after subtracting stamps near 200 s.
fn without_rounding(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests;
