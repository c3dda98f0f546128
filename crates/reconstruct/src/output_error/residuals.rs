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
use super::spectra::Spectrum;
use crate::likelihood::cost::accumulate::{Scalars, accumulate};
use crate::likelihood::cost::inverse_factor::inverse_factor;
use crate::likelihood::cost::record_system::RecordSystem;
use crate::likelihood::cost::resolvent::Resolvent;
use crate::likelihood::cost::spectrum::{Entry, RecordSpectrum};
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
    transient: DVector<f64>,
    /// The drift of each sensor; empty where they have none.
    drift: Vec<f64>,
    /// The sensors that are late.
    late: Vec<usize>,
    /// What each of them reads in its first samples beside the rest, those of the first such sensor first.
    first_samples: Vec<f64>,
}

/// What a late sensor reads in so many seconds may be what was before the record.
const BEFORE_THE_RECORD: f64 = 0.15;
/// Samples that may be, at most.
const MOST_FIRST_SAMPLES: usize = 6;
/// Directions below this share of the largest one are rounding errors; the squares of singular values are compared.
const RANK_TOLERANCE: f64 = 1e-12;

/// A row of (A, B | C, D) or (t | delta), and the scalar that it multiplies.
type Cell = (usize, usize);

/// Sums of a record; `None` where something is not finite.
///
/// `free_lags` are the cells of the lags that are estimated.
pub(super) fn sums(
    matrices: &Matrices,
    spectrum: &Spectrum,
    weighting: &Weighting,
    free_lags: &[usize],
) -> Option<RecordSums> {
    let signals = Signals::new(matrices, spectrum, free_lags);
    let record = signals.spectrum(matrices, spectrum, weighting, None);
    let nothing = Nuisances {
        transient: DVector::zeros(signals.states),
        drift: Vec::new(),
        late: Vec::new(),
        first_samples: Vec::new(),
    };
    let first = accumulated(&signals.system(matrices, &nothing), &record)?;
    let own = signals.nuisance_cells();
    let factor = inverse_factor(&first.gram_of(&own), RANK_TOLERANCE)?;
    let right = DVector::from_iterator(own.len(), own.iter().map(|&cell| first.descent(cell)));
    let best = factor.tr_mul(&(&factor * right));
    let nuisances = Nuisances {
        transient: best.rows(0, signals.states).into_owned(),
        drift: best.iter().skip(signals.states).take(signals.drifts()).copied().collect(),
        late: signals.late.clone(),
        first_samples: best.iter().skip(signals.states + signals.drifts()).copied().collect(),
    };
    let record = if signals.free_sensors.is_empty() {
        record
    } else {
        // How the fit moves with a lag follows from what the model says of the sensor: from what the sensor reads, its noise would count as known.
        let left = residuals(matrices, spectrum, &nuisances);
        signals.spectrum(matrices, spectrum, weighting, Some(&left))
    };
    let sums = accumulated(&signals.system(matrices, &nuisances), &record)?;

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
            let first = nuisances.first(s, z);
            left[(s, k)] = measured - state - direct - drift - first;
        }
    }
    left
}

/// The known signals of a record, in the order in which they enter: the transient, the inputs, the ramp, and a signal for each lag that is free.
struct Signals {
    states: usize,
    sensors: usize,
    inputs: usize,
    drift: bool,
    /// Sensors with a lag, and how many first samples each has.
    late: Vec<usize>,
    first_samples: usize,
    free_sensors: Vec<usize>,
    free_inputs: Vec<usize>,
}

impl Signals {
    fn new(matrices: &Matrices, spectrum: &Spectrum, free_lags: &[usize]) -> Self {
        let sizes = matrices.sizes();
        let is_free = |cell: usize| free_lags.contains(&cell);
        let is_late = |s: &usize| matrices.sensor_lags[*s] != 0.0 || is_free(sizes.sensor_lag(*s));
        let late: Vec<usize> = (0..sizes.sensors).filter(is_late).collect();
        let samples = spectrum.samples_in(BEFORE_THE_RECORD).clamp(1, MOST_FIRST_SAMPLES);
        Self {
            states: sizes.states,
            sensors: sizes.sensors,
            inputs: sizes.inputs,
            drift: !spectrum.ramp.is_empty(),
            // As many before the beginning, which is the end, as behind it.
            first_samples: if late.is_empty() { 0 } else { 2 * samples },
            late,
            free_sensors: (0..sizes.sensors).filter(|&s| is_free(sizes.sensor_lag(s))).collect(),
            free_inputs: (0..sizes.inputs).filter(|&k| is_free(sizes.input_lag(k))).collect(),
        }
    }

