//! Time stamps -> one sample period, or the row where they stop being even.

use crate::numbers::{shortest_within, without_rounding};
use std::ops::RangeInclusive;

/// A step that differs from the usual one by more than this part of it is no jitter but a fault.
///
/// One per cent of a step shifts a sample of a signal at a tenth of the sampling frequency by less than one per cent of its
/// amplitude, which is the noise of a fair sensor; loggers that write time with few decimals stay below it.
const LARGEST_JITTER: f64 = 0.01;

/// The sample periods that are taken for what they say. Below and above, the column is no time in seconds: no sensor is read every
/// picosecond, and no record of one system has samples 30 000 years apart. Within, eigenvalues neither overflow nor vanish.
const PERIODS_S: RangeInclusive<f64> = 1e-12..=1e12;

/// A step of more periods than this is no late sample but a gap, if it is close to a whole number of periods.
const SHORTEST_GAP: f64 = 1.5;

/// How far from a whole number of periods a gap may be. A recorder that drops samples keeps its clock.
const LARGEST_OFFSET: f64 = 0.1;

/// A recorder that was started again, or a block that was lost, leaves a gap of any length: so many periods at least, or the samples are uneven.
const SHORTEST_NEW_START: f64 = 10.0;

/// The usual step is the median of at most so many steps, spread over the record.
const MOST_STEPS: usize = 100_000;

/// How many places of a fault are named.
const NAMED: usize = 4;

/// What time stamps say.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Sampling {
    /// Equal steps, but for gaps.
    Even(Even),
    /// The usual step is no sample period.
    OutOfRange { period_s: f64 },
    /// Some steps are no steps forward: negative or zero.
    Backward(Fault),
    /// Some steps differ from the usual one.
    Uneven(Fault),
}

/// Steps that are equal, but for gaps.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Even {
    pub(crate) period_s: f64,
    /// The largest deviation of a step from the period, as a part of it, gaps apart.
    pub(crate) jitter: f64,
    /// Indices of the samples that follow a gap. Ascending.
    pub(crate) after_gaps: Vec<usize>,
}

/// Steps at fault.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    /// The sample that the first of them leads to.
    pub(crate) index: usize,
    pub(crate) step_s: f64,
    /// The usual step.
    pub(crate) period_s: f64,
    /// The samples that the next few lead to.
    pub(crate) others: Vec<usize>,
    /// How many there are behind the first.
    pub(crate) other_count: usize,
}

/// Judges finite time stamps in seconds; `None` with fewer than two.
pub(crate) fn sampling(time_s: &[f64]) -> Option<Sampling> {
    let usual = usual_step(time_s)?;
    if usual > 0.0 && !PERIODS_S.contains(&usual) {
        return Some(Sampling::OutOfRange { period_s: without_rounding(usual) });
    }
    let steps = || time_s.windows(2).map(|pair| pair[1] - pair[0]).enumerate();
    if let Some(fault) = fault(steps(), usual, |step| step.is_nan() || step <= 0.0) {
        return Some(Sampling::Backward(fault));
    }
    if let Some(fault) = fault(steps(), usual, |step| !is_even(step, usual) && !is_gap(step, usual))
    {
        return Some(Sampling::Uneven(fault));
    }
    let (mut jitter, mut inside_s, mut count, mut after_gaps) = (0.0_f64, 0.0, 0_u64, Vec::new());
    for (index, step) in steps() {
        if is_even(step, usual) {
            jitter = jitter.max((step / usual - 1.0).abs());
            inside_s += step;
            count += 1;
        } else {
            after_gaps.push(index + 1);
        }
    }
    // Without gaps the ends alone say it, and no rounding adds up.
    if let (true, [first, .., last]) = (after_gaps.is_empty(), time_s) {
        inside_s = last - first;
    }
    // The mean step is the better estimate once no step is at fault. It is a decimal number where the stamps are,
    // so that records of different length have the same period.
    let (count, last) =
        (count as f64, time_s.iter().fold(0.0_f64, |last, time| last.max(time.abs())));
    // Stamps are as close as numbers of their size can be.
    let rounding = if after_gaps.is_empty() { 2.0 * f64::EPSILON * last / count } else { 0.0 };
    let period_s = shortest_within(without_rounding(inside_s / count), rounding);
    Some(Sampling::Even(Even { period_s, jitter, after_gaps }))
}

/// Whether a number of seconds can be a sample period.
pub(crate) fn is_period(period_s: f64) -> bool {
    PERIODS_S.contains(&period_s)
}

fn is_even(step: f64, usual: f64) -> bool {
    (step - usual).abs() <= LARGEST_JITTER * usual
}

fn is_gap(step: f64, usual: f64) -> bool {
    let periods = step / usual;
    periods > SHORTEST_GAP && (is_whole(periods) || is_new_start(periods))
}

fn is_whole(periods: f64) -> bool {
    (periods - periods.round()).abs() <= LARGEST_OFFSET
}

/// Whether samples behind a gap of so many periods are at other times than those in front of it would have been.
pub(crate) fn is_new_start(periods: f64) -> bool {
    periods >= SHORTEST_NEW_START && !is_whole(periods)
}

fn fault(
    steps: impl Iterator<Item = (usize, f64)>,
    usual: f64,
    is_fault: impl Fn(f64) -> bool,
) -> Option<Fault> {
    let mut faults = steps.filter(|(_, step)| is_fault(*step));
    let (first, step) = faults.next()?;
    let others: Vec<usize> = faults.by_ref().take(NAMED).map(|(index, _)| index + 1).collect();
    let other_count = others.len() + faults.count();
    let (step_s, period_s) = (without_rounding(step), without_rounding(usual));
    Some(Fault { index: first + 1, step_s, period_s, others, other_count })
}

/// The median step; `None` without one.
pub(crate) fn usual_step(time_s: &[f64]) -> Option<f64> {
    let stride = (time_s.len() / MOST_STEPS).max(1);
    let mut steps: Vec<f64> =
        time_s.windows(2).step_by(stride).map(|pair| pair[1] - pair[0]).collect();
    let middle = steps.len() / 2;
    (!steps.is_empty()).then(|| *steps.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Whether two records are sampled alike: within one part in a million, as the methods ask.
pub(crate) fn is_same_period(first_s: f64, second_s: f64) -> bool {
    const TOLERANCE: f64 = 1e-6;
    (first_s - second_s).abs() <= TOLERANCE * second_s
}

/// Whether two periods differ by no more than the clocks of two loggers do.
pub(crate) fn is_near_period(first_s: f64, second_s: f64) -> bool {
    const TOLERANCE: f64 = 1e-3;
    (first_s - second_s).abs() <= TOLERANCE * second_s
}

/// Refuses a sample period that is not that of `what`.
pub(crate) fn check_same_period(found_s: f64, expected_s: f64, what: &str) -> Result<(), String> {
    if is_near_period(found_s, expected_s) {
        Ok(())
    } else {
        Err(format!(
            "it is sampled every {found_s} s, {what} every {expected_s} s; resample one of them with --resample"
        ))
    }
}

#[cfg(test)]
mod tests;
