//! The paper's aircraft: its model, its modes, and what its three sensors read while a surface
//! moves.

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use flight::{Stream, normal};
use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use reconstruct::{Channel, Record, SharedModel};

use super::modes::TrueModes;
use crate::TaskError;

/// The sensors, in the order of all rows and channels: sideslip, roll rate, yaw rate.
pub(crate) const SENSORS: [&str; 3] = ["beta", "p", "r"];
/// What they measure.
const STATES: [LateralState; 3] =
    [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];
/// The surfaces, in the order of all inputs: one record is moved through each.
pub(crate) const SURFACES: [&str; 2] = ["aileron", "rudder"];

/// Samples of each of the paper's records. The paper does not say how many it used.
const SAMPLES: usize = 2000;
/// Seconds between two samples, as in the paper.
const PERIOD_S: f64 = 0.1;
/// Seeds of the excitations of the paper's records, in the order of the surfaces.
pub(crate) const SEEDS: [u64; 2] = [1, 2];

/// The aircraft of part VI with its two surfaces and three sensors.
#[derive(Clone, Debug)]
pub(crate) struct PaperAircraft {
    pub(crate) model: LateralModel,
    /// Continuous time, the rudder's side force as printed.
    pub(crate) continuous: StateSpace<Continuous>,
    /// The same, sampled.
    pub(crate) discrete: StateSpace<Discrete>,
    pub(crate) modes: TrueModes,
}

impl PaperAircraft {
    pub(crate) fn new() -> Result<Self, TaskError> {
        const PART: &str = "aircraft";
        let paper = catalog::PAPER_AIRCRAFT;
        let model = LateralModel::new(paper.derivatives, paper.inertia)
            .map_err(TaskError::computation(PART))?;
        let continuous = model
            .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &STATES)
            .map_err(TaskError::computation(PART))?;
        let period = SamplePeriod::new(PERIOD_S).map_err(TaskError::computation(PART))?;
        let discrete = continuous.zoh(period).map_err(TaskError::computation(PART))?;
        let poles = continuous.poles().map_err(TaskError::computation(PART))?;
        Ok(Self { modes: TrueModes::told_apart(&poles)?, model, continuous, discrete })
    }

    pub(crate) fn period(&self) -> SamplePeriod {
        self.discrete.period()
    }

    /// The system as the methods see it.
    pub(crate) fn shared_model(&self) -> SharedModel {
        let column = |surface| self.discrete.b().column(surface).into_owned();
        SharedModel {
            a: self.discrete.a().clone(),
            c: self.discrete.c().clone(),
            b: (0..SURFACES.len()).map(column).collect(),
            feedthrough: None,
            period: self.period(),
        }
    }

    /// The sampled system from one surface to the sensors.
    pub(crate) fn driven_by(&self, surface: usize) -> Result<StateSpace<Discrete>, TaskError> {
        self.discrete.subsystem(&[0, 1, 2], &[surface]).map_err(TaskError::computation("records"))
    }

    /// What the sensors read, one row each, when a surface moves like this and is held between
    /// samples, from rest.
    pub(crate) fn response(
        &self,
        surface: usize,
        input: &DMatrix<f64>,
    ) -> Result<DMatrix<f64>, TaskError> {
        let simulation = self.driven_by(surface)?.simulate(input, None);
        Ok(simulation.map_err(TaskError::computation("records"))?.outputs)
    }

    /// The records of the paper's figures, aileron and rudder: white Gaussian excitation of unit
    /// variance, no noise.
    pub(crate) fn paper_records(&self) -> Result<[Record; 2], TaskError> {
        let record = |surface: usize| {
            let mut random = ChaCha8Rng::seed_from_u64(SEEDS[surface]);
            let excitation =
                DMatrix::from_fn(1, SAMPLES, |_, _| StandardNormal.sample(&mut random));
            let y = self.response(surface, &excitation)?;
            self.record(SURFACES[surface], |sensor, k| y[(sensor, k)], SAMPLES)
        };
        Ok([record(0)?, record(1)?])
    }

    /// A record of readings with white Gaussian noise of these levels.
    pub(crate) fn noisy_record(
        &self,
        name: &str,
        y: &DMatrix<f64>,
        levels: &[f64],
        random: &mut Stream,
    ) -> Result<Record, TaskError> {
        let noise = normal(SENSORS.len(), y.ncols(), random);
        let reading = |sensor, k| y[(sensor, k)] + levels[sensor] * noise[(sensor, k)];
        self.record(name, reading, y.ncols())
    }

    fn record(
        &self,
        name: &str,
        reading: impl Fn(usize, usize) -> f64,
        samples: usize,
    ) -> Result<Record, TaskError> {
        let channels = SENSORS.iter().enumerate().map(|(sensor, name)| {
            Channel::new(*name, (0..samples).map(|k| reading(sensor, k)).collect())
        });
        Record::new(name, self.period(), channels.collect())
            .map_err(TaskError::computation("records"))
    }
}

/// Standard deviation of each sensor's noise, the same in all records: from the mean of the
/// signal's root mean squares in the records, each about its own mean.
pub(crate) fn noise_levels(clean: &[DMatrix<f64>], signal_to_noise: f64) -> Vec<f64> {
    let level = |sensor| {
        let deviations = clean.iter().map(|y| y.row(sensor).variance().sqrt());
        deviations.sum::<f64>() / clean.len() as f64 / signal_to_noise
    };
    (0..SENSORS.len()).map(level).collect()
}
