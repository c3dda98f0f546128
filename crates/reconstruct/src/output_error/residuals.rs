//! Residuals of one record at one set of matrices, and the sums that a step of the search needs.
//!
//! ```text
//! E(w) = Y - (C (zI - A)^-1 B + D) V - z C (zI - A)^-1 t - ramp delta
//! ```
//!
//! with V the inputs turned by their lags and Y the sensors turned back by theirs, t the difference between initial and final state, delta the drift of the
//! sensors. A sensor that is late reads in its first samples what was before the record. Turned back, these lie around the
//! record's beginning and end, where the transform goes round; there each sample of such a sensor is free. The sums over frequencies are those of the likelihood (`likelihood/cost`) with no excitation beside the known signals. What the residuals can be
//! explained by through t and delta is taken out at every step, so that these cost the search nothing.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::cells::Matrices;
use super::disturbance::Weighting;
use super::known_signals::{KnownSignals, before, turn};
use super::spectra::Spectrum;
use crate::likelihood::cost::accumulate::{Scalars, accumulate};
use crate::likelihood::cost::inverse_factor::inverse_factor;
use crate::likelihood::cost::missing::Unknowns;
use crate::likelihood::cost::record_system::RecordSystem;
use crate::likelihood::cost::resolvent::Resolvent;
use crate::likelihood::cost::spectrum::RecordSpectrum;
use crate::likelihood::cost::sums::Sums;

/// The sums of one record.
pub(super) struct RecordSums {
    pub(super) cost: f64,
    /// J' J by the cells of the matrices, without what t and delta explain.
    pub(super) gram: DMatrix<f64>,
    /// -J' e in the same way: half the direction of steepest descent.
    pub(super) descent: DVector<f64>,
    /// t and delta at their best.
    pub(super) nuisances: Nuisances,
    /// How many of them the record determines.
    pub(super) determined: usize,
}

/// What a record has of its own beside its inputs.
#[derive(Clone, Debug)]
pub(super) struct Nuisances {
    /// The difference between initial and final state.
    pub(super) transient: DVector<f64>,
    /// The drift of each sensor; empty where they have none.
    pub(super) drift: Vec<f64>,
    /// The sensors that are late.
    late: Vec<usize>,
    /// What each of them reads in its first samples beside the rest, those of the first such sensor first.
    pub(super) first_samples: Vec<f64>,
    /// What the most likely values of missing samples add to the sensors, m x F, these turned back by their lags; `None` where none are missing.
    pub(super) filling: Option<DMatrix<Complex<f64>>>,
}

impl Nuisances {
    /// Of a record that the model explains without them.
    pub(super) fn none(states: usize) -> Self {
        Self {
            transient: DVector::zeros(states),
            drift: Vec::new(),
            late: Vec::new(),
            first_samples: Vec::new(),
            filling: None,
        }
    }

    /// The transform of the first samples of a sensor; zero where it is in time.
    fn first(&self, sensor: usize, z: Complex<f64>) -> Complex<f64> {
        let Some(place) = self.late.iter().position(|&late| late == sensor) else {
            return Complex::ZERO;
        };
        let each = self.first_samples.len() / self.late.len();
        let own = self.first_samples.iter().skip(place * each).take(each);
        let nothing = Complex::new(0.0, 0.0);
        own.rev().fold(nothing, |sum, &sample| sum / z + sample) * before(z, each / 2)
    }
}

/// Directions below this share of the largest one are rounding errors; the squares of singular values are compared.
const RANK_TOLERANCE: f64 = 1e-12;

/// Sums of a record; `None` where something is not finite.
///
/// `free_lags` are the cells of the lags that are estimated; `unknowns` is what [`missing`] says.
pub(super) fn sums(
    matrices: &Matrices,
    spectrum: &Spectrum,
    weighting: &Weighting,
    free_lags: &[usize],
    unknowns: Option<&Unknowns>,
) -> Option<RecordSums> {
    let signals = KnownSignals::new(matrices, spectrum, free_lags);
    let record = signals.spectrum(matrices, spectrum, weighting, None);
    let nothing = Nuisances::none(signals.states);
    let first = accumulated(&signals.system(matrices, &nothing), &record, unknowns)?;
    let own = signals.nuisance_cells();
    let factor = inverse_factor(&first.gram_of(&own), RANK_TOLERANCE)?;
    let right = DVector::from_iterator(own.len(), own.iter().map(|&cell| first.descent(cell)));
    let best = factor.tr_mul(&(&factor * right));
    let mut nuisances = Nuisances {
        transient: best.rows(0, signals.states).into_owned(),
        drift: best.iter().skip(signals.states).take(signals.drifts()).copied().collect(),
        late: signals.late.clone(),
        first_samples: best.iter().skip(signals.states + signals.drifts()).copied().collect(),
        filling: None,
    };
    nuisances.filling = filling(&signals.system(matrices, &nuisances), &record, unknowns)?;
    let record = if signals.free_sensors.is_empty() {
        record
    } else {
        // How the fit moves with a lag follows from what the model says of the sensor: from what the sensor reads, its noise would count as known.
        let mut left = residuals(matrices, spectrum, &nuisances);
        if let Some(filling) = &nuisances.filling {
            left -= filling;
        }
        signals.spectrum(matrices, spectrum, weighting, Some(&left))
    };
    let sums = accumulated(&signals.system(matrices, &nuisances), &record, unknowns)?;

    let cells = signals.cells();
    let mixed =
        &factor * DMatrix::from_fn(own.len(), cells.len(), |i, k| sums.gram(own[i], cells[k]));
    let gram = sums.gram_of(&cells) - mixed.tr_mul(&mixed);
    let rest = DVector::from_iterator(own.len(), own.iter().map(|&cell| sums.descent(cell)));
    let descent = DVector::from_iterator(cells.len(), cells.iter().map(|&cell| sums.descent(cell)))
        - mixed.tr_mul(&(&factor * rest));
    let moves = signals.moves(matrices);
    Some(RecordSums {
        cost: sums.cost,
        gram: moves.tr_mul(&(gram * &moves)),
        descent: moves.tr_mul(&descent),
        determined: factor.nrows(),
        nuisances,
    })
}

