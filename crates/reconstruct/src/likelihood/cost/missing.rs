//! Missing samples of a record: unknowns, eliminated exactly.
//!
//! Sample j of sensor s enters the transform as an impulse in that sensor alone, f_j = N^(-1/2) z^-j, times an unknown number x. With F all of these
//! impulses and the symbols of `accumulate.rs`, the cost of values x is that of e - F x, so that it is least at x = G^-1 F^H Phi e with G = F^H Phi F,
//! summed over the frequencies. What is left is the likelihood of the samples that are there:
//!
//! - cost and descent are those of the record with the best x in place of the missing samples;
//! - K^T G^-1 K comes off the Gram matrix, K the products of the impulses with the parameters' signals;
//! - ln det G joins the logarithms of the determinants, and trace G^-1 F^H Phi E_l Phi F the score of noise level l, E_l what it adds to S.
//!
//! A sensor may have been turned at each frequency, as one is that was late; its impulses turn with it, and with them Phi between sensors.
//!
//! The impulses are powers of z. So each entry of G, of K and of F^H Phi e is a sample of an inverse Fourier transform, and their effort hardly depends
//! on how many samples are missing.

use std::fmt;
use std::sync::Arc;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::accumulate::{Scalars, at_frequencies};
use super::frequency_block::AtFrequencies;
use super::record_system::RecordSystem;
use super::spectrum::RecordSpectrum;
use super::sums::Sums;
use crate::Record;

/// The missing samples of one record.
#[derive(Clone)]
pub(crate) struct MissingSamples {
    /// Samples of the record, N.
    samples: usize,
    /// k of each frequency that is used.
    frequencies: Vec<usize>,
    /// Sensor and sample of each unknown.
    pub(crate) cells: Vec<(usize, usize)>,
    /// What each sensor was multiplied by at each frequency, numbers of size 1, m per frequency; empty where no sensor was turned.
    turns: Vec<Complex<f64>>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

impl fmt::Debug for MissingSamples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MissingSamples")
            .field("samples", &self.samples)
            .field("frequencies", &self.frequencies)
            .field("cells", &self.cells)
            .finish_non_exhaustive()
    }
}

/// What the missing samples take of a Gram matrix: the columns of L^-1 K, with L L^T = G, one for each cell of the sums.
#[derive(Clone, Debug)]
pub(crate) struct Absorbed(DMatrix<f64>);

impl Absorbed {
    /// The part of the entry of these two cells.
    pub(crate) fn of(&self, first: usize, second: usize) -> f64 {
        self.0.column(first).dot(&self.0.column(second))
    }
}

impl MissingSamples {
    /// `None` where nothing is missing.
    pub(crate) fn new(
        record: &Record,
        frequencies: Vec<usize>,
        planner: &mut RealFftPlanner<f64>,
    ) -> Option<Self> {
        let sensors = 0..record.channels().len();
        let cells: Vec<(usize, usize)> = sensors
            .flat_map(|sensor| record.missing(sensor).iter().map(move |&sample| (sensor, sample)))
            .collect();
        let samples = record.samples();
        (!cells.is_empty()).then(|| Self {
            samples,
            frequencies,
            cells,
            turns: Vec::new(),
            forward: planner.plan_fft_forward(samples),
            inverse: planner.plan_fft_inverse(samples),
        })
    }

    /// The part of the samples of so many sensors that is there.
    pub(crate) fn part_present(&self, sensors: usize) -> f64 {
        1.0 - self.cells.len() as f64 / (self.samples * sensors) as f64
    }

    /// The same of sensors that were multiplied by these numbers, m per frequency.
    pub(crate) fn turned(self, turns: Vec<Complex<f64>>) -> Self {
        Self { turns, ..self }
    }

    /// The same without the first frequency.
    pub(crate) fn without_first_frequency(&mut self, sensors: usize) {
        self.frequencies.remove(0);
        self.turns.drain(..sensors.min(self.turns.len()));
    }

    /// What a sensor was multiplied by at a frequency; `place` is k * m + s.
    fn turn(&self, place: usize) -> Complex<f64> {
        self.turns.get(place).copied().unwrap_or(Complex::ONE)
    }

