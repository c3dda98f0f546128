//! The signals that are known in a record whose inputs were recorded, as the sums of the likelihood take them: the transient, the inputs, the ramp of a drift, the
//! first samples of late sensors, and one signal for each lag that is estimated.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::cells::Matrices;
use super::disturbance::Weighting;
use super::residuals::Nuisances;
use super::spectra::Spectrum;
use crate::likelihood::cost::missing::MissingSamples;
use crate::likelihood::cost::record_system::RecordSystem;
use crate::likelihood::cost::spectrum::{Entry, RecordSpectrum};

/// What a late sensor reads in so many seconds may be what was before the record.
const BEFORE_THE_RECORD: f64 = 0.15;
/// Samples that may be, at most.
const MOST_FIRST_SAMPLES: usize = 6;

/// A row of (A, B | C, D) or (t | delta), and the scalar that it multiplies.
type Cell = (usize, usize);

/// The known signals of a record, in the order in which they enter: the transient, the inputs, the ramp, and a signal for each lag that is free.
pub(super) struct KnownSignals {
    pub(super) states: usize,
    sensors: usize,
    inputs: usize,
    drift: bool,
    /// Sensors with a lag, and how many first samples each has.
    pub(super) late: Vec<usize>,
    first_samples: usize,
    pub(super) free_sensors: Vec<usize>,
    free_inputs: Vec<usize>,
}

impl KnownSignals {
    pub(super) fn new(matrices: &Matrices, spectrum: &Spectrum, free_lags: &[usize]) -> Self {
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
    pub(super) fn drifts(&self) -> usize {
        if self.drift { self.sensors } else { 0 }
    }

    /// The scalar of a signal: behind the states and the excitation, of which there is none.
    fn scalar(&self, signal: usize) -> usize {
        self.states + 1 + signal
    }

    pub(super) fn nuisance_cells(&self) -> Vec<Cell> {
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
    pub(super) fn cells(&self) -> Vec<Cell> {
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
    pub(super) fn moves(&self, matrices: &Matrices) -> DMatrix<f64> {
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

    /// The record as the likelihood's sums take it; `left` is what the model leaves of `spectrum.y`, if that is known.
    pub(super) fn spectrum(
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
            missing: self.missing(matrices, spectrum),
        }
    }

    /// Missing samples, turned as their sensors are.
    fn missing(&self, matrices: &Matrices, spectrum: &Spectrum) -> Option<MissingSamples> {
        let missing = spectrum.missing.clone()?;
        if matrices.sensor_lags.iter().all(|lag| *lag == 0.0) {
            return Some(missing);
        }
        let turns = spectrum.frequencies.iter().flat_map(|&frequency| {
            matrices.sensor_lags.iter().map(move |&lag| turn(-frequency, lag))
        });
        Some(missing.turned(turns.collect()))
    }

    pub(super) fn system(&self, matrices: &Matrices, nuisances: &Nuisances) -> RecordSystem {
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

/// The transform of an impulse so many samples before the beginning.
pub(super) fn before(z: Complex<f64>, samples: usize) -> Complex<f64> {
    (0..samples).fold(Complex::from(1.0), |product, _| product * z)
}

/// What a lag of so many seconds does to a spectrum.
pub(super) fn turn(frequency: f64, lag: f64) -> Complex<f64> {
    if lag == 0.0 { Complex::new(1.0, 0.0) } else { Complex::from_polar(1.0, -frequency * lag) }
}
