//! Intervals of real modes from the likelihood itself.
//!
//! A standard error describes the optimum of the likelihood by a parabola. Where a mode is slow beside the record, or the noise is large, the likelihood falls off
//! faster to one side than to the other. So the mode is held in one place after another while everything else follows, and the interval ends where
//! the likelihood has fallen by what a parabola would have lost at its 95 % ends (profile likelihood; Venzon & Moolgavkar 1988).
//!
//! The excitation is one unknown per frequency, and what the likelihood loses is not exactly chi-squared. Its scale is set where it must agree with the
//! standard error: close to the optimum.

use hankel::in_order;
use nalgebra::DMatrix;
use num_complex::Complex;

use super::fit::Fit;
use super::refit::{Refit, refit};
use super::uncertainty::Mode;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::search::eigenvalue_penalty::EigenvaluePenalty;
use crate::likelihood::search::levenberg_marquardt::{Limits, minimise};
use crate::{ReconstructError, Record};

/// The normal distribution holds 95 % within this many deviations.
const NORMAL_95: f64 = 1.959_963_984_540_054;
/// Where the likelihood must agree with the deviation, in deviations to either side.
const CLOSE: f64 = 0.5;
/// An end is found where the likelihood has fallen by as much as at so many deviations more or less.
const CLOSE_ENOUGH: f64 = 0.02;
/// The next trial lies at most so many times farther out.
const FARTHEST: f64 = 2.0;
/// Trials of an end.
const TRIALS: usize = 25;
/// A mode has reached its place within so many widths of it; the likelihood pulls it off by a small part of one.
const NEAR_ENOUGH: f64 = 20.0;
/// Beyond so many deviations there is no end.
const ENDLESS: f64 = 50.0;
/// A mode is pinned within its standard error over this.
const PIN: f64 = 100.0;

/// The 95 % interval of each real mode's eigenvalue s in rad/s, in the order of [`Fit::modes`], from the likelihood; `None` for complex
/// pairs, for modes without a finite deviation, and for z below zero.
///
/// The interval agrees with [`ComplexEstimate`](super::uncertainty::ComplexEstimate)'s deviation where that is small, and need not be symmetric where it is not. An end is
/// infinite where the likelihood does not fall far enough. Noise levels stay as they were fitted.
///
/// `fit` is the result of [`identify`](crate::likelihood::identify) for the same records and options. Each takes about 20 evaluations of the likelihood, as many as a fit.
///
/// Source: Venzon & Moolgavkar, A Method for Computing Profile-Likelihood-Based Confidence Intervals, Applied Statistics 37 (1988).
///
/// # Errors
///
/// Those of [`identify`](crate::likelihood::identify) for records and options.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.99 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.1. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("../../doctest/two_decays.md")]
/// use reconstruct::likelihood::{Options, identify, profile_intervals};
/// use reconstruct::{Offsets, subspace};
///
/// // The first mode is slow beside 60 samples.
/// let records = two_decays(0.99, 60, 0.1)?;
/// let mut first = subspace::Options::default();
/// first.order = subspace::OrderChoice::Fixed(2);
/// first.measurement.offsets = Offsets::Zero;
/// let start = subspace::identify(&records, &first)?.model;
/// let fit = identify(&records, &[start], &Options::default())?;
/// let [low, high] = profile_intervals(&records, &fit)?[1].ok_or("no interval")?;
/// let s = 0.99_f64.ln();
/// assert!(low < s && s < high);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn profile_intervals(
    records: &[Record],
    fit: &Fit,
) -> Result<Vec<Option<[f64; 2]>>, ReconstructError> {
    let Refit { problem, evaluation, variances, units: _ } = refit(records, fit)?;
    let profile = Profile {
        problem: &problem,
        optimum: evaluation,
        variances,
        degrees_of_freedom: fit.chi_squared.degrees_of_freedom,
        period: fit.model.period.seconds(),
    };
    let mut intervals = Vec::with_capacity(fit.modes.len());
    in_order(
        &fit.modes,
        problem.sharing(),
        |modes| modes.iter().map(|mode| profile.interval(mode)).collect(),
        |interval| intervals.push(interval),
    );
    Ok(intervals)
}

struct Profile<'a> {
    problem: &'a Problem,
    optimum: Evaluation,
    variances: Vec<f64>,
    degrees_of_freedom: f64,
    period: f64,
}

/// A fit around a mode that is held.
struct PinnedMode {
    /// Where it is.
    z: f64,
    /// What minus twice the logarithm of the likelihood lies above the optimum's.
    fall: f64,
    evaluation: Evaluation,
}

