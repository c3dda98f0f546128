//! From samples to covariances, in units that neither overflow nor underflow.

use hankel::{Gram, Layout, Missing, Options};
use nalgebra::DMatrix;

use super::dense::{Eigen, eigen, eigenvalues};
use super::factor::triangle;
use super::limits::{Centring, Setting};
use super::whitening::{Source, Whitening};
use crate::model::record::rms;
use crate::{Channel, ReconstructError, Record};

/// Below this ratio of the smallest to the largest eigenvalue a covariance in double precision no longer shows noise, but its own rounding errors.
const DYNAMIC_RANGE: f64 = 1e-10;

/// The records as covariances of stacked sensors.
pub(super) struct Sources {
    /// One for each record, with its weight: the number of columns.
    pub(super) records: Vec<(Source, f64)>,
    /// The number of columns of each record's block-Hankel matrix.
    pub(super) columns: Vec<usize>,
    /// The deviation of each sensor over all records.
    pub(super) deviations: Vec<f64>,
    /// What each sensor was divided by: a power of two.
    pub(super) units: Vec<f64>,
}

impl Sources {
    /// Covariances of so many block rows. Whether their triangles are needed shows in the first `probe` block rows.
    pub(super) fn new(
        setting: Setting<'_>,
        block_rows: usize,
        probe: usize,
    ) -> Result<Self, ReconstructError> {
        let units = units(setting);
        let grams = setting
            .records
            .iter()
            .map(|record| gram(record, &units, block_rows, setting.centring))
            .collect::<Result<Vec<Gram>, _>>()?;
        let columns: Vec<usize> = grams.iter().map(Gram::rows).collect();
        let mut covariances = grams.iter().map(covariance).collect::<Result<Vec<_>, _>>()?;
        let mut explained = false;
        for (j, inputs) in setting.known.iter().enumerate().filter(|(_, inputs)| !inputs.is_empty())
        {
            covariances[j] = without_inputs(setting, &units, block_rows, j, inputs)?;
            explained = true;
        }
        let deviations = deviations(&covariances, setting.sensors);
        let rows = probe * setting.sensors;
        let whitening = Whitening::Levels(deviations.clone());
        let mut noisy = true;
        for covariance in &covariances {
            let source = Source::Covariance(covariance.view((0, 0), (rows, rows)).into_owned());
            let values = whitening.values(&source, rows)?;
            noisy &= values[0] > DYNAMIC_RANGE * values[rows - 1];
        }
        // The triangles know nothing of inputs.
        let sources: Vec<Source> = if noisy || explained {
            covariances.into_iter().map(Source::Covariance).collect()
        } else {
            grams.iter().map(triangle).map(Source::Triangle).collect()
        };
        let weights = columns.iter().map(|columns| *columns as f64);
        let records = sources.into_iter().zip(weights).collect();
        Ok(Self { records, columns, deviations, units })
    }
}

/// The covariance of a record without what L samples of its known inputs explain: `G_yy - G_yw G_ww^+ G_wy`.
fn without_inputs(
    setting: Setting<'_>,
    units: &[f64],
    block_rows: usize,
    record: usize,
    inputs: &[Vec<f64>],
) -> Result<DMatrix<f64>, ReconstructError> {
    /// Directions in which the inputs vary by less than this part of the largest variance are left alone: they may be rounding errors.
    const SMALL: f64 = 1e-10;
    let source = &setting.records[record];
    let names = (0..inputs.len()).map(|index| format!("known input {index}"));
    let known = names.zip(inputs).map(|(name, values)| Channel::new(name, values.clone()));
    let channels = source.marked().into_iter().chain(known).collect();
    let all = Record::with_missing(source.name(), source.period(), channels)?;
    let scales = inputs.iter().map(|input| rms(input));
    let units: Vec<f64> = units.iter().copied().chain(scales).collect();
    let gram = gram(&all, &units, block_rows, setting.centring)?;
    let matrix = gram.matrix().map_err(failed)?;
    let (m, c) = (setting.sensors, units.len());
    let (sensors, known): (Vec<usize>, Vec<usize>) =
        (0..matrix.nrows()).partition(|row| row % c < m);
    let mixed = matrix.select_rows(&sensors).select_columns(&known);
    let Eigen { values, vectors } = eigen(&matrix.select_rows(&known).select_columns(&known))?;
    let mut left = matrix.select_rows(&sensors).select_columns(&sensors);
    let largest = values.last().copied().unwrap_or(0.0);
    let mut explained = 0;
    for (value, vector) in values.iter().zip(vectors.column_iter()) {
        if *value > SMALL * largest {
            let along = &mixed * vector;
            left.ger(-1.0 / value, &along, &along, 1.0);
            explained += 1;
        }
    }
    let free = gram.rows().saturating_sub(explained).max(1) as f64;
    Ok(left / free)
}

