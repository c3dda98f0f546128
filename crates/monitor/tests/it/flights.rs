//! Flights of the paper's aircraft with three noisy sensors.

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use cfi_ident::{ConstantTerm, FitOptions, Orders, Segment, Structure, fit};
use flight::{ContinuousNoise, Stream, autoregressive, behind_low_pass, normal};
use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use monitor::{Detector, Link, Options, Stretch};
use nalgebra::DMatrix;

/// What moves the aileron.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Excitation {
    White,
    Autoregressive,
    LowPass,
}

/// Sideslip, roll rate, yaw rate; one row each.
pub(crate) struct Simulator {
    discrete: StateSpace<Discrete>,
    filtered: ContinuousNoise,
    excitation: Excitation,
    levels: Vec<f64>,
}

impl Simulator {
    pub(crate) fn new(excitation: Excitation, signal_to_noise: f64) -> Self {
        let entry = catalog::PAPER_AIRCRAFT;
        let model = LateralModel::new(entry.derivatives, entry.inertia).unwrap();
        let sensors = [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];
        let system: StateSpace<Continuous> =
            model.state_space(&[Surface::Aileron], SideForceScaling::AsPrinted, &sensors).unwrap();
        let period = SamplePeriod::new(0.1).unwrap();
        let filtered = behind_low_pass(&system, 0, std::f64::consts::TAU).unwrap();
        let mut simulator = Self {
            discrete: system.zoh(period).unwrap(),
            filtered: ContinuousNoise::new(&filtered, period).unwrap(),
            excitation,
            levels: vec![0.0; 3],
        };
        let clean = simulator.fly(5_000, 1_000_000);
        let level = |row: usize| clean.row(row).variance().sqrt() / signal_to_noise;
        simulator.levels = (0..3).map(level).collect();
        simulator
    }

    /// Standard deviation of each sensor's noise.
    pub(crate) fn level(&self, sensor: usize) -> f64 {
        self.levels[sensor]
    }

    pub(crate) fn fly(&self, samples: usize, seed: u64) -> DMatrix<f64> {
        let mut random = Stream::new(seed, 0);
        let mut y = match self.excitation {
            Excitation::LowPass => self.filtered.sampled(0, samples, &mut random).unwrap(),
            Excitation::White => self.held(&normal(1, samples, &mut random)),
            Excitation::Autoregressive => {
                self.held(&autoregressive(normal(1, samples, &mut random)))
            }
        };
        let noise = normal(3, samples, &mut Stream::new(seed, 1));
        for row in 0..3 {
            for k in 0..samples {
                y[(row, k)] += self.levels[row] * noise[(row, k)];
            }
        }
        y
    }

    fn held(&self, input: &DMatrix<f64>) -> DMatrix<f64> {
        self.discrete.simulate(input, None).unwrap().outputs
    }
}

/// The channels of a record.
pub(crate) fn channels(y: &DMatrix<f64>) -> Vec<Vec<f64>> {
    y.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// A part of them.
pub(crate) fn part(channels: &[Vec<f64>], range: std::ops::Range<usize>) -> Stretch<'_> {
    channels.iter().map(|values| &values[range.clone()]).collect()
}

/// Fits these pairs to the first half of a reference flight and calibrates with the second.
pub(crate) fn detector(
    reference: &[Vec<f64>],
    pairs: &[(usize, usize)],
    options: Options,
) -> Detector {
    let samples = reference[0].len();
    let (training, healthy) =
        (part(reference, 0..samples / 2), part(reference, samples / 2..samples));
    let structure = Structure::new(Orders::new(4, 25, 25).unwrap(), ConstantTerm::Omitted);
    let link = |&(input, output): &(usize, usize)| {
        let segment = Segment::new(training[input], training[output]).unwrap();
        let model = fit(&[segment], &structure, &FitOptions::default()).unwrap().model;
        Link { model, input, output }
    };
    let links = pairs.iter().map(link).collect();
    Detector::calibrate(links, &[training], &[healthy], options).unwrap()
}

/// From sideslip to the others.
pub(crate) const ALL_PAIRS: [(usize, usize); 2] = [(0, 1), (0, 2)];