    /// The sums of the likelihood of the samples that are there; `sum` are those of a record of which all are. `known` is G where that stays what it is:
    /// without an unknown excitation it does not depend on the system.
    pub(crate) fn sums(
        &self,
        record: &RecordSpectrum,
        system: &RecordSystem,
        scalars: Scalars,
        known: Option<&Unknowns>,
        sum: impl Fn(&RecordSpectrum) -> Sums,
    ) -> Sums {
        let none = || {
            let mut none = sum(record);
            none.cost = f64::NAN;
            none
        };
        let Some(at) = at_frequencies(record, system) else { return none() };
        let own = if known.is_none() { self.unknowns(record, &at.projector) } else { None };
        let Some(unknowns) = known.or(own.as_ref()) else { return none() };
        let Some(filled) = self.filled_with(record, &at, unknowns) else { return none() };
        let mut sums = sum(&filled);
        if scalars == Scalars::NoisePart {
            return sums;
        }
        let Some(at) = at_frequencies(&filled, system) else { return sums };
        sums.log_determinant += unknowns.log_determinant;
        for (score, lost) in sums.score.iter_mut().zip(self.lost_scores(record, &at, unknowns)) {
            *score += lost;
        }
        let cross = self.cross(record, system, &at);
        sums.absorbed = unknowns.factor.l_dirty().solve_lower_triangular(&cross).map(Absorbed);
        sums
    }

    /// The record with the most likely values in place of the missing samples. `None` where there are none: a system that has no Schur form, or samples that
    /// the frequencies do not tell apart.
    pub(crate) fn filled(
        &self,
        record: &RecordSpectrum,
        system: &RecordSystem,
        known: Option<&Unknowns>,
    ) -> Option<RecordSpectrum> {
        let at = at_frequencies(record, system)?;
        match known {
            Some(unknowns) => self.filled_with(record, &at, unknowns),
            None => self.filled_with(record, &at, &self.unknowns(record, &at.projector)?),
        }
    }

    fn filled_with(
        &self,
        record: &RecordSpectrum,
        at: &AtFrequencies,
        unknowns: &Unknowns,
    ) -> Option<RecordSpectrum> {
        let m = record.offset_variance.len();
        let residual =
            |k: usize, s: usize| at.weighted_residual[k * m + s] * self.turn(k * m + s).conj();
        let descents: Vec<Vec<f64>> =
            (0..m).map(|s| self.to_samples(record, |k| residual(k, s))).collect();
        let root = (self.samples as f64).sqrt();
        let descent = self.cells.iter().map(|&(sensor, sample)| descents[sensor][sample] / root);
        let best = unknowns.factor.solve(&DVector::from_iterator(self.cells.len(), descent));
        let mut filled = record.clone();
        for sensor in 0..m {
            let mut impulses = vec![0.0; self.samples];
            for (&(own, sample), value) in self.cells.iter().zip(best.iter()) {
                if own == sensor {
                    impulses[sample] = value / root;
                }
            }
            let mut transformed = self.forward.make_output_vec();
            // Both buffers have the lengths that the plan asks for.
            self.forward.process(&mut impulses, &mut transformed).ok()?;
            for (k, &frequency) in self.frequencies.iter().enumerate() {
                filled.y[k * m + sensor] -= transformed[frequency] * self.turn(k * m + sensor);
            }
        }
        Some(filled)
    }

    /// G, factored, of Phi, m x m at each frequency.
    pub(crate) fn unknowns(
        &self,
        record: &RecordSpectrum,
        projector: &[Complex<f64>],
    ) -> Option<Unknowns> {
        let m = record.offset_variance.len();
        let gram = self.toeplitz(record, |k, s, l| projector[(k * m + s) * m + l], m);
        let largest = gram.diagonal().max();
        // In a narrow band neighbours may not be told apart: then they stay near where they are.
        [0.0, 1e-13, 1e-11, 1e-9].iter().find_map(|share| {
            let mut gram = gram.clone();
            (0..gram.nrows()).for_each(|i| gram[(i, i)] += share * largest);
            let factor = Cholesky::new(gram)?;
            let logarithm = |entry: &f64| 2.0 * entry.ln();
            let log_determinant = factor.l_dirty().diagonal().iter().map(logarithm).sum::<f64>();
            log_determinant.is_finite().then_some(Unknowns { factor, log_determinant })
        })
    }