    fn count(&self) -> usize {
        self.first_lag() + self.free_sensors.len() + self.free_inputs.len()
    }

    /// The first signal of first samples.
    fn first_sample(&self) -> usize {
        1 + self.inputs + usize::from(self.drift)
    }

    /// The first signal of a free lag.
    fn first_lag(&self) -> usize {
        self.first_sample() + self.first_samples
    }

    /// Drifts that are estimated.
    fn drifts(&self) -> usize {
        if self.drift { self.sensors } else { 0 }
    }

    /// The scalar of a signal: behind the states and the excitation, of which there is none.
    fn scalar(&self, signal: usize) -> usize {
        self.states + 1 + signal
    }

    fn nuisance_cells(&self) -> Vec<Cell> {
        let transient = (0..self.states).map(|row| (row, self.scalar(0)));
        let ramp = self.scalar(1 + self.inputs);
        let drifts = (0..self.drifts()).map(|s| (self.states + s, ramp));
        let first = self.late.iter().flat_map(|&s| {
            (0..self.first_samples)
                .map(move |sample| (self.states + s, self.scalar(self.first_sample() + sample)))
        });
        transient.chain(drifts).chain(first).collect()
    }

    /// A, B, C, D by columns; then one cell for each free lag of a sensor, and all rows for each free lag of an input.
    fn cells(&self) -> Vec<Cell> {
        let (n, m) = (self.states, self.sensors);
        let columns = |rows: std::ops::Range<usize>, scalars: Vec<usize>| {
            scalars.into_iter().flat_map(move |scalar| rows.clone().map(move |row| (row, scalar)))
        };
        let states: Vec<usize> = (0..n).collect();
        let inputs: Vec<usize> = (0..self.inputs).map(|k| self.scalar(1 + k)).collect();
        let mut cells: Vec<Cell> = columns(0..n, states.clone()).collect();
        cells.extend(columns(0..n, inputs.clone()));
        cells.extend(columns(n..n + m, states));
        cells.extend(columns(n..n + m, inputs));
        let lags = self.first_lag();
        for (place, &s) in self.free_sensors.iter().enumerate() {
            cells.push((n + s, self.scalar(lags + place)));
        }
        let lags = lags + self.free_sensors.len();
        for place in 0..self.free_inputs.len() {
            cells.extend((0..n + m).map(|row| (row, self.scalar(lags + place))));
        }
        cells
    }

    /// How those cells move with the cells of the matrices.
    fn moves(&self, matrices: &Matrices) -> DMatrix<f64> {
        let sizes = matrices.sizes();
        let own = sizes.sensor_lag(0);
        let mut moves = DMatrix::zeros(self.cells().len(), sizes.count());
        moves.view_mut((0, 0), (own, own)).fill_with_identity();
        for (place, &s) in self.free_sensors.iter().enumerate() {
            moves[(own + place, sizes.sensor_lag(s))] = 1.0;
        }
        let mut row = own + self.free_sensors.len();
        for &input in &self.free_inputs {
            let into = matrices.b.column(input);
            for entry in into.iter().chain(matrices.d.column(input).iter()) {
                moves[(row, sizes.input_lag(input))] = *entry;
                row += 1;
            }
        }
        moves
    }