impl Profile<'_> {
    fn interval(&self, mode: &Mode) -> Option<[f64; 2]> {
        let (s, deviation) = (mode.continuous.value, mode.continuous.real_standard_error());
        let real = mode.discrete.value.im == 0.0 && mode.discrete.value.re > 0.0;
        if !(real && deviation > 0.0 && deviation.is_finite()) {
            return None;
        }
        let at = |off: f64, near: &PinnedMode| self.pinned(s.re + off * deviation, deviation, near);
        let optimum =
            PinnedMode { z: mode.discrete.value.re, fall: 0.0, evaluation: self.optimum.clone() };
        let (below, above) = (at(-CLOSE, &optimum)?, at(CLOSE, &optimum)?);
        // What a parabola with this deviation would fall by is off^2. The likelihood's own is narrower if anything.
        let scale = 0.5 * (below.fall + above.fall) / (CLOSE * CLOSE);
        if !scale.is_finite() {
            return None;
        }
        let scale = scale.max(1.0);
        let root = |pinned: &PinnedMode| (pinned.fall / scale).max(0.0).sqrt();
        let low = distance(below, root, |off, near| at(-off, near));
        let high = distance(above, root, |off, near| at(off, near));
        Some([s.re - low * deviation, s.re + high * deviation])
    }

    /// The fit with the eigenvalue held at s, from one nearby. `None` where it cannot be held there: because another eigenvalue is closer to that place, or
    /// because the search did not bring it there.
    fn pinned(&self, s: f64, deviation: f64, near: &PinnedMode) -> Option<PinnedMode> {
        const STEPS: usize = 50;
        // What is left to fall is its square.
        const STEP_TOLERANCE: f64 = 0.1;
        let eigenvalue = (s * self.period).exp();
        let width = deviation * self.period * eigenvalue / PIN;
        if closest(&near.evaluation.system.a, eigenvalue)?
            != closest(&near.evaluation.system.a, near.z)?
        {
            return None;
        }
        let limits = Limits {
            steps: STEPS,
            step_tolerance: STEP_TOLERANCE,
            degrees_of_freedom: self.degrees_of_freedom,
            energy: 0.0,
            ceiling: f64::INFINITY,
            penalty: Some(EigenvaluePenalty { eigenvalue, weight: 1.0 / (width * width) }),
        };
        let start = near.evaluation.clone();
        let found = minimise(self.problem, start, &self.variances, limits);
        let evaluation = self.problem.evaluate_again(found.evaluation, &self.variances);
        let fall = evaluation.cost - self.optimum.cost;
        let reached = closest(&evaluation.system.a, eigenvalue)?;
        let is_there = (reached - eigenvalue).norm() < NEAR_ENOUGH * width;
        (is_there && fall.is_finite()).then_some(PinnedMode { z: reached.re, fall, evaluation })
    }
}

/// The eigenvalue of A closest to a place on the real axis.
fn closest(a: &DMatrix<f64>, place: f64) -> Option<Complex<f64>> {
    let off = |z: &Complex<f64>| (z - place).norm();
    let values = a.complex_eigenvalues();
    values.iter().min_by(|x, y| off(x).total_cmp(&off(y))).copied()
}

/// How far out the likelihood has fallen as far as at a 95 % end, in deviations: infinite where it does not. `root` is the fall in deviations; `close` is that at
/// `CLOSE`, and every trial starts from the closest one inside.
fn distance<T>(close: T, root: impl Fn(&T) -> f64, at: impl Fn(f64, &T) -> Option<T>) -> f64 {
    let (mut inside, mut outside) = ((CLOSE, close), None);
    for _ in 0..TRIALS {
        let fallen = root(&inside.1).min(NORMAL_95);
        let trial = match outside {
            None => {
                let growth = (NORMAL_95 / fallen.max(0.1)).clamp(1.1, FARTHEST);
                (inside.0 * growth).min(ENDLESS)
            }
            Some((far, fell)) if f64::is_finite(fell) => {
                let share = (NORMAL_95 - fallen) / (fell - fallen);
                inside.0 + share.clamp(0.05, 0.95) * (far - inside.0)
            }
            Some((far, _)) => 0.5 * (inside.0 + far),
        };
        // Where the mode cannot be held the likelihood says nothing, and the end is before that.
        let next = at(trial, &inside.1);
        let here = next.as_ref().map_or(f64::INFINITY, &root);
        if (here - NORMAL_95).abs() <= CLOSE_ENOUGH {
            return trial;
        }
        match next {
            Some(next) if here < NORMAL_95 => {
                if trial >= ENDLESS {
                    return f64::INFINITY;
                }
                inside = (trial, next);
            }
            _ => outside = Some((trial, here)),
        }
    }
    outside.map_or(f64::INFINITY, |(far, _)| 0.5 * (inside.0 + far))
}

#[cfg(test)]
mod tests;
