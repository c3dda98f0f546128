//! What of an intersection of signal subspaces should not be trusted: from evidence to doubts.

use nalgebra::DMatrix;

use super::dense::{Eigen, eigenvalues};
use super::doubt::Doubt;
use super::evidence::{Mode, NoiseEvidence, NoiseOrigin, RecordEvidence};
use super::limits::Setting;
use super::order::{OrderEvidence, WEAK_GAP};
use crate::ReconstructError;

/// Above this, the next direction of excitation fits nearly as well.
const AMBIGUOUS: f64 = 0.7;

/// Variance along a mode, in units of the noise's, below which a record shows next to nothing of it.
const HARDLY: f64 = 6.0;

/// Above this, half of the digits of A are lost.
const LARGEST_CONDITION: f64 = 1e8;

/// What a doubt may come from.
pub(super) struct Findings<'a> {
    pub(super) order: &'a OrderEvidence,
    pub(super) noise: &'a NoiseEvidence,
    pub(super) records: &'a [RecordEvidence],
    pub(super) modes: &'a [Mode],
    pub(super) condition: f64,
}

/// Doubts about the number of states.
pub(crate) fn of_order(evidence: &OrderEvidence) -> Vec<Doubt> {
    let OrderEvidence { order, gap, ref gaps, .. } = *evidence;
    let mut doubts = Vec::new();
    if gap < WEAK_GAP {
        doubts.push(Doubt::WeakOrder { order, gap });
    }
    let largest = gaps.iter().max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some(&(other, other_gap)) = largest
        && other != order
        && other_gap > gap
    {
        doubts.push(Doubt::ContestedOrder { order, gap, other, other_gap });
    }
    doubts
}

/// All doubts but that of equal excitations.
pub(super) fn doubts(findings: &Findings<'_>) -> Vec<Doubt> {
    let mut doubts = of_order(findings.order);
    if let NoiseOrigin::Estimated { rounds, converged: false } = findings.noise.origin {
        doubts.push(Doubt::NoiseNotConverged { rounds });
    }
    for found in findings.records {
        let (record, excitation) = (&found.record, &found.excitation);
        let (rank, growth) = (excitation.rank, excitation.growth);
        match rank {
            0 => doubts.push(Doubt::NoExcitation { record: record.clone() }),
            1 => {}
            _ => doubts.push(Doubt::SeveralExcitations { record: record.clone(), rank, growth }),
        }
        if excitation.largest_noise > excitation.noise_edge {
            let (largest, edge) = (excitation.largest_noise, excitation.noise_edge);
            doubts.push(Doubt::NoiseNotWhite { record: record.clone(), largest, edge });
        }
        if found.ambiguity > AMBIGUOUS {
            let ambiguity = found.ambiguity;
            doubts.push(Doubt::UncertainDirection { record: record.clone(), ambiguity });
        }
    }
    for mode in findings.modes.iter().filter(|mode| mode.pole.im >= 0.0) {
        for (found, &excitation_snr) in findings.records.iter().zip(&mode.excitation_snr) {
            if excitation_snr < HARDLY {
                let record = found.record.clone();
                doubts.push(Doubt::HardlyExcited { pole: mode.pole, record, excitation_snr });
            }
        }
    }
    if findings.condition > LARGEST_CONDITION {
        doubts.push(Doubt::IllConditioned { condition: findings.condition });
    }
    doubts
}

/// Pairs of records whose signal spaces meet in more directions than the states account for.
///
/// With equal directions of excitation all of `T_L(b)` is common, n + L - 1 directions. Different ones meet in n, or in as many as the
/// dimensions force them to, 2 (n + L - 1) - m L.
pub(super) fn same_excitation(
    setting: Setting<'_>,
    spectra: &[Eigen],
    evidence: &OrderEvidence,
    block_rows: usize,
) -> Result<Vec<Doubt>, ReconstructError> {
    /// An eigenvalue of the sum of two projectors is 1 - cos of the angle between the spaces: this is 8 degrees.
    const COMMON: f64 = 0.01;
    /// So many further directions can be common by chance, where excitations have little power beyond low frequencies.
    const CHANCE: usize = 3;
    /// A gap as noise does not leave among the directions of equal excitations.
    const TOLD_APART: f64 = 100.0;
    if spectra.len() == 2 && evidence.gap >= TOLD_APART {
        return Ok(Vec::new());
    }
    let (rows, order) = (block_rows * setting.sensors, evidence.order);
    let signal = setting.signal_dimension(block_rows, order, 1);
    let expected = order.max((2 * signal).saturating_sub(rows));
    let enough = expected + CHANCE.max(block_rows / 8);
    let mut doubts = Vec::new();
    for (first, second) in (0..spectra.len()).flat_map(|b| (0..b).map(move |a| (a, b))) {
        let mut sum = DMatrix::zeros(rows, rows);
        for spectrum in [&spectra[first], &spectra[second]] {
            let directions = spectrum.vectors.columns(0, rows - signal);
            sum.gemm(1.0, &directions, &directions.transpose(), 1.0);
        }
        let values = eigenvalues(&sum)?;
        let common = values.iter().filter(|value| **value < COMMON).count();
        // Nearly equal directions that records of little noise still tell apart leave a gap behind those that have to be common.
        let gap = values[expected] / values[expected - 1].max(f64::EPSILON);
        if common >= enough && gap < TOLD_APART {
            let name = |record: usize| setting.records[record].name().to_owned();
            let (first, second) = (name(first), name(second));
            doubts.push(Doubt::SameExcitation { first, second, common, expected });
        }
    }
    Ok(doubts)
}

#[cfg(test)]
mod tests;
