//! Which dynamics do the signal subspaces of all records share? Any excitation, noise of unknown level, no iteration over the model.

mod dense;
mod diagnosis;
mod doubt;
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
mod whitening;

use nalgebra::{DMatrix, DVector};

pub(crate) use diagnosis::of_order;
pub use doubt::Doubt;
pub use evidence::{Intersection, Mode, NoiseEvidence, NoiseOrigin, RecordEvidence};
pub use excitation::ExcitationRank;
pub use options::{Options, OrderChoice};
pub use order::OrderEvidence;
pub(crate) use order::{WEAK_GAP, best};

use crate::{NoiseModel, ReconstructError, Record, SharedModel};
use dense::Eigen;
use diagnosis::{Findings, doubts, same_excitation};
use excitation::{excitation_rank, noise_edge};
use input_direction::input_direction;
use levels::Window;
use limits::{Extent, Setting};
use order::Spaces;
use realisation::{Realisation, realise};
use sources::{Sources, quiet_whitening};
use whitening::Whitening;

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

/// Records with their noise whitened by levels that are known: the model at one order after another, without what is said about it.
pub(crate) struct Whitened<'a> {
    records: &'a [Record],
    setting: Setting<'a>,
    sources: Sources,
    extent: Extent,
    whitening: Whitening,
    spaces: Spaces,
}

impl<'a> Whitened<'a> {
    /// Whitens the records by the levels of the options.
    pub(crate) fn new(
        records: &'a [Record],
        options: &'a Options,
    ) -> Result<Self, ReconstructError> {
        let setting = Setting::new(records, options)?;
        let extent = setting.extent(options.order, options.block_rows)?;
        let probe = levels::window_rows(setting.sensors, extent.largest_order, extent.block_rows);
        let sources = Sources::new(setting, extent.block_rows, probe)?;
        let engine = Engine { setting, sources: &sources, block_rows: extent.block_rows };
        let (whitening, origin) = engine.noise(&options.noise, extent.largest_order)?;
        let spaces = engine.spaces(&engine.spectra(&whitening)?, &whitening, origin);
        Ok(Self { records, setting, sources, extent, whitening, spaces })
    }

    /// The model of so many states; `None` where the block rows do not tell as many, or hold none.
    pub(crate) fn model(&self, order: usize) -> Option<SharedModel> {
        if order > self.extent.largest_order {
            return None;
        }
        let block_rows = self.extent.block_rows;
        let engine = Engine { setting: self.setting, sources: &self.sources, block_rows };
        let (observability, _) = self.spaces.common(order).ok()?;
        let found = engine.realised(self.records, &self.spaces, &self.whitening, &observability);
        found.ok().map(|found| found.model)
    }

    pub(crate) fn block_rows(&self) -> usize {
        self.extent.block_rows
    }
}

/// The records' covariances, and what is computed from them for one noise model or another.
struct Engine<'a> {
    setting: Setting<'a>,
    sources: &'a Sources,
    block_rows: usize,
}

/// The model of so many states.
struct Realised {
    model: SharedModel,
    realisation: Realisation,
    /// For each record, how well the next direction of excitation fits.
    ambiguities: Vec<f64>,
}

