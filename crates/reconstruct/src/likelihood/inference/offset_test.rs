//! Do the sensors read zero in trim? The fit without frequency zero, where constant offsets are, held against the fit with it.

use super::chi_squared::chi_squared_survival;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::spectrum::RecordSpectrum;
use crate::likelihood::search::levenberg_marquardt::{Limits, minimise};

/// Whether frequency zero agrees with all others: a likelihood ratio test, with the noise levels of the fit.
///
/// The fit without frequency zero starts at the fit with it. An offset that a mode at z = 1 has swallowed, which is a constant, too, stays unseen.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OffsetTest {
    /// What chi-squared falls by where offsets may be anything.
    pub statistic: f64,
    /// Residuals at frequency zero.
    pub degrees_of_freedom: f64,
    /// The probability of a larger statistic, if the sensors read zero in trim.
    pub p_value: f64,
}

/// The test at the optimum of the likelihood; `None` where no record has frequency zero, or where nothing is left without it.
pub(crate) fn offset_test(
    problem: &Problem,
    optimum: &Evaluation,
    variances: &[f64],
    degrees_of_freedom: f64,
) -> Option<OffsetTest> {
    const STEPS: usize = 30;
    // What is left to fall is its square.
    const STEP_TOLERANCE: f64 = 0.1;
    let with_zero = problem.spectra.iter().filter(|spectrum| spectrum.starts_at_zero).count();
    let residuals = (with_zero * (problem.layout.sensors - 1)) as f64;
    let left = degrees_of_freedom - residuals;
    if with_zero == 0 || left <= 0.0 {
        return None;
    }
    let spectra = problem.spectra.iter().map(RecordSpectrum::without_zero).collect();
    let without = problem.with_spectra(spectra);
    let limits = Limits {
        steps: STEPS,
        step_tolerance: STEP_TOLERANCE,
        degrees_of_freedom: left,
        energy: 0.0,
        ceiling: f64::INFINITY,
        penalty: None,
    };
    let start = without.evaluate(optimum.system.clone(), variances);
    let cost = minimise(&without, start, variances, limits).evaluation.cost;
    let statistic = optimum.cost - cost;
    statistic.is_finite().then(|| OffsetTest {
        statistic: statistic.max(0.0),
        degrees_of_freedom: residuals,
        p_value: chi_squared_survival(statistic.max(0.0), residuals),
    })
}

#[cfg(test)]
mod tests;
