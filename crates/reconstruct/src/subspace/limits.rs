//! What records and options must satisfy, and how many block rows they allow.

use super::options::{Options, OrderChoice};
use crate::model::record::check_compatible;
use crate::{Measurement, NoiseModel, Offsets, ReconstructError, Record, Trend};

/// Rows of the block-Hankel matrix beyond which accuracy no longer grows at 2000 samples.
const USEFUL_ROWS: usize = 96;

/// Columns wanted for each row: with fewer, noise and signal of a sample covariance mix.
const COLUMNS_PER_ROW: usize = 3;

/// What is done about constant offsets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Centring {
    /// The rows of the block-Hankel matrices are centred.
    Rows,
    /// Nothing: there are none.
    None,
}

/// Whether sensors read the excitation directly: then `d_j` is estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DirectPath {
    /// No sensor does, as of positions, angles and rates.
    Absent,
    /// Some do, as accelerometers.
    Present,
}

/// J records of m sensors that fit together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting<'a> {
    pub(super) records: &'a [Record],
    pub(super) quiet: Option<&'a Record>,
    pub(super) sensors: usize,
    pub(super) centring: Centring,
    pub(super) direct_path: DirectPath,
    /// For each record the inputs that were recorded; empty if there are none at all.
    pub(super) known: &'a [Vec<Vec<f64>>],
}

/// The number of block rows, and the orders that it can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) block_rows: usize,
    pub(super) largest_order: usize,
}

impl<'a> Setting<'a> {
    /// Checks records and noise model.
    pub(super) fn new(
        records: &'a [Record],
        options: &'a Options,
    ) -> Result<Self, ReconstructError> {
        let sensors = records.first().map_or(0, |first| first.channels().len());
        if records.len() * sensors.saturating_sub(1) <= sensors {
            return Err(ReconstructError::NotIdentifiable { records: records.len(), sensors });
        }
        check_compatible(records)?;
        refuse_dead(records)?;
        refuse_doubles(records)?;
        let quiet = match &options.noise {
            NoiseModel::Estimated | NoiseModel::White => None,
            NoiseModel::Levels(levels) => {
                check_levels(&records[0], levels)?;
                None
            }
            NoiseModel::Quiet(quiet) => {
                check_compatible(&[records[0].clone(), quiet.clone()])?;
                refuse_dead(std::slice::from_ref(quiet))?;
                Some(quiet)
            }
        };
        options.measurement.check(records)?;
        let Measurement { offsets, trend, feedthrough_sensors, known_inputs: known } =
            &options.measurement;
        let offset = matches!(offsets, Offsets::Free | Offsets::PriorDeviation(_));
        let centring =
            if offset || *trend == Trend::Linear { Centring::Rows } else { Centring::None };
        let direct = !feedthrough_sensors.is_empty();
        let direct_path = if direct { DirectPath::Present } else { DirectPath::Absent };
        Ok(Self { records, quiet, sensors, centring, direct_path, known })
    }

    /// `J (m - 1) - m`, at least 1.
    fn surplus(&self) -> usize {
        self.records.len() * (self.sensors - 1) - self.sensors
    }

    /// The fewest block rows that tell so many states: `L >= (J - 1) n / (J (m - 1) - m)`, and one more than n for the shift invariance.
    fn rows_for_order(&self, order: usize) -> usize {
        ((self.records.len() - 1) * order).div_ceil(self.surplus()).max(order + 1)
    }

    /// The largest order that so many block rows tell.
    fn order_for_rows(&self, block_rows: usize) -> usize {
        (block_rows * self.surplus() / (self.records.len() - 1)).min(block_rows.saturating_sub(1))
    }

    /// The samples that so many block rows need: as many columns as rows, known inputs included, and one for the mean.
    fn samples_for_rows(&self, block_rows: usize) -> usize {
        let inputs = self.known.iter().map(Vec::len).max().unwrap_or(0);
        (self.sensors + inputs + 1) * block_rows - 1 + usize::from(self.centring == Centring::Rows)
    }

    /// Dimension of the signal with `excitations` of them in a record: n for the state, and one for each sample of an excitation that L
    /// samples of the sensors read.
    pub(super) fn signal_dimension(
        &self,
        block_rows: usize,
        order: usize,
        excitations: usize,
    ) -> usize {
        let read = match self.direct_path {
            DirectPath::Absent => block_rows - 1,
            DirectPath::Present => block_rows,
        };
        excitations * read + order
    }