    /// What the missing samples take of the score of each noise level.
    fn lost_scores(
        &self,
        record: &RecordSpectrum,
        at: &AtFrequencies,
        unknowns: &Unknowns,
    ) -> Vec<f64> {
        let m = record.offset_variance.len();
        let inverse = unknowns.factor.inverse();
        let phi = |k: usize, s: usize, l: usize| at.projector[(k * m + s) * m + l];
        let mut lost: Vec<f64> = (0..m)
            .map(|i| self.toeplitz(record, |k, s, l| phi(k, s, i) * phi(k, i, l), m).dot(&inverse))
            .collect();
        if !at.power.is_empty() {
            let with_power = |k: usize, s: usize, l: usize| {
                (0..m).map(|i| phi(k, s, i) * at.power[k * m + i] * phi(k, i, l)).sum()
            };
            lost.push(self.toeplitz(record, with_power, m).dot(&inverse));
        }
        lost
    }

    /// K, one column for each cell of the sums.
    fn cross(
        &self,
        record: &RecordSpectrum,
        system: &RecordSystem,
        at: &AtFrequencies,
    ) -> DMatrix<f64> {
        let (n, m) = (system.b.len(), system.d.len());
        let count = n + 1 + record.entries.len();
        let rows = n + m;
        let root = (self.samples as f64).sqrt();
        let mut cross = DMatrix::zeros(self.cells.len(), rows * count);
        for a in 0..count {
            for i in 0..rows {
                for s in 0..m {
                    // The conjugate of (D^H Phi)_is conj(s_a).
                    let products = self.to_samples(record, |k| {
                        let projected = if i < n {
                            at.projected_response[(k * m + s) * n + i]
                        } else {
                            at.projector[(k * m + s) * m + i - n]
                        };
                        projected * at.scalars[k * count + a] * self.turn(k * m + s).conj()
                    });
                    for (row, &(sensor, sample)) in self.cells.iter().enumerate() {
                        if sensor == s {
                            cross[(row, a * rows + i)] = products[sample] / root;
                        }
                    }
                }
            }
        }
        cross
    }

    /// The sum over frequencies of w conj(f_j) M f_l for all pairs of unknowns, M Hermitian in the sensors.
    fn toeplitz(
        &self,
        record: &RecordSpectrum,
        matrix: impl Fn(usize, usize, usize) -> Complex<f64>,
        sensors: usize,
    ) -> DMatrix<f64> {
        let turned = |k: usize, s: usize, l: usize| {
            let turn = self.turn(k * sensors + s).conj() * self.turn(k * sensors + l);
            matrix(k, s, l) * turn
        };
        let lags: Vec<Vec<f64>> = (0..sensors * sensors)
            .map(|pair| self.to_samples(record, |k| turned(k, pair / sensors, pair % sensors)))
            .collect();
        DMatrix::from_fn(self.cells.len(), self.cells.len(), |row, column| {
            let ((s, j), (l, i)) = (self.cells[row], self.cells[column]);
            lags[s * sensors + l][(self.samples + j - i) % self.samples] / self.samples as f64
        })
    }

    /// The real part of the sum over frequencies of w times a number times z^j, for all samples j.
    fn to_samples(
        &self,
        record: &RecordSpectrum,
        number: impl Fn(usize) -> Complex<f64>,
    ) -> Vec<f64> {
        let mut spectrum = self.inverse.make_input_vec();
        for (k, &frequency) in self.frequencies.iter().enumerate() {
            let value = number(k) * record.weight[k];
            // The transform adds the conjugate, but at frequency zero and at half the sampling frequency.
            spectrum[frequency] = if frequency == 0 || 2 * frequency == self.samples {
                Complex::from(value.re)
            } else {
                value / 2.0
            };
        }
        let mut samples = self.inverse.make_output_vec();
        // The buffers have the lengths that the plan asks for, and the ends are real.
        if self.inverse.process(&mut spectrum, &mut samples).is_err() {
            samples.fill(f64::NAN);
        }
        samples
    }
}

/// The unknowns' Gram matrix G.
#[derive(Debug)]
pub(crate) struct Unknowns {
    factor: Cholesky<f64, Dyn>,
    /// ln det G.
    log_determinant: f64,
}

#[cfg(test)]
mod tests;
