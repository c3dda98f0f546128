//! The sums over frequencies behind cost, gradient and Gram matrix of one record: the inner loop of the fit.
//!
//! At one frequency, H = C (zI - A)^-1, g = H b + d, Phi = S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g), S the noise covariance, and e what the sensors
//! read less what known signals explain. The excitation's estimate is U = g^H S^-1 e / (g^H S^-1 g), the state's X = (zI - A)^-1 (b U + f tau), and
//! the cost is e^H Phi e. Every parameter moves the sensors by a column of D = [H, I] times one of the scalars s = (X, U, f): entry (i, l) of A by H_i X_l,
//! b_i by H_i U, entry (s, l) of C by I_s X_l. So the Gram matrix is the sum of Re (D^H Phi D)_ik conj(s_a) s_c, a Kronecker product at each
//! frequency, and the sum is a product of two matrices with one column per frequency.

use std::ops::Range;

use hankel::{Sharing, in_order};

use super::frequency_block::{AtFrequencies, FrequencyBlock};
use super::record_system::RecordSystem;
use super::schur_form::SchurForm;
use super::simd::WIDTH;
use super::spectrum::RecordSpectrum;
use super::sums::{Sums, TILE, Tile, Totals};

/// Frequencies that one thread sums at a time. A record is cut there whatever the number of threads, so that its sums do not depend on that.
pub(crate) const SHARE: usize = 512 * TILE;

/// Which scalars multiply D.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalars {
    /// The estimates X and U.
    Estimated,
    /// Only what noise alone would contribute to them: U = 1 / sqrt(g^H S^-1 g), X = (zI - A)^-1 b U, f = 0.
    NoisePart,
}

/// Adds up one record.
pub(crate) fn accumulate(
    record: &RecordSpectrum,
    system: &RecordSystem,
    scalars: Scalars,
    keep_spectrum: bool,
    threads: usize,
) -> Sums {
    let (n, m) = (system.b.len(), system.d.len());
    let count = n + 1 + record.entries.len();
    let levels = system.variances.len().max(m);
    let mut all = Sums::zero(n, m, levels, count, keep_spectrum);
    let Some(schur) = SchurForm::new(record, system) else {
        // Without a Schur form there is no cost: NaN is never below anything.
        all.cost = f64::NAN;
        return all;
    };
    let frequencies = record.frequencies();
    let shares: Vec<Range<usize>> = (0..frequencies)
        .step_by(SHARE)
        .map(|first| first..frequencies.min(first + SHARE))
        .collect();
    let sum = |share: &Range<usize>| {
        let mut sums = Sums::zero(n, m, levels, count, keep_spectrum);
        let mut totals = Totals::new(n, m, levels, count);
        pulp::Arch::new().dispatch(Loop {
            record,
            frequencies: share.clone(),
            schur: &schur,
            scalars,
            totals: &mut totals,
            sums: &mut sums,
        });
        totals.give(&mut sums);
        sums
    };
    let mut total: Option<Sums> = None;
    let sharing = Sharing { threads, least: 1 };
    in_order(
        &shares,
        sharing,
        |shares| shares.iter().map(sum).collect(),
        |part| match &mut total {
            Some(total) => total.add(part),
            None => total = Some(part),
        },
    );
    total.unwrap_or(all)
}

/// What stands behind the sums of the likelihood at each frequency; `None` where [`accumulate`] gives no cost.
pub(crate) fn at_frequencies(
    record: &RecordSpectrum,
    system: &RecordSystem,
) -> Option<AtFrequencies> {
    let schur = SchurForm::new(record, system)?;
    let mut written = AtFrequencies::default();
    pulp::Arch::new().dispatch(Writing { record, schur: &schur, into: &mut written });
    Some(written)
}

/// The loop of [`at_frequencies`].
struct Writing<'a> {
    record: &'a RecordSpectrum,
    schur: &'a SchurForm,
    into: &'a mut AtFrequencies,
}

impl pulp::WithSimd for Writing<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _simd: S) {
        let Self { record, schur, into } = self;
        let mut at = FrequencyBlock::new(schur);
        for first in (0..record.frequencies()).step_by(WIDTH) {
            at.load(record, schur, first);
            at.evaluate(record, schur);
            at.estimated_scalars(schur);
            at.write_down(WIDTH.min(record.frequencies() - first), into);
        }
    }
}

/// The loop over frequencies, compiled once for each kind of vectors.
struct Loop<'a> {
    record: &'a RecordSpectrum,
    /// From a multiple of [`WIDTH`] on.
    frequencies: Range<usize>,
    schur: &'a SchurForm,
    scalars: Scalars,
    totals: &'a mut Totals,
    sums: &'a mut Sums,
}

impl pulp::WithSimd for Loop<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _simd: S) {
        add_up(self);
    }
}

#[inline(always)]
fn add_up(parts: Loop<'_>) {
    let Loop { record, frequencies, schur, scalars, totals, sums } = parts;
    let mut tile = Tile::new(sums.real.nrows(), sums.real.ncols());
    let mut at = FrequencyBlock::new(schur);
    for first in frequencies.clone().step_by(WIDTH) {
        at.load(record, schur, first);
        at.evaluate(record, schur);
        let cost = at.weight * at.cost();
        totals.cost += cost;
        if let Some(spectrum) = &mut sums.spectrum {
            spectrum.extend(&cost.0[..WIDTH.min(frequencies.end - first)]);
        }
        at.add_levels(totals);
        match scalars {
            Scalars::Estimated => at.estimated_scalars(schur),
            Scalars::NoisePart => at.noise_scalars(schur),
        }
        at.add_moments(totals);
        at.fill(&mut tile);
        if tile.filled == TILE {
            tile.flush(sums);
        }
    }
    tile.flush(sums);
}

#[cfg(test)]
mod tests;