    /// The block rows by rule or as asked for, and the largest order to look at.
    pub(super) fn extent(
        &self,
        order: OrderChoice,
        asked: Option<usize>,
    ) -> Result<Extent, ReconstructError> {
        let wanted = match order {
            OrderChoice::Fixed(order) | OrderChoice::Gap { largest: order } => order,
        };
        if wanted == 0 {
            return Err(ReconstructError::InvalidOrder { order: wanted });
        }
        let needed = self.rows_for_order(wanted);
        let (shortest, samples) = self.shortest();
        let block_rows = if let Some(block_rows) = asked {
            let too_few = match order {
                OrderChoice::Fixed(_) => block_rows < needed,
                OrderChoice::Gap { .. } => self.order_for_rows(block_rows) == 0,
            };
            if too_few {
                return Err(ReconstructError::TooFewBlockRows {
                    block_rows,
                    needed: needed.max(2),
                    order: wanted,
                    records: self.records.len(),
                    sensors: self.sensors,
                });
            }
            block_rows
        } else {
            let allowed = (samples + 1) / (COLUMNS_PER_ROW * self.sensors + 1);
            let useful = (USEFUL_ROWS / self.sensors).max(needed);
            match order {
                OrderChoice::Fixed(_) => useful.min(allowed).max(needed),
                OrderChoice::Gap { .. } => useful.min(allowed).max(self.rows_for_order(1)),
            }
        };
        if samples < self.samples_for_rows(block_rows) {
            // With block rows by rule it is the order that asks for too much.
            let largest = self.largest_order(samples);
            let fixed = matches!(order, OrderChoice::Fixed(_)) && asked.is_none() && largest > 0;
            return Err(if fixed {
                ReconstructError::OrderTooHigh {
                    order: wanted,
                    record: shortest.name().to_owned(),
                    samples,
                    needed: self.samples_for_rows(block_rows),
                    largest,
                    sensors: self.sensors,
                }
            } else {
                self.too_short(shortest, block_rows)
            });
        }
        Ok(Extent { block_rows, largest_order: wanted.min(self.order_for_rows(block_rows)) })
    }

    fn too_short(&self, record: &Record, block_rows: usize) -> ReconstructError {
        ReconstructError::RecordTooShort {
            record: record.name().to_owned(),
            samples: record.samples(),
            needed: self.samples_for_rows(block_rows),
            block_rows,
            sensors: self.sensors,
        }
    }

    fn shortest(&self) -> (&'a Record, usize) {
        let all = self.records.iter().chain(self.quiet);
        let shortest = all.min_by_key(|record| record.samples()).unwrap_or(&self.records[0]);
        (shortest, shortest.samples())
    }

    /// The largest order that so many samples tell.
    fn largest_order(&self, samples: usize) -> usize {
        (1..samples)
            .take_while(|&order| self.samples_for_rows(self.rows_for_order(order)) <= samples)
            .last()
            .unwrap_or(0)
    }
}

/// Whether all samples are the same number.
fn is_constant(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[0].total_cmp(&pair[1]).is_eq())
}

fn refuse_dead(records: &[Record]) -> Result<(), ReconstructError> {
    for record in records {
        let zero = |values: &Vec<f64>| values.iter().all(|value| value.abs() <= 0.0);
        if record.channels().iter().all(|channel| zero(&channel.values)) {
            return Err(ReconstructError::ZeroRecord { record: record.name().to_owned() });
        }
        if let Some(dead) = record.channels().iter().find(|channel| is_constant(&channel.values)) {
            return Err(ReconstructError::ConstantChannel {
                record: record.name().to_owned(),
                channel: dead.name.clone(),
                value: dead.values[0],
            });
        }
    }
    Ok(())
}

/// Two channels that are proportional, with the same factor in every record: one sensor, read twice.
fn refuse_doubles(records: &[Record]) -> Result<(), ReconstructError> {
    let channels = records[0].channels();
    for (first, second) in (0..channels.len()).flat_map(|b| (0..b).map(move |a| (a, b))) {
        let pair = |record: &Record| {
            proportion(&record.channels()[first].values, &record.channels()[second].values)
        };
        let factors: Option<Vec<f64>> = records.iter().map(pair).collect();
        let Some(factors) = factors else { continue };
        if factors.iter().all(|factor| (factor - factors[0]).abs() <= SAME * factors[0].abs()) {
            return Err(ReconstructError::DuplicatedChannel {
                first: channels[first].name.clone(),
                second: channels[second].name.clone(),
                factor: factors[0],
            });
        }
    }
    Ok(())
}

/// Signals that differ by less, relative to themselves, are the same signal written twice: copies differ by rounding and by the digits of a
/// file, sensors by their noise.
const SAME: f64 = 1e-9;

/// The factor that turns one signal into another, if one does; constant parts are left out of account.
fn proportion(x: &[f64], y: &[f64]) -> Option<f64> {
    let deviations = |signal: &[f64]| {
        let largest = signal.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let mean = signal.iter().map(|value| value / largest).sum::<f64>() / signal.len() as f64;
        (largest, signal.iter().map(|value| value / largest - mean).collect::<Vec<_>>())
    };
    let ((x_scale, x), (y_scale, y)) = (deviations(x), deviations(y));
    let xx: f64 = x.iter().map(|x| x * x).sum();
    let factor = x.iter().zip(&y).map(|(x, y)| x * y).sum::<f64>() / xx;
    let norm: f64 = y.iter().map(|y| y * y).sum();
    let rest: f64 = x.iter().zip(&y).map(|(x, y)| (y - factor * x).powi(2)).sum();
    (rest <= SAME * SAME * norm).then_some(factor * (y_scale / x_scale))
}

fn check_levels(record: &Record, levels: &[f64]) -> Result<(), ReconstructError> {
    let sensors = record.channels().len();
    if levels.len() != sensors {
        return Err(ReconstructError::NoiseLevelCount { found: levels.len(), sensors });
    }
    let bad = levels.iter().position(|level| !(level.is_finite() && *level > 0.0));
    bad.map_or(Ok(()), |index| {
        Err(ReconstructError::InvalidNoiseLevel {
            channel: record.channels()[index].name.clone(),
            value: levels[index],
        })
    })
}

#[cfg(test)]
mod tests;
