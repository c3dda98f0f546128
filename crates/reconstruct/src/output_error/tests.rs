//! Planted aircraft whose inputs are recorded, beside noise, gusts and lags.

mod bad_input;
mod gaps;
mod planted;

use std::f64::consts::TAU;

use lti::SamplePeriod;
use nalgebra::DVector;
use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::Normal;
use crate::likelihood::{Hold, Mode};
use crate::model::lateral_equations::LateralEquations;
use crate::{Channel, Record};

const PERIOD: f64 = 0.05;

/// Derivatives of a small aircraft in the order of the equations' parameters, then Y, L, N of aileron and rudder.
pub(super) const DERIVATIVES: [f64; 17] = [
    -0.18, 0.06, -0.98, 0.07, -15.0, -2.6, 1.1, 5.2, -0.12, -0.6, 0.05, 0.0, 9.0, -0.4, 0.03, 1.2,
    -3.5,
];

pub(super) fn equations(hold: Hold) -> LateralEquations {
    LateralEquations::new(&["beta", "p", "r"], 2, hold, PERIOD).unwrap()
}

/// Eigenvalues s of the planted aircraft with a positive imaginary part or none, and of whatever is added to it.
pub(super) fn eigenvalues() -> Vec<Complex<f64>> {
    let parameters = DVector::from_column_slice(&DERIVATIVES);
    let (a, _) = equations(Hold::ZeroOrder).continuous(&parameters);
    a.complex_eigenvalues().iter().copied().filter(|s| s.im >= 0.0).collect()
}

/// What is flown.
#[derive(Clone, Copy)]
pub(super) struct Flown {
    pub(super) samples: usize,
    /// How far aileron and rudder move.
    pub(super) moved: [f64; 2],
    /// The standard deviation of a gust of a correlation time of a second, in rad of beta.
    pub(super) gust: f64,
    /// The standard deviation of noise in each sensor.
    pub(super) noise: [f64; 3],
    /// What is added to each sensor.
    pub(super) offset: f64,
    /// Samples by which beta is late.
    pub(super) late: usize,
}

pub(super) const BOTH: Flown = Flown {
    samples: 1200,
    moved: [0.03, 0.03],
    gust: 0.0,
    noise: [1e-3, 2e-3, 1e-3],
    offset: 0.0,
    late: 0,
};

/// A flight with inputs that stay what they are for eight samples, and the record of it.
pub(super) fn fly(flown: &Flown, normal: &mut Normal) -> (Record, Vec<Vec<f64>>) {
    let parameters = DVector::from_column_slice(&DERIVATIVES);
    let matrices = equations(Hold::ZeroOrder).sampled(&parameters).unwrap();
    let (a, b) = (matrices.a, matrices.b);
    let mut state = DVector::zeros(4);
    let (mut signals, mut sensors) = (vec![Vec::new(); 2], vec![Vec::new(); 3]);
    let (mut surfaces, mut gust) = ([0.0; 2], 0.0);
    let decay = (-PERIOD).exp();
    for k in 0..flown.samples {
        if k % 8 == 0 {
            surfaces = flown.moved.map(|size| size * normal.next());
        }
        gust = decay * gust + flown.gust * (1.0 - decay * decay).sqrt() * normal.next();
        // A side gust is a sideslip to the air, which turns the aircraft.
        let against_air = DVector::from_column_slice(&[gust, 0.0, 0.0, 0.0]);
        for (sensor, values) in sensors.iter_mut().enumerate() {
            values.push(state[sensor] + flown.offset + flown.noise[sensor] * normal.next());
        }
        for (signal, surface) in signals.iter_mut().zip(surfaces) {
            signal.push(surface);
        }
        let disturbed = &a * (&state + &against_air) - against_air;
        state = disturbed + &b * DVector::from_column_slice(&surfaces);
    }
    if flown.late > 0 {
        sensors[0].rotate_right(flown.late);
        let first = sensors[0][flown.late];
        sensors[0][..flown.late].fill(first);
    }
    let channels = ["beta", "p", "r"].into_iter().zip(sensors);
    let channels = channels.map(|(name, values)| Channel::new(name, values)).collect();
    (Record::new("flight", SamplePeriod::new(PERIOD).unwrap(), channels).unwrap(), signals)
}

pub(super) fn flights(all: &[Flown], seed: u64) -> (Vec<Record>, RecordedInputs) {
    let mut normal = Normal::new(seed);
    let (records, signals) = all.iter().map(|flown| fly(flown, &mut normal)).unzip();
    (records, RecordedInputs { names: vec!["aileron".into(), "rudder".into()], signals })
}

/// For each planted eigenvalue, the mode next to it and by how many standard errors it is off, real and imaginary part.
pub(super) fn scores(modes: &[Mode], planted: &[Complex<f64>]) -> Vec<f64> {
    let mut scores = Vec::new();
    for &s in planted {
        let distance = |mode: &&Mode| (mode.continuous.value - s).norm();
        let mode = modes.iter().min_by(|x, y| distance(x).total_cmp(&distance(y))).unwrap();
        let (off, estimate) = (mode.continuous.value - s, mode.continuous);
        scores.push(off.re / estimate.real_standard_error());
        if s.im > 0.0 {
            scores.push(off.im / estimate.imaginary_standard_error());
        }
    }
    scores
}

/// The largest relative error of the modes that a minute can resolve.
pub(super) fn error(modes: &[Mode], planted: &[Complex<f64>]) -> f64 {
    let resolved = planted.iter().filter(|s| s.norm() > TAU / 60.0);
    let off = |s: &Complex<f64>| {
        let all = modes.iter().map(|mode| (mode.continuous.value - s).norm() / s.norm());
        all.fold(f64::INFINITY, f64::min)
    };
    resolved.map(off).fold(0.0, f64::max)
}
