//! A subset of the frequencies for the search's first look: finding the local optima takes fewer frequencies than ranking them.

use crate::likelihood::cost::evaluation::Problem;
use crate::likelihood::cost::spectrum::RecordSpectrum;

/// A first look takes this many times the square root of a record's frequencies, at least [`FEWEST`].
const FREQUENCIES_PER_ROOT: f64 = 8.0;
const FEWEST: usize = 256;

/// The problem at fewer frequencies: a quarter of them the lowest ones, where slow modes show, the others evenly spread and weighted for those they
/// stand for, so that costs keep their scale. `None` where that would save less than half.
pub(crate) fn frequency_subset(problem: &Problem) -> Option<FrequencySubset> {
    let (mut before, mut after, mut largest_weight) = (0, 0, 1.0_f64);
    let spectra: Vec<RecordSpectrum> = problem
        .spectra
        .iter()
        .map(|spectrum| {
            let (thin, stands_for) = thin(spectrum);
            largest_weight = largest_weight.max(stands_for);
            before += spectrum.frequencies();
            after += thin.frequencies();
            thin
        })
        .collect();
    let problem = problem.with_spectra(spectra);
    (2 * after <= before).then_some(FrequencySubset { problem, largest_weight })
}

/// A problem at fewer frequencies.
pub(crate) struct FrequencySubset {
    pub(crate) problem: Problem,
    /// How many frequencies one of them stands for at the most: chance moves the costs so many times as much.
    pub(crate) largest_weight: f64,
}

/// The spectrum at fewer frequencies, and how many one of the spread ones stands for.
fn thin(spectrum: &RecordSpectrum) -> (RecordSpectrum, f64) {
    let all = spectrum.frequencies();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few thousand at most"
    )]
    let wanted = ((all as f64).sqrt() * FREQUENCIES_PER_ROOT) as usize;
    let wanted = wanted.max(FEWEST);
    if wanted >= all {
        return (spectrum.clone(), 1.0);
    }
    let lowest = wanted / 4;
    let spread = wanted - lowest;
    // The middle of each of `spread` equal parts of the rest.
    let others = (0..spread).map(|k| lowest + (2 * k + 1) * (all - lowest) / (2 * spread));
    let stands_for = (all - lowest) as f64 / spread as f64;
    let (m, entries) = (spectrum.offset_variance.len(), spectrum.entries.len());
    let mut thin = RecordSpectrum {
        z: Vec::with_capacity(wanted),
        weight: Vec::with_capacity(wanted),
        y: Vec::with_capacity(wanted * m),
        entries: spectrum.entries.clone(),
        factors: Vec::with_capacity(wanted * entries),
        precision: spectrum.precision.as_ref().map(|_| Vec::with_capacity(wanted * m * m)),
        power: spectrum.power.as_ref().map(|_| Vec::with_capacity(wanted * m)),
        offset_variance: spectrum.offset_variance.clone(),
        starts_at_zero: spectrum.starts_at_zero,
        // A first look takes interpolated samples for measured ones: fewer frequencies do not tell single samples apart.
        missing: None,
    };
    for k in (0..lowest).chain(others) {
        let weight = if k < lowest { 1.0 } else { stands_for };
        thin.z.push(spectrum.z[k]);
        thin.weight.push(weight * spectrum.weight[k]);
        thin.y.extend_from_slice(&spectrum.y[k * m..(k + 1) * m]);
        thin.factors.extend_from_slice(&spectrum.factors[k * entries..(k + 1) * entries]);
        if let (Some(thin), Some(precision)) = (&mut thin.precision, &spectrum.precision) {
            thin.extend_from_slice(&precision[k * m * m..(k + 1) * m * m]);
        }
        if let (Some(thin), Some(power)) = (&mut thin.power, &spectrum.power) {
            thin.extend_from_slice(&power[k * m..(k + 1) * m]);
        }
    }
    (thin, stands_for)
}

#[cfg(test)]
mod tests;