/// What the matrices leave of a record, m x F, its sensors turned back by their lags.
pub(super) fn residuals(
    matrices: &Matrices,
    spectrum: &Spectrum,
    nuisances: &Nuisances,
) -> DMatrix<Complex<f64>> {
    let (n, m) = (matrices.a.nrows(), matrices.c.nrows());
    let mut left = DMatrix::zeros(m, spectrum.z.len());
    let mut resolvent = Resolvent::new(n);
    let a = matrices.a.transpose().as_slice().to_vec();
    let mut row = vec![Complex::ZERO; n];
    for (k, &z) in spectrum.z.iter().enumerate() {
        resolvent.factor(z, &a);
        let frequency = spectrum.frequencies[k];
        let inputs = DVector::from_fn(matrices.b.ncols(), |input, _| {
            spectrum.u[(input, k)] * turn(frequency, matrices.input_lags[input])
        });
        let driven = DVector::from_fn(n, |i, _| {
            let forced: Complex<f64> =
                inputs.iter().enumerate().map(|(input, u)| u * matrices.b[(i, input)]).sum();
            forced + z * nuisances.transient[i]
        });
        for s in 0..m {
            for (entry, &own) in row.iter_mut().zip(matrices.c.row(s).iter()) {
                *entry = Complex::from(own);
            }
            resolvent.solve_row(&mut row);
            let state: Complex<f64> = row.iter().zip(driven.iter()).map(|(h, x)| h * x).sum();
            let direct: Complex<f64> =
                inputs.iter().enumerate().map(|(input, u)| u * matrices.d[(s, input)]).sum();
            let drift = match (spectrum.ramp.get(k), nuisances.drift.get(s)) {
                (Some(ramp), Some(&drift)) => ramp * drift,
                _ => Complex::ZERO,
            };
            let measured = spectrum.y[(s, k)] * turn(-frequency, matrices.sensor_lags[s]);
            let filled = nuisances.filling.as_ref().map_or(Complex::ZERO, |own| own[(s, k)]);
            left[(s, k)] = measured + filled - state - direct - drift - nuisances.first(s, z);
        }
    }
    left
}

/// What the sensors of a record read, m x F: the most likely values in place of missing samples.
pub(super) fn readings(
    matrices: &Matrices,
    spectrum: &Spectrum,
    nuisances: &Nuisances,
) -> DMatrix<Complex<f64>> {
    let mut read = spectrum.y.clone();
    if let Some(filling) = &nuisances.filling {
        for (k, &frequency) in spectrum.frequencies.iter().enumerate() {
            for (s, &lag) in matrices.sensor_lags.iter().enumerate() {
                read[(s, k)] += filling[(s, k)] * turn(frequency, lag);
            }
        }
    }
    read
}

/// The missing samples' own Gram matrix under these weights, which does not depend on the system; `None` where none are missing, or where it depends on lags that
/// are estimated.
pub(super) fn missing(
    matrices: &Matrices,
    spectrum: &Spectrum,
    weighting: &Weighting,
    free_lags: &[usize],
) -> Option<Unknowns> {
    if spectrum.missing.is_none() || !free_lags.is_empty() {
        return None;
    }
    let signals = KnownSignals::new(matrices, spectrum, free_lags);
    let record = signals.spectrum(matrices, spectrum, weighting, None);
    record.missing.as_ref()?.unknowns(&record, &weighting.precision)
}

fn accumulated(
    system: &RecordSystem,
    record: &RecordSpectrum,
    unknowns: Option<&Unknowns>,
) -> Option<Sums> {
    let sum = |record: &RecordSpectrum| accumulate(record, system, Scalars::Estimated, false, 1);
    let sums = match &record.missing {
        None => sum(record),
        Some(missing) => missing.sums(record, system, Scalars::Estimated, unknowns, sum),
    };
    sums.cost.is_finite().then_some(sums)
}

/// What the most likely values of missing samples add to the sensors, m x F.
fn filling(
    system: &RecordSystem,
    record: &RecordSpectrum,
    unknowns: Option<&Unknowns>,
) -> Option<Option<DMatrix<Complex<f64>>>> {
    let Some(missing) = &record.missing else { return Some(None) };
    let filled = missing.filled(record, system, unknowns)?;
    let added = filled.y.iter().zip(&record.y).map(|(filled, y)| filled - y);
    Some(Some(DMatrix::from_iterator(system.d.len(), record.frequencies(), added)))
}

#[cfg(test)]
mod tests;
