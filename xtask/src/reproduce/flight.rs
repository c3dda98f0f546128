//! The flights of part VI: the paper's aircraft, once with the aileron and once with the rudder moving, and what is made of the records.

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use reconstruct::{AsPrinted, AsPrintedOptions, Channel, Record, as_printed};

use crate::TaskError;

/// Samples of each record. The paper does not say how many it used.
const SAMPLES: usize = 2000;
/// Seconds between two samples, as in the paper.
const PERIOD_S: f64 = 0.1;
/// Seeds of the two excitations.
const SEEDS: [u64; 2] = [1, 2];

/// Everything that several parts of the reproduction look at.
pub(crate) struct Flight {
    pub(crate) model: LateralModel,
    /// Continuous time, inputs aileron and rudder, the rudder's side force as printed; outputs sideslip, roll rate, yaw rate.
    pub(crate) continuous: StateSpace<Continuous>,
    /// The same, sampled.
    pub(crate) discrete: StateSpace<Discrete>,
    /// Aileron record, rudder record.
    pub(crate) records: [Record; 2],
    pub(crate) result: AsPrinted,
}

/// The three sensors, in the order of the records' channels.
pub(crate) const SENSORS: [LateralState; 3] =
    [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];

impl Flight {
    pub(crate) fn simulate() -> Result<Self, TaskError> {
        let Aircraft { model, continuous, discrete } = sampled_aircraft()?;
        let records = [record("aileron", 0, &discrete)?, record("rudder", 1, &discrete)?];
        let result = as_printed(&records, &AsPrintedOptions::default())
            .map_err(TaskError::computation("reconstruction"))?;
        Ok(Self { model, continuous, discrete, records, result })
    }
}

/// The paper's aircraft with its two surfaces and three sensors.
pub(crate) struct Aircraft {
    pub(crate) model: LateralModel,
    pub(crate) continuous: StateSpace<Continuous>,
    pub(crate) discrete: StateSpace<Discrete>,
}

/// The model, in continuous time and sampled. Inputs aileron and rudder, outputs sideslip, roll rate, yaw rate.
pub(crate) fn sampled_aircraft() -> Result<Aircraft, TaskError> {
    const PART: &str = "aircraft";
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)
            .map_err(TaskError::computation(PART))?;
    let continuous = model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &SENSORS)
        .map_err(TaskError::computation(PART))?;
    let period = SamplePeriod::new(PERIOD_S).map_err(TaskError::computation(PART))?;
    let discrete = continuous.zoh(period).map_err(TaskError::computation(PART))?;
    Ok(Aircraft { model, continuous, discrete })
}

/// A record from rest with white Gaussian excitation of unit variance through one input.
fn record(name: &str, input: usize, system: &StateSpace<Discrete>) -> Result<Record, TaskError> {
    let fault = TaskError::computation::<String>("simulation");
    let mut random = ChaCha8Rng::seed_from_u64(SEEDS[input]);
    let excitation = DMatrix::from_fn(1, SAMPLES, |_, _| StandardNormal.sample(&mut random));
    let driven =
        system.subsystem(&[0, 1, 2], &[input]).map_err(|error| fault(error.to_string()))?;
    let simulation =
        driven.simulate(&excitation, None).map_err(|error| fault(error.to_string()))?;
    let channels = ["beta", "p", "r"]
        .iter()
        .enumerate()
        .map(|(row, name)| {
            Channel::new(*name, simulation.outputs.row(row).iter().copied().collect())
        })
        .collect();
    Record::new(name, system.period(), channels).map_err(|error| fault(error.to_string()))
}
