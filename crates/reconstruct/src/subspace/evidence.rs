//! The result: a model, and what is needed to doubt it.

use nalgebra::DMatrix;
use num_complex::Complex;

use super::dense::Eigen;
use super::doubt::Doubt;
use super::excitation::ExcitationRank;
use super::order::OrderEvidence;
use super::realisation::eigenvector;
use crate::{ReconstructError, SharedModel};

/// What [`identify`](super::identify) makes of several records.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Intersection {
    /// A, C, and the direction of excitation of each record.
    pub model: SharedModel,
    /// The modes, in the order of [`SharedModel::poles`].
    pub modes: Vec<Mode>,
    /// Why the order is what it is.
    pub order: OrderEvidence,
    /// The noise levels used.
    pub noise: NoiseEvidence,
    /// The number of block rows, L.
    pub block_rows: usize,
    /// What each record shows.
    pub records: Vec<RecordEvidence>,
    /// Condition number of the observability matrix without its last block row: how well the states can be told apart.
    pub condition: f64,
    /// What A leaves unexplained of the shifted observability matrix, relative to it. Noise, mostly.
    pub residual: f64,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<Doubt>,
}

/// A mode, and how strongly each record shows it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// The eigenvalue of A in the z plane.
    pub pole: Complex<f64>,
    /// For each record the variance along the mode's direction o in the stacked sensors that no other direction explains, in units of the
    /// noise's variance: `1 / (o' G^-1 o)` of the whitened covariance G (Capon 1969). 1 is noise.
    pub excitation_snr: Vec<f64>,
}

/// Noise levels and where they come from.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NoiseEvidence {
    /// Standard deviation of each sensor's noise, in the sensor's unit; positive.
    pub deviations: Vec<f64>,
    /// Where they come from.
    pub origin: NoiseOrigin,
}

/// Where noise levels come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoiseOrigin {
    /// They were given.
    Given,
    /// They were estimated. They come out some per cent low in short records.
    Estimated {
        /// Rounds of scaling.
        rounds: usize,
        /// Whether the last round changed no level by more than 1e-4 of itself.
        converged: bool,
    },
    /// The records hold nothing but rounding errors beside the signal. The levels are upper bounds, equal fractions of the
    /// sensors' deviations.
    Rounding,
    /// They are the deviations of a quiet record, of which the whole covariance was used.
    Quiet {
        /// Its number of samples.
        samples: usize,
    },
}

/// What one record shows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RecordEvidence {
    /// The record's name.
    pub record: String,
    /// The number of columns of its block-Hankel matrix, N - L + 1.
    pub columns: usize,
    /// The eigenvalues of its covariance in units of the noise's variance, ascending.
    pub eigenvalues: Vec<f64>,
    /// The number of excitations.
    pub excitation: ExcitationRank,
    /// How well the next direction of excitation fits in comparison with `b_j`: 0 if it does not fit at all, 1 if `b_j` is arbitrary.
    pub ambiguity: f64,
}

/// The modes of the model, with how strongly each record excites them. `common` holds the observability matrix in whitened coordinates.
pub(super) fn modes(
    model: &SharedModel,
    common: &DMatrix<f64>,
    spectra: &[Eigen],
) -> Result<Vec<Mode>, ReconstructError> {
    let poles = model.poles().map_err(|error| ReconstructError::Step {
        step: "eigenvalues of A",
        message: error.to_string(),
    })?;
    let mode = |pole: Complex<f64>| {
        let excitation_snr = match eigenvector(&model.a, pole) {
            Some(vector) => {
                let (re, im) = (common * vector.map(|z| z.re), common * vector.map(|z| z.im));
                let square = re.norm_squared() + im.norm_squared();
                spectra.iter().map(|spectrum| capon(spectrum, [&re, &im]) * square).collect()
            }
            None => vec![0.0; spectra.len()],
        };
        Mode { pole, excitation_snr }
    };
    Ok(poles.into_iter().map(mode).collect())
}

/// `1 / sum_k |v_k' o|^2 / w_k` for a complex direction o.
fn capon(spectrum: &Eigen, parts: [&DMatrix<f64>; 2]) -> f64 {
    let largest = spectrum.values.last().copied().unwrap_or(1.0);
    // Rounding errors can make a value vanish or negative.
    let floor = f64::EPSILON * f64::EPSILON * largest + f64::MIN_POSITIVE;
    let components = parts.map(|part| spectrum.vectors.tr_mul(part));
    let sum: f64 = spectrum
        .values
        .iter()
        .enumerate()
        .map(|(k, value)| (components[0][k].powi(2) + components[1][k].powi(2)) / value.max(floor))
        .sum();
    1.0 / sum
}

#[cfg(test)]
mod tests;
