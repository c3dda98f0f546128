//! Planted systems and their records, for tests.

use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use realfft::RealFftPlanner;

use super::{Fit, Noise, Options};
use crate::{Channel, Record, SharedModel};

/// A source of standard normal numbers.
pub(crate) struct Normal(ChaCha8Rng);

impl Normal {
    pub(crate) fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    pub(crate) fn next(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }

    pub(crate) fn vector(&mut self, length: usize) -> DVector<f64> {
        DVector::from_fn(length, |_, _| self.next())
    }

    pub(crate) fn matrix(&mut self, rows: usize, columns: usize) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |_, _| self.next())
    }
}

/// A system with these discrete eigenvalues (of a complex pair the one with positive imaginary part), in a random basis that is not far from
/// orthogonal, with random C and b.
pub(crate) fn system(
    eigenvalues: &[Complex<f64>],
    sensors: usize,
    records: usize,
    normal: &mut Normal,
) -> SharedModel {
    let n = eigenvalues.iter().map(|z| if z.im == 0.0 { 1 } else { 2 }).sum();
    let mut a = DMatrix::zeros(n, n);
    let mut at = 0;
    for z in eigenvalues {
        a[(at, at)] = z.re;
        if z.im != 0.0 {
            a[(at + 1, at + 1)] = z.re;
            a[(at, at + 1)] = z.im;
            a[(at + 1, at)] = -z.im;
            at += 1;
        }
        at += 1;
    }
    let q = normal.matrix(n, n).qr().q();
    let t = q * (DMatrix::identity(n, n) + 0.2 * normal.matrix(n, n));
    let inverse = t.clone().try_inverse().unwrap();
    SharedModel {
        a: &inverse * a * &t,
        c: normal.matrix(sensors, n),
        b: (0..records).map(|_| normal.vector(n)).collect(),
        feedthrough: None,
        period: SamplePeriod::new(0.1).unwrap(),
    }
}

/// What disturbs the records beside the excitation.
pub(crate) struct Disturbance {
    /// Noise over signal, for each sensor's root mean square in the first record.
    pub(crate) noise: f64,
    pub(crate) offset: f64,
    pub(crate) trend: f64,
    /// Size of a second input, which is recorded.
    pub(crate) known: f64,
}

pub(crate) const QUIET: Disturbance =
    Disturbance { noise: 0.0, offset: 0.0, trend: 0.0, known: 0.0 };

/// Records, the noise levels in them, and the known inputs.
pub(crate) struct Flights {
    pub(crate) records: Vec<Record>,
    pub(crate) levels: Vec<f64>,
    pub(crate) known: Vec<Vec<Vec<f64>>>,
}

/// Records under white excitation, from a random initial state.
pub(crate) fn fly(
    model: &SharedModel,
    samples: &[usize],
    disturbance: &Disturbance,
    normal: &mut Normal,
) -> Flights {
    let (n, m) = (model.a.nrows(), model.c.nrows());
    let (mut outputs, mut known) = (Vec::new(), Vec::new());
    for (record, &samples) in samples.iter().enumerate() {
        let mut x = normal.vector(n);
        let enters = normal.vector(n);
        let (offset, rate) = (normal.vector(m), normal.vector(m));
        let mut y = DMatrix::zeros(m, samples);
        let mut input = Vec::new();
        for k in 0..samples {
            let u = normal.next();
            let v = disturbance.known * normal.next();
            input.push(v);
            let mut now = &model.c * &x;
            if let Some(d) = &model.feedthrough {
                now += &d[record] * u;
            }
            now += &offset * disturbance.offset
                + &rate * (disturbance.trend * (k as f64 / samples as f64 - 0.5));
            y.set_column(k, &now);
            x = &model.a * &x + &model.b[record] * u + &enters * v;
        }
        outputs.push(y);
        known.push(if disturbance.known > 0.0 { vec![input] } else { Vec::new() });
    }
    let levels: Vec<f64> = (0..m)
        .map(|s| {
            let row = outputs[0].row(s);
            let size = disturbance.noise * row.norm() / (row.len() as f64).sqrt();
            if size > 0.0 { size } else { 1e-3 * row.norm() / (row.len() as f64).sqrt() }
        })
        .collect();
    let records = outputs.into_iter().enumerate().map(|(record, y)| {
        let channels = (0..m).map(|s| {
            let values = y.row(s).into_iter().map(|value| {
                let noise = if disturbance.noise > 0.0 { levels[s] * normal.next() } else { 0.0 };
                value + noise
            });
            Channel::new(format!("y{s}"), values.collect())
        });
        let channels = channels.collect();
        Record::new(format!("record {record}"), model.period, channels).unwrap()
    });
    Flights { records: records.collect(), levels, known }
}

