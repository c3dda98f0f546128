//! Which dynamics do the signal subspaces of all records share? Any excitation, noise of unknown level, no iteration over the model.

mod dense;
mod diagnosis;
mod doubt;
mod engine;
mod evidence;
mod excitation;
mod factor;
mod input_direction;
mod levels;
mod limits;
mod options;
mod order;
mod realisation;
mod sources;
mod whitened;
mod whitening;

pub(crate) use diagnosis::of_order;
pub use doubt::Doubt;
pub use evidence::{Intersection, Mode, NoiseEvidence, NoiseOrigin, RecordEvidence};
pub use excitation::ExcitationRank;
pub use options::{Options, OrderChoice};
pub use order::OrderEvidence;
pub(crate) use order::{WEAK_GAP, best};
pub(crate) use whitened::Whitened;

use crate::{ReconstructError, Record};
use diagnosis::{Findings, doubts, same_excitation};
use engine::{Engine, Realised};
use excitation::excitation_rank;
use limits::Setting;
use sources::Sources;

/// Finds the dynamics that all records share, whatever excited them.
///
/// Record j holds m sensors of `x(k+1) = A x(k) + b_j u_j(k)`, `y(k) = C x(k)`, with an excitation `u_j` that nobody measured. The columns of its
/// block-Hankel matrix of L block rows, `h = (y(k), .., y(k + L - 1))`, are
///
/// ```text
/// h = O_L x(k) + T_L(b_j) (u_j(k), .., u_j(k + L - 1)) + noise,
/// O_L = (C; C A; ..; C A^(L-1)),   T_L(b) with column c = (0; ..; C b; C A b; ..), c + 1 blocks of zeros.
/// ```
///
/// 1. The sensors are scaled by their noise levels, so that noise has variance 1 in every direction. Levels that are not known are estimated
///    from the directions with the least variance.
/// 2. The eigenvectors `N_j` of the smallest eigenvalues of each record's covariance annihilate `O_L` and `T_L(b_j)`, whatever `u_j` was.
/// 3. `O_L` is common to all records: it is the n eigenvectors of `sum_j N_j N_j'` with the smallest eigenvalues, `N_j` taken back to units of
///    the sensors' deviations. (With coloured noise the intersection is not sought in whitened coordinates: there, directions with little
///    noise would weigh most, whether or not the modes show in them.)
/// 4. A follows by shift invariance, C is the first block, and `b_j` solves `N_j' T_L(b_j) = 0`.
///
/// | symbol | what | shape |
/// |---|---|---|
/// | J, m, n | records, sensors, states | |
/// | L | block rows, [`Options::block_rows`] | |
/// | `N_j` | noise directions of record j | mL x (mL - (L - 1) - n), one less with a direct path |
///
/// Needed are J (m - 1) > m, so two records of three sensors or three records of two, L >= (J - 1) n / (J (m - 1) - m), and directions `b_j`
/// that differ. Records may differ in length. Neither stability nor causality is assumed, and no initial state. This is Theorem 3.1
/// in geometric form: where two transmissibilities agree, the signal spaces meet.
///
/// Noise-free records give eigenvalues to about rounding level: their covariances are summed in doubled precision, and their
/// singular values are found without squaring. The states of the [`model`](Intersection::model) are in the basis in which `O_L` is
/// orthonormal in units of the sensors' deviations; `b_j` has length 1.
///
/// What makes the result untrustworthy is in its [`doubts`](Intersection::doubts).
///
/// # Errors
///
/// [`ReconstructError::NotIdentifiable`], [`ReconstructError::TooFewBlockRows`], [`ReconstructError::RecordTooShort`],
/// [`ReconstructError::OrderTooHigh`] and [`ReconstructError::InvalidOrder`] with the inequality that fails; records that do not fit together,
/// [`ReconstructError::ZeroRecord`], [`ReconstructError::ConstantChannel`] and [`ReconstructError::DuplicatedChannel`];
/// [`ReconstructError::NoiseLevelCount`], [`ReconstructError::InvalidNoiseLevel`] and [`ReconstructError::SilentRecord`] for a noise model that
/// does not fit; [`ReconstructError::Step`] where a decomposition fails.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("doctest/two_decays.md")]
/// use reconstruct::subspace::{Options, identify};
///
/// let records = two_decays(0.9, 400, 0.0)?;
/// let found = identify(&records, &Options::default())?;
/// assert_eq!(found.order.order, 2);
/// assert!((found.modes[0].pole.re - 0.5).abs() < 1e-10);
/// assert!((found.modes[1].pole.re - 0.9).abs() < 1e-10);
/// assert_eq!(found.records[0].excitation.rank, 1);
/// assert!(found.doubts.is_empty(), "{:?}", found.doubts);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify(records: &[Record], options: &Options) -> Result<Intersection, ReconstructError> {
    let setting = Setting::new(records, options)?;
    let extent = setting.extent(options.order, options.block_rows)?;
    let probe = levels::window_rows(setting.sensors, extent.largest_order, extent.block_rows);
    let sources = Sources::new(setting, extent.block_rows, probe)?;
    let engine = Engine { setting, sources: &sources, block_rows: extent.block_rows };

    let (mut whitening, mut origin) = engine.noise(&options.noise, extent.largest_order)?;
    let mut spectra = engine.spectra(&whitening)?;
    let (order, gaps) = match options.order {
        OrderChoice::Fixed(order) => (order, None),
        OrderChoice::Gap { .. } => {
            let gaps = engine.spaces(&spectra, &whitening, origin).gaps(extent.largest_order)?;
            (best(&gaps), Some(gaps))
        }
    };
    if order < extent.largest_order && options.noise.is_estimated() {
        (whitening, origin) = engine.noise(&options.noise, order)?;
        spectra = engine.spectra(&whitening)?;
    }
    if let NoiseOrigin::Estimated { .. } = origin
        && let Some(better) = engine.noise_of_several(&spectra, order)?
    {
        (whitening, origin, spectra) = better;
    }

    let spaces = engine.spaces(&spectra, &whitening, origin);
    let (observability, mut evidence) = spaces.common(order)?;
    if let Some(gaps) = gaps {
        (evidence.asked, evidence.gaps) = (false, gaps);
    }
    let Realised { model, realisation, ambiguities } =
        engine.realised(records, &spaces, &whitening, &observability)?;
    let mut found = Vec::with_capacity(records.len());
    for (j, (record, spectrum)) in records.iter().zip(&spectra).enumerate() {
        let columns = sources.columns[j];
        let counted = (spectrum.values.as_slice(), extent.block_rows);
        let source = &sources.records[j].0;
        let excitation = excitation_rank(setting, &whitening, source, counted, columns, order)?;
        found.push(RecordEvidence {
            record: record.name().to_owned(),
            columns,
            eigenvalues: spectrum.values.clone(),
            excitation,
            ambiguity: ambiguities[j],
        });
    }
    let deviations = engine.deviations(&whitening);
    let modes = evidence::modes(&model, &whitening.whitened(observability), &spectra)?;
    let noise = NoiseEvidence { deviations, origin };
    let condition = realisation.condition;
    let findings =
        Findings { order: &evidence, noise: &noise, records: &found, modes: &modes, condition };
    let mut doubts = doubts(&findings);
    doubts.extend(same_excitation(setting, &spectra, &evidence, extent.block_rows)?);
    Ok(Intersection {
        model,
        modes,
        order: evidence,
        noise,
        block_rows: extent.block_rows,
        records: found,
        condition,
        residual: realisation.residual,
        doubts,
    })
}

#[cfg(test)]
mod tests;
