//! The records that everything is measured on: the paper's aircraft, excited through one surface,
//! made block by block.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use lti::{Discrete, StateSpace};
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use crate::TaskError;
use crate::shared::paper_aircraft::{PaperAircraft, SEEDS, SURFACES};

const PART: &str = "records";

/// Samples made at a time.
const BLOCK: usize = 1 << 16;

/// Sideslip, roll rate and yaw rate.
pub(crate) type Channels = [Vec<f64>; 3];

/// The surface that moves, as the number of the system's input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Surface {
    Aileron,
    Rudder,
}

impl Surface {
    pub(crate) const ALL: [Self; 2] = [Self::Aileron, Self::Rudder];

    pub(crate) fn name(self) -> &'static str {
        SURFACES[self as usize]
    }
}

/// A record from rest that goes on for as long as samples are asked for. White Gaussian excitation
/// of unit variance, with the seeds of the paper's records.
pub(crate) struct EndlessRecord {
    system: StateSpace<Discrete>,
    state: DVector<f64>,
    random: ChaCha8Rng,
}

impl EndlessRecord {
    pub(crate) fn new(surface: Surface) -> Result<Self, TaskError> {
        let system = PaperAircraft::new()?.driven_by(surface as usize)?;
        let state = DVector::zeros(system.order());
        Ok(Self { system, state, random: ChaCha8Rng::seed_from_u64(SEEDS[surface as usize]) })
    }

    /// The next samples.
    pub(crate) fn next(&mut self, samples: usize) -> Result<Channels, TaskError> {
        let random = &mut self.random;
        let excitation = DMatrix::from_fn(1, samples, |_, _| StandardNormal.sample(random));
        let simulation = self
            .system
            .simulate(&excitation, Some(&self.state))
            .map_err(TaskError::computation(PART))?;
        self.state = simulation.states.column(samples).into_owned();
        let channel = |row| simulation.outputs.row(row).iter().copied().collect();
        Ok([channel(0), channel(1), channel(2)])
    }
}

/// A noise-free record.
pub(crate) fn record(surface: Surface, samples: usize) -> Result<Channels, TaskError> {
    let mut record = EndlessRecord::new(surface)?;
    let mut channels: Channels = Default::default();
    for block in blocks(samples) {
        for (channel, part) in channels.iter_mut().zip(record.next(block)?) {
            channel.extend(part);
        }
    }
    Ok(channels)
}

/// Adds white Gaussian noise of a hundredth of each channel's rms.
pub(crate) fn with_noise(mut channels: Channels) -> Channels {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    for channel in &mut channels {
        let square = channel.iter().map(|x| x * x).sum::<f64>() / channel.len() as f64;
        let level = 0.01 * square.sqrt();
        for x in channel {
            let noise: f64 = StandardNormal.sample(&mut random);
            *x += level * noise;
        }
    }
    channels
}

/// Writes channels as raw little-endian doubles, one file each, and returns the files' names as
/// text.
pub(crate) fn write(
    folder: &Path,
    name: &str,
    channels: &[Vec<f64>],
) -> Result<Vec<String>, TaskError> {
    let mut files = Vec::new();
    for (index, channel) in channels.iter().enumerate() {
        let path = folder.join(format!("{name}-{index}.f64"));
        let mut file = create(&path)?;
        put(&mut file, &path, channel)?;
        files.push(path.to_string_lossy().into_owned());
    }
    Ok(files)
}

/// Writes a noise-free record of sideslip and roll rate, made block by block, so that its length is
/// not limited by the memory.
pub(crate) fn write_long(
    folder: &Path,
    samples: usize,
    mut progress: impl FnMut(usize),
) -> Result<[PathBuf; 2], TaskError> {
    let paths = ["input.f64", "output.f64"].map(|name| folder.join(name));
    let mut files = [create(&paths[0])?, create(&paths[1])?];
    let mut record = EndlessRecord::new(Surface::Aileron)?;
    for block in blocks(samples) {
        let channels = record.next(block)?;
        for ((file, path), channel) in files.iter_mut().zip(&paths).zip(&channels) {
            put(file, path, channel)?;
        }
        progress(block);
    }
    for (file, path) in files.iter_mut().zip(&paths) {
        file.flush().map_err(|source| TaskError::io(path, source))?;
    }
    Ok(paths)
}

fn create(path: &Path) -> Result<BufWriter<File>, TaskError> {
    File::create(path).map(BufWriter::new).map_err(|source| TaskError::io(path, source))
}

fn put(file: &mut BufWriter<File>, path: &Path, channel: &[f64]) -> Result<(), TaskError> {
    let written = channel.iter().try_for_each(|x| file.write_all(&x.to_le_bytes()));
    written.and_then(|()| file.flush()).map_err(|source| TaskError::io(path, source))
}

/// So many samples in blocks.
fn blocks(samples: usize) -> impl Iterator<Item = usize> {
    (0..samples).step_by(BLOCK).map(move |from| BLOCK.min(samples - from))
}

#[cfg(test)]
mod tests;