    /// The record as the likelihood's sums take it; `left` is what the model leaves of it, if that is known.
    fn spectrum(
        &self,
        matrices: &Matrices,
        spectrum: &Spectrum,
        weighting: &Weighting,
        left: Option<&DMatrix<Complex<f64>>>,
    ) -> RecordSpectrum {
        let count = spectrum.z.len();
        let mut entries = vec![Entry::State];
        entries.extend((0..self.inputs).map(|_| Entry::StateAndFeedthrough));
        entries.resize(self.count(), Entry::Sensors);
        let mut y = Vec::with_capacity(count * self.sensors);
        let mut factors = Vec::with_capacity(count * entries.len());
        for (k, &frequency) in spectrum.frequencies.iter().enumerate() {
            let of_sensor =
                |s: usize| spectrum.y[(s, k)] * turn(-frequency, matrices.sensor_lags[s]);
            let of_input =
                |input: usize| spectrum.u[(input, k)] * turn(frequency, matrices.input_lags[input]);
            y.extend((0..self.sensors).map(of_sensor));
            factors.push(spectrum.z[k]);
            factors.extend((0..self.inputs).map(of_input));
            factors.extend(spectrum.ramp.get(k));
            let mut sample = before(spectrum.z[k], self.first_samples / 2);
            for _ in 0..self.first_samples {
                factors.push(sample);
                sample /= spectrum.z[k];
            }
            // More lag turns what the model says of a sensor back against what it reads, and an input against what moved.
            let slope = Complex::new(0.0, -frequency);
            let modelled =
                |s: usize| of_sensor(s) - left.map_or(Complex::ZERO, |left| left[(s, k)]);
            factors.extend(self.free_sensors.iter().map(|&s| slope * modelled(s)));
            factors.extend(self.free_inputs.iter().map(|&input| slope * of_input(input)));
        }
        RecordSpectrum {
            z: spectrum.z.clone(),
            weight: spectrum.weight.clone(),
            y,
            entries,
            factors,
            precision: Some(weighting.precision.clone()),
            power: None,
            offset_variance: vec![0.0; self.sensors],
            starts_at_zero: false,
            missing: None,
        }
    }

    fn system(&self, matrices: &Matrices, nuisances: &Nuisances) -> RecordSystem {
        let (n, m) = (self.states, self.sensors);
        let of = |into_state: &[f64], into_sensors: &[f64]| {
            let mut all = vec![0.0; n + m];
            all[..into_state.len()].copy_from_slice(into_state);
            all[n..n + into_sensors.len()].copy_from_slice(into_sensors);
            all
        };
        let mut coefficients = vec![of(nuisances.transient.as_slice(), &[])];
        let column =
            |matrix: &DMatrix<f64>, k: usize| matrix.column(k).iter().copied().collect::<Vec<_>>();
        coefficients
            .extend((0..self.inputs).map(|k| of(&column(&matrices.b, k), &column(&matrices.d, k))));
        if self.drift {
            coefficients.push(of(&[], &nuisances.drift));
        }
        for sample in 0..self.first_samples {
            let mut all = vec![0.0; n + m];
            for (place, &s) in self.late.iter().enumerate() {
                let first = nuisances.first_samples.get(place * self.first_samples + sample);
                all[n + s] = first.copied().unwrap_or_default();
            }
            coefficients.push(all);
        }
        coefficients.resize(self.count(), vec![0.0; n + m]);
        RecordSystem {
            a: matrices.a.clone(),
            c: matrices.c.clone(),
            b: DVector::zeros(n),
            d: DVector::zeros(m),
            gain: DVector::zeros(n),
            coefficients,
            variances: vec![1.0; m],
        }
    }
}

impl Nuisances {
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

fn accumulated(system: &RecordSystem, record: &RecordSpectrum) -> Option<Sums> {
    let sums = accumulate(record, system, Scalars::Estimated, false, 1);
    sums.cost.is_finite().then_some(sums)
}

/// The transform of an impulse so many samples before the beginning.
fn before(z: Complex<f64>, samples: usize) -> Complex<f64> {
    (0..samples).fold(Complex::from(1.0), |product, _| product * z)
}

/// What a lag of so many seconds does to a spectrum.
fn turn(frequency: f64, lag: f64) -> Complex<f64> {
    if lag == 0.0 { Complex::new(1.0, 0.0) } else { Complex::from_polar(1.0, -frequency * lag) }
}

#[cfg(test)]
mod tests;