/// The whitening that a quiet record gives: its covariance R replaces `I x diag s^2`.
pub(super) fn quiet_whitening(
    setting: Setting<'_>,
    quiet: &Record,
    units: &[f64],
    block_rows: usize,
) -> Result<Whitening, ReconstructError> {
    /// A covariance with a smaller ratio of eigenvalues is singular up to rounding errors.
    const SINGULAR: f64 = 1e-13;
    let covariance = covariance(&gram(quiet, units, block_rows, setting.centring)?)?;
    let rows = covariance.nrows();
    let deviations = deviations(std::slice::from_ref(&covariance), setting.sensors);
    let scaled = DMatrix::from_fn(rows, rows, |i, k| {
        covariance[(i, k)] / (deviations[i % setting.sensors] * deviations[k % setting.sensors])
    });
    let values = eigenvalues(&scaled)?;
    let floor = SINGULAR * values[rows - 1];
    let silent = || ReconstructError::SilentRecord {
        record: quiet.name().to_owned(),
        rank: values.iter().filter(|value| **value > floor).count(),
        rows,
    };
    if values[0].is_nan() || values[0] <= floor {
        return Err(silent());
    }
    let mut lower = scaled.cholesky().ok_or_else(silent)?.unpack();
    for (i, mut row) in lower.row_iter_mut().enumerate() {
        row *= deviations[i % setting.sensors];
    }
    Ok(Whitening::Factor { lower, deviations })
}

/// A power of two near each sensor's largest sample: dividing by it does not round.
fn units(setting: Setting<'_>) -> Vec<f64> {
    /// Beyond it powers of two and their inverses are no normal numbers.
    const LARGEST_EXPONENT: f64 = 1000.0;
    let largest = |sensor: usize| {
        let records = setting.records.iter();
        let samples = records.flat_map(|record| &record.channels()[sensor].values);
        samples.fold(0.0, |largest: f64, sample| largest.max(sample.abs()))
    };
    (0..setting.sensors)
        .map(|sensor| {
            largest(sensor).log2().round().clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT).exp2()
        })
        .collect()
}

/// The Gram matrix of a record's windows that touch no missing sample; of all windows, with interpolated samples, where hardly any is left.
///
/// Row centring removes constants, but first they cost digits: large ones are taken away before.
fn gram(
    record: &Record,
    units: &[f64],
    block_rows: usize,
    centring: Centring,
) -> Result<Gram, ReconstructError> {
    let mut scaled: Vec<Vec<f64>> = record
        .channels()
        .iter()
        .zip(units)
        .map(|(channel, unit)| {
            let mut values: Vec<f64> = channel.values.iter().map(|value| value / unit).collect();
            if centring == Centring::Rows {
                remove_large_offset(&mut values);
            }
            values
        })
        .collect();
    let mut options = Options::default();
    if are_windows_left(record, block_rows) {
        for (index, values) in scaled.iter_mut().enumerate() {
            record.missing(index).iter().for_each(|&sample| values[sample] = f64::NAN);
        }
        options.missing = Missing::Gap;
    }
    let channels: Vec<&[f64]> = scaled.iter().map(Vec::as_slice).collect();
    let layout = Layout::block_hankel(channels.len(), block_rows).map_err(failed)?;
    let gram = hankel::gram(&layout, &channels, &options).map_err(failed)?;
    Ok(match centring {
        Centring::Rows => gram.centred(),
        Centring::None => gram,
    })
}

/// Whether samples are missing, and enough windows of so many block rows lie between them.
fn are_windows_left(record: &Record, block_rows: usize) -> bool {
    /// Windows for each row of the matrix: with fewer, interpolation errors do less harm than chance.
    const WINDOWS_PER_ROW: usize = 2;
    let sensors = record.channels().len();
    let mut edges: Vec<usize> =
        (0..sensors).flat_map(|channel| record.missing(channel)).copied().collect();
    if edges.is_empty() {
        return false;
    }
    edges.push(record.samples());
    edges.sort_unstable();
    edges.dedup();
    let starts = std::iter::once(0).chain(edges.iter().map(|edge| edge + 1));
    let windows: usize =
        starts.zip(&edges).map(|(start, end)| (end + 1).saturating_sub(start + block_rows)).sum();
    windows >= WINDOWS_PER_ROW * sensors * block_rows
}

/// `H H' / M` in double.
fn covariance(gram: &Gram) -> Result<DMatrix<f64>, ReconstructError> {
    let columns = gram.rows() as f64;
    Ok(gram.matrix().map_err(failed)? / columns)
}

fn failed(error: hankel::HankelError) -> ReconstructError {
    ReconstructError::Step { step: "covariance of a record", message: error.to_string() }
}

/// Subtracts the mean where it is so much larger than the deviations that the subtraction is exact; elsewhere it would round.
fn remove_large_offset(values: &mut [f64]) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let exact = |value: &f64| (value - mean).abs() <= 0.5 * mean.abs();
    if values.iter().all(exact) {
        values.iter_mut().for_each(|value| *value -= mean);
    }
}

/// The root of the mean variance of each sensor over records and block rows.
fn deviations(covariances: &[DMatrix<f64>], sensors: usize) -> Vec<f64> {
    let mut variances = vec![0.0; sensors];
    for covariance in covariances {
        for (i, variance) in covariance.diagonal().iter().enumerate() {
            variances[i % sensors] += variance;
        }
    }
    let count =
        covariances.iter().map(|covariance| covariance.nrows() / sensors).sum::<usize>() as f64;
    variances.into_iter().map(|variance| (variance / count).max(f64::MIN_POSITIVE).sqrt()).collect()
}

#[cfg(test)]
mod tests;