impl Engine<'_> {
    /// The model of so many states, in the sensors' units.
    fn realised(
        &self,
        records: &[Record],
        spaces: &Spaces,
        whitening: &Whitening,
        observability: &DMatrix<f64>,
    ) -> Result<Realised, ReconstructError> {
        let setting = self.setting;
        let realisation = realise(observability, setting.sensors)?;
        let (mut b, mut feedthrough, mut ambiguities) = (Vec::new(), Vec::new(), Vec::new());
        for j in 0..records.len() {
            let annihilators = spaces.annihilators(j, observability.ncols()).into_owned();
            let excited = input_direction(
                &annihilators,
                observability,
                setting.sensors,
                setting.direct_path,
            )?;
            b.push(excited.b);
            feedthrough.extend(excited.d.map(|d| self.in_sensor_units(d, whitening)));
            ambiguities.push(excited.ambiguity);
        }
        let mut c = realisation.c.clone();
        for (mut row, deviation) in c.row_iter_mut().zip(self.deviations(whitening)) {
            row *= deviation;
        }
        let model = SharedModel {
            a: realisation.a.clone(),
            c,
            b,
            feedthrough: (!feedthrough.is_empty()).then_some(feedthrough),
            period: records[0].period(),
        };
        Ok(Realised { model, realisation, ambiguities })
    }

    /// The levels of a whitening in the sensors' units.
    fn deviations(&self, whitening: &Whitening) -> Vec<f64> {
        whitening.deviations().iter().zip(&self.sources.units).map(|(s, unit)| s * unit).collect()
    }

    /// The whitening of a noise model, its levels estimated for so many states if need be.
    fn noise(
        &self,
        model: &NoiseModel,
        order: usize,
    ) -> Result<(Whitening, NoiseOrigin), ReconstructError> {
        let units = &self.sources.units;
        match model {
            NoiseModel::Estimated | NoiseModel::White => self.estimated(order, 1, |_| true),
            NoiseModel::Levels(levels) => {
                let levels = levels.iter().zip(units).map(|(level, unit)| level / unit).collect();
                Ok((Whitening::Levels(levels), NoiseOrigin::Given))
            }
            NoiseModel::Quiet(quiet) => Ok((
                quiet_whitening(self.setting, quiet, units, self.block_rows)?,
                NoiseOrigin::Quiet { samples: quiet.samples() },
            )),
        }
    }

    /// Levels from some of the records.
    fn estimated(
        &self,
        order: usize,
        excitations: usize,
        used: impl Fn(usize) -> bool,
    ) -> Result<(Whitening, NoiseOrigin), ReconstructError> {
        let free = self.setting.sensors + 1 - excitations;
        let block_rows = levels::window_rows(free, order, self.block_rows);
        let signal = self.setting.signal_dimension(block_rows, order, excitations);
        let window = Window { block_rows, signal };
        let records = self.sources.records.iter().enumerate();
        let records: Vec<_> = records.filter(|(j, _)| used(*j)).map(|(_, source)| source).collect();
        let found = levels::estimate(&records, &self.sources.deviations, window)?;
        let origin = if found.rounding {
            NoiseOrigin::Rounding
        } else {
            NoiseOrigin::Estimated { rounds: found.rounds, converged: found.converged }
        };
        Ok((Whitening::Levels(found.deviations), origin))
    }

    /// Other levels where those of all records together don't make the noise flat, so that some record holds more than one excitation: those
    /// of the records that are flat on their own, or else those that more excitations lead to. `None` if the noise is flat or nothing makes it so.
    fn noise_of_several(
        &self,
        spectra: &[Eigen],
        order: usize,
    ) -> Result<Option<(Whitening, NoiseOrigin, Vec<Eigen>)>, ReconstructError> {
        let all = 0..spectra.len();
        if all.clone().all(|j| self.is_flat(j, &spectra[j], order, 1)) {
            return Ok(None);
        }
        let mut flat = Vec::with_capacity(spectra.len());
        for j in all.clone() {
            let (whitening, _) = self.estimated(order, 1, |other| other == j)?;
            flat.push(self.is_flat(j, &self.spectrum(j, &whitening)?, order, 1));
        }
        if flat.contains(&true) {
            let (whitening, origin) = self.estimated(order, 1, |j| flat[j])?;
            let spectra = self.spectra(&whitening)?;
            return Ok(Some((whitening, origin, spectra)));
        }
        for excitations in 2..self.setting.sensors {
            let (whitening, origin) = self.estimated(order, excitations, |_| true)?;
            let spectra = self.spectra(&whitening)?;
            if all.clone().all(|j| self.is_flat(j, &spectra[j], order, excitations)) {
                return Ok(Some((whitening, origin, spectra)));
            }
        }
        Ok(None)
    }

    /// Whether the noise directions of a record have the variance of white noise of these levels: none more than chance allows, half of
    /// them not much less. Records that the levels don't fit can make all but one sensor pass for noise, which leaves next to none in the rest.
    fn is_flat(&self, record: usize, spectrum: &Eigen, order: usize, excitations: usize) -> bool {
        /// The median is 0.9 in short records.
        const LEAST_MEDIAN: f64 = 0.4;
        let signal = self.setting.signal_dimension(self.block_rows, order, excitations);
        let edge = noise_edge(self.setting, self.block_rows, self.sources.columns[record]);
        let last = spectrum.values.len().checked_sub(signal + 1);
        last.is_some_and(|last| {
            spectrum.values[last] <= edge && spectrum.values[last / 2] >= LEAST_MEDIAN
        })
    }

    fn spectrum(&self, record: usize, whitening: &Whitening) -> Result<Eigen, ReconstructError> {
        let rows = self.block_rows * self.setting.sensors;
        whitening.spectrum(&self.sources.records[record].0, rows)
    }

    fn spectra(&self, whitening: &Whitening) -> Result<Vec<Eigen>, ReconstructError> {
        (0..self.sources.records.len()).map(|j| self.spectrum(j, whitening)).collect()
    }

    fn spaces(&self, spectra: &[Eigen], whitening: &Whitening, origin: NoiseOrigin) -> Spaces {
        let rows = self.block_rows * self.setting.sensors;
        let noise = rows - self.setting.signal_dimension(self.block_rows, 0, 1);
        let silent = |spectrum: &Eigen| match origin {
            // The levels are upper bounds of rounding errors.
            NoiseOrigin::Rounding => spectrum.values.iter().filter(|value| **value <= 1.0).count(),
            _ => 0,
        };
        Spaces {
            annihilators: spectra
                .iter()
                .map(|spectrum| whitening.annihilators(spectrum.vectors.clone()))
                .collect(),
            noise,
            silent: spectra.iter().map(silent).collect(),
            orthonormal: matches!(whitening, Whitening::Levels(_)),
        }
    }

    /// A vector of the sensors' readings in their own units.
    fn in_sensor_units(&self, mut readings: DVector<f64>, whitening: &Whitening) -> DVector<f64> {
        let deviations = whitening.deviations().iter().zip(&self.sources.units);
        for (reading, (deviation, unit)) in readings.iter_mut().zip(deviations) {
            *reading *= deviation * unit;
        }
        readings
    }
}

#[cfg(test)]
mod tests;
