//! What is computed from the records' covariances for one noise model or another: levels, spectra, subspaces, and the model of so many states.

use nalgebra::{DMatrix, DVector};

use super::dense::Eigen;
use super::evidence::NoiseOrigin;
use super::excitation::noise_edge;
use super::input_direction::input_direction;
use super::levels::{self, Window};
use super::limits::Setting;
use super::order::Spaces;
use super::realisation::{Realisation, realise};
use super::sources::{Sources, quiet_whitening};
use super::whitening::Whitening;
use crate::{NoiseModel, ReconstructError, Record, SharedModel};

/// The records' covariances, and what is computed from them for one noise model or another.
pub(super) struct Engine<'a> {
    pub(super) setting: Setting<'a>,
    pub(super) sources: &'a Sources,
    pub(super) block_rows: usize,
}

/// The model of so many states.
pub(super) struct Realised {
    pub(super) model: SharedModel,
    pub(super) realisation: Realisation,
    /// For each record, how well the next direction of excitation fits.
    pub(super) ambiguities: Vec<f64>,
}

impl Engine<'_> {
    /// The model of so many states, in the sensors' units.
    pub(super) fn realised(
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
    pub(super) fn deviations(&self, whitening: &Whitening) -> Vec<f64> {
        whitening.deviations().iter().zip(&self.sources.units).map(|(s, unit)| s * unit).collect()
    }

    /// The whitening of a noise model, its levels estimated for so many states if need be.
    pub(super) fn noise(
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
    pub(super) fn noise_of_several(
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

    pub(super) fn spectra(&self, whitening: &Whitening) -> Result<Vec<Eigen>, ReconstructError> {
        (0..self.sources.records.len()).map(|j| self.spectrum(j, whitening)).collect()
    }

    pub(super) fn spaces(
        &self,
        spectra: &[Eigen],
        whitening: &Whitening,
        origin: NoiseOrigin,
    ) -> Spaces {
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
