//! Flights of the paper's aircraft: sideslip, roll rate, yaw rate.

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

use crate::likelihood::fixtures::Normal;
use crate::{Channel, Record};

/// Roll, Dutch roll, spiral in 1/s: tests/data/reference.json /aircraft/spec_A.
pub(super) const TRUTH: [(f64, f64); 3] = [
    (-0.545_562_845_619_248_3, 0.0),
    (-0.070_594_067_703_702_26, 1.691_678_361_958_471_2),
    (-0.001_563_638_219_256_003_3, 0.0),
];

/// Inputs: aileron, rudder, and a side gust that enters like -beta.
pub(super) fn system() -> StateSpace<Discrete> {
    let paper = &catalog::PAPER_AIRCRAFT;
    let model = LateralModel::new(paper.derivatives, paper.inertia).unwrap();
    let states = LateralState::ALL;
    let system = model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &states).unwrap();
    let columns = [
        system.b().column(0).into_owned(),
        system.b().column(1).into_owned(),
        -system.a().column(0).into_owned(),
    ];
    let (a, c) = (system.a().clone(), system.c().rows(0, 3).into_owned());
    let b = DMatrix::from_columns(&columns);
    let system = StateSpace::<lti::Continuous>::new(a, b, c, DMatrix::zeros(3, 3)).unwrap();
    system.zoh(SamplePeriod::new(0.1).unwrap()).unwrap()
}

/// How strongly each input is moved.
pub(super) type Moves = [f64; 3];

pub(super) const AILERON: Moves = [1.0, 0.0, 0.0];
pub(super) const RUDDER: Moves = [0.0, 1.0, 0.0];
pub(super) const BOTH: Moves = [1.0, 1.0, 0.0];

/// Inputs moved independently of each other: white noise through a filter with this pole.
pub(super) fn inputs(moves: Moves, samples: usize, pole: f64, normal: &mut Normal) -> DMatrix<f64> {
    let mut inputs = DMatrix::zeros(3, samples);
    for (i, size) in moves.into_iter().enumerate().filter(|(_, size)| *size > 0.0) {
        let mut state = 0.0;
        for k in 0..samples {
            state = pole * state + normal.next();
            inputs[(i, k)] = size * state;
        }
    }
    inputs
}

pub(super) fn readings(inputs: &DMatrix<f64>) -> DMatrix<f64> {
    system().simulate(inputs, None).unwrap().outputs
}

/// A sensor's deviation in the mean of the flights, over the signal-to-noise ratio.
pub(super) fn levels(flights: &[DMatrix<f64>], ratio: f64) -> Vec<f64> {
    let mean = |i: usize| {
        let all = flights.iter().map(|flight| flight.row(i).variance().sqrt());
        all.sum::<f64>() / flights.len() as f64 / ratio
    };
    (0..3).map(mean).collect()
}

pub(super) fn noisy(
    name: &str,
    flight: &DMatrix<f64>,
    levels: &[f64],
    normal: &mut Normal,
) -> Record {
    let channels = ["beta", "p", "r"].into_iter().enumerate().map(|(i, sensor)| {
        let values = flight.row(i).into_iter().map(|value| value + levels[i] * normal.next());
        Channel::new(sensor, values.collect())
    });
    Record::new(name, SamplePeriod::new(0.1).unwrap(), channels.collect()).unwrap()
}

/// Two flights with noise.
pub(super) fn two(
    moves: [Moves; 2],
    samples: usize,
    pole: f64,
    ratio: f64,
    seed: u64,
) -> Vec<Record> {
    let mut normal = Normal::new(seed);
    let flights = moves.map(|moves| readings(&inputs(moves, samples, pole, &mut normal)));
    let levels = levels(&flights, ratio);
    let each = flights.iter().zip(["first", "second"]);
    each.map(|(flight, name)| noisy(name, flight, &levels, &mut normal)).collect()
}