/// The model in another basis, every number off by this part.
pub(crate) fn perturbed(model: &SharedModel, part: f64, normal: &mut Normal) -> SharedModel {
    let n = model.a.nrows();
    let t = DMatrix::identity(n, n) * 3.0 + 0.5 * normal.matrix(n, n);
    let inverse = t.clone().try_inverse().unwrap();
    let size = model.a.norm() / n as f64;
    let mut off = |entry: f64, size: f64| entry + part * size * normal.next();
    let a = model.a.map(|entry| off(entry, size));
    let c = model.c.map(|entry| off(entry, 1.0));
    let b = model.b.iter().map(|b| b.map(|entry| off(entry, 1.0))).collect::<Vec<_>>();
    let feedthrough = model
        .feedthrough
        .as_ref()
        .map(|all| all.iter().map(|d| d.map(|entry| off(entry, 0.1) * 2.0)).collect());
    SharedModel {
        a: &inverse * a * &t,
        c: c * &t,
        b: b.iter().map(|b| &inverse * b * 2.0).collect(),
        feedthrough,
        period: model.period,
    }
}

/// Options for records with these levels.
pub(crate) fn given(levels: &[f64]) -> Options {
    Options { noise: Noise::Given(levels.to_vec()), ..Options::default() }
}

/// For each eigenvalue the distance of the closest fitted one, and that distance over its deviation.
pub(crate) fn misses(fit: &Fit, eigenvalues: &[Complex<f64>]) -> Vec<(f64, f64)> {
    eigenvalues
        .iter()
        .map(|z| {
            let distance = |mode: &&super::Mode| (mode.discrete.value - z).norm();
            let mode = fit.modes.iter().min_by(|x, y| distance(x).total_cmp(&distance(y))).unwrap();
            let deviation = mode.discrete.covariance.trace().sqrt();
            (distance(&mode), distance(&mode) / deviation)
        })
        .collect()
}

/// The record with each frequency of each sensor off by a random part of what it is, of this size.
pub(crate) fn with_model_error(record: &Record, size: f64, normal: &mut Normal) -> Record {
    let samples = record.samples();
    let mut planner = RealFftPlanner::new();
    let (there, back) = (planner.plan_fft_forward(samples), planner.plan_fft_inverse(samples));
    let channels = record.channels().iter().map(|channel| {
        let (mut input, mut spectrum) = (channel.values.clone(), there.make_output_vec());
        there.process(&mut input, &mut spectrum).unwrap();
        let last = spectrum.len() - 1;
        for (k, value) in spectrum.iter_mut().enumerate() {
            let real = k == 0 || (k == last && samples.is_multiple_of(2));
            let imaginary = if real { 0.0 } else { normal.next() };
            let scale = if real { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
            *value *= Complex::new(1.0 + scale * size * normal.next(), scale * size * imaginary);
        }
        back.process(&mut spectrum, &mut input).unwrap();
        let values = input.iter().map(|value| value / samples as f64).collect();
        Channel::new(channel.name.clone(), values)
    });
    Record::new(record.name(), record.period(), channels.collect()).unwrap()
}
