//! The flights: what moves the surfaces, what the gusts do, what the sensors read.

use aircraft::{LateralState, Surface, name_system_modes};
use flight::{
    ContinuousNoise, Stream, add_doublet, add_multistep, behind_low_pass, in_side_gust, normal,
};
use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

use super::aircraft_file::ChosenAircraft;
use super::{Noise, Sensor, SimulateError};
use crate::args::{ExcitationKind, SimulateArgs, SurfaceChoice};
use crate::numbers::whole;

/// The shortest record and the longest: a file of ten million samples has half a gigabyte.
const SAMPLES: std::ops::RangeInclusive<usize> = 2..=10_000_000;
/// Corner of the low-pass excitation: 1 Hz, beyond what a pilot does.
pub(super) const LOW_PASS_RAD_S: f64 = std::f64::consts::TAU;
/// Corner of the gusts' filter. Dryden's is speed over scale of turbulence: 400 ft/s over 400 ft.
pub(super) const GUST_RAD_S: f64 = 1.0;
/// How long gusts blow before a record begins: by then all but a slow spiral mode have forgotten the rest they started from.
const RUN_IN_S: f64 = 60.0;
/// Between the beginnings of two manoeuvres, and before the first.
const MANOEUVRE_EVERY_S: f64 = 15.0;
const FIRST_MANOEUVRE_S: f64 = 1.0;
/// The single step of a 3-2-1-1, and that of a doublet.
const MULTISTEP_S: f64 = 0.7;
const DOUBLET_S: f64 = 1.0;

/// Everything that is known before the first sample.
#[derive(Debug)]
pub(super) struct Simulator<'a> {
    pub(super) aircraft: &'a ChosenAircraft,
    pub(super) args: &'a SimulateArgs,
    pub(super) period: SamplePeriod,
    samples: usize,
    /// Inputs aileron and rudder, outputs the sensors.
    pub(super) continuous: StateSpace<Continuous>,
    discrete: StateSpace<Discrete>,
}

/// Records, and the noise in them.
#[derive(Debug)]
pub(super) struct Flown {
    /// One row for each sensor; one matrix for each record.
    pub(super) readings: Vec<DMatrix<f64>>,
    /// Standard deviation of each sensor's noise, the same in all records.
    pub(super) levels: Vec<f64>,
}

/// One record before it is flown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plan {
    pub(super) name: &'static str,
    pub(super) surfaces: &'static [Surface],
}

const AILERON: Plan = Plan { name: "aileron", surfaces: &[Surface::Aileron] };
const RUDDER: Plan = Plan { name: "rudder", surfaces: &[Surface::Rudder] };
const BOTH: Plan = Plan { name: "both", surfaces: &Surface::ALL };
const QUIET: Plan = Plan { name: "quiet", surfaces: &[] };

/// The records that the words ask for.
pub(super) fn plans(args: &SimulateArgs) -> Vec<Plan> {
    let mut plans = match (args.excitation, args.surface) {
        (ExcitationKind::None, _) => vec![QUIET],
        (_, None) => vec![AILERON, RUDDER],
        (_, Some(SurfaceChoice::Aileron)) => vec![AILERON],
        (_, Some(SurfaceChoice::Rudder)) => vec![RUDDER],
        (_, Some(SurfaceChoice::Both)) => vec![BOTH],
    };
    if args.with_quiet && args.excitation != ExcitationKind::None {
        plans.push(QUIET);
    }
    plans
}

impl<'a> Simulator<'a> {
    /// Checks what was asked for, and samples the aircraft.
    pub(super) fn new(
        aircraft: &'a ChosenAircraft,
        args: &'a SimulateArgs,
    ) -> Result<Self, SimulateError> {
        check(args)?;
        let fault = |error: &dyn std::error::Error| SimulateError::computation(error);
        let period = SamplePeriod::new(args.sample_period).map_err(|error| fault(&error))?;
        let states: Vec<LateralState> = args.outputs.iter().map(|sensor| sensor.state()).collect();
        let continuous = aircraft
            .model
            .state_space(&Surface::ALL, aircraft.scaling, &states)
            .map_err(|error| fault(&error))?;
        let discrete = continuous.zoh(period).map_err(|error| fault(&error))?;
        Ok(Self { aircraft, args, period, samples: samples(args)?, continuous, discrete })
    }

    /// The records' names, in their order.
    pub(super) fn names(&self) -> Vec<&'static str> {
        plans(self.args).iter().map(|plan| plan.name).collect()
    }

    /// Those that records of any flight have.
    pub(super) fn all_names() -> [&'static str; 4] {
        [AILERON, RUDDER, BOTH, QUIET].map(|plan| plan.name)
    }

    pub(super) fn samples(&self) -> usize {
        self.samples
    }

    /// The modes of the aircraft by name.
    pub(super) fn modes(&self) -> Result<Vec<aircraft::NamedMode>, SimulateError> {
        let fault = |error: &dyn std::error::Error| SimulateError::computation(error);
        let whole = self
            .aircraft
            .model
            .state_space(&Surface::ALL, self.aircraft.scaling, &LateralState::ALL)
            .map_err(|error| fault(&error))?;
        name_system_modes(&whole).map_err(|error| fault(&error))
    }

    /// Flies all records. Each draws from streams of its own, so that none depends on which others there are.
    pub(super) fn fly(&self) -> Result<Flown, SimulateError> {
        let plans = plans(self.args);
        let responses =
            plans.iter().map(|plan| self.response(plan)).collect::<Result<Vec<_>, _>>()?;
        let levels = self.levels(&plans, &responses)?;
        let mut readings = Vec::new();
        for (plan, mut y) in plans.iter().zip(responses) {
            if self.args.gust > 0.0 {
                y += self.gust(plan)?;
            }
            let noise = normal(y.nrows(), y.ncols(), &mut self.stream(plan, Purpose::Noise));
            for (mut row, (noise, level)) in y.row_iter_mut().zip(noise.row_iter().zip(&levels)) {
                row += noise * *level;
            }
            if y.iter().any(|value| !value.is_finite()) {
                let reason = format!("the motion in {}.csv leaves the range of numbers", plan.name);
                return Err(SimulateError::Computation { reason });
            }
            readings.push(y);
        }
        Ok(Flown { readings, levels })
    }

    fn stream(&self, plan: &Plan, purpose: Purpose) -> Stream {
        let record = match plan.name {
            "aileron" => 0,
            "rudder" => 1,
            "both" => 2,
            _ => 3,
        };
        Stream::new(self.args.seed, 8 * record + purpose as u64)
    }

    /// What the sensors read without gusts and noise.
    fn response(&self, plan: &Plan) -> Result<DMatrix<f64>, SimulateError> {
        let mut y = DMatrix::zeros(self.args.outputs.len(), self.samples);
        for surface in plan.surfaces {
            let purpose = match surface {
                Surface::Aileron => Purpose::Aileron,
                Surface::Rudder => Purpose::Rudder,
            };
            y += self.moved(*surface, &mut self.stream(plan, purpose))?;
        }
        Ok(y)
    }

    /// The response to one surface.
    fn moved(&self, surface: Surface, random: &mut Stream) -> Result<DMatrix<f64>, SimulateError> {
        let fault = |error: &dyn std::error::Error| SimulateError::computation(error);
        let index = usize::from(surface == Surface::Rudder);
        let size = self.args.amplitude;
        let mut input = DMatrix::zeros(1, self.samples);
        match self.args.excitation {
            ExcitationKind::None => {}
            ExcitationKind::White => input = normal(1, self.samples, random) * size,
            ExcitationKind::Multistep => {
                for (first, side) in self.manoeuvres(random) {
                    add_multistep(&mut input, first, self.steps(MULTISTEP_S), side * size);
                }
            }
            ExcitationKind::Doublet => {
                for (first, side) in self.manoeuvres(random) {
                    add_doublet(&mut input, first, self.steps(DOUBLET_S), side * size);
                }
            }
            ExcitationKind::Lowpass => {
                let filtered = behind_low_pass(&self.continuous, index, LOW_PASS_RAD_S)
                    .map_err(|error| fault(&error))?;
                let noise =
                    ContinuousNoise::new(&filtered, self.period).map_err(|error| fault(&error))?;
                let y = noise.sampled(0, self.samples, random).map_err(|error| fault(&error))?;
                return Ok(y * (size / low_pass_deviation(self.period)));
            }
        }
        let all: Vec<usize> = (0..self.args.outputs.len()).collect();
        let system = self.discrete.subsystem(&all, &[index]).map_err(|error| fault(&error))?;
        let simulation = system.simulate(&input, None).map_err(|error| fault(&error))?;
        Ok(simulation.outputs)
    }

    /// First samples of the manoeuvres, and their sides.
    fn manoeuvres(&self, random: &mut Stream) -> Vec<(usize, f64)> {
        let starts =
            (self.steps(FIRST_MANOEUVRE_S)..self.samples).step_by(self.steps(MANOEUVRE_EVERY_S));
        starts.map(|start| (start, random.normal().signum())).collect()
    }

    /// Whole samples in so many seconds, at least one.
    fn steps(&self, seconds: f64) -> usize {
        whole(seconds / self.period.seconds()).unwrap_or(usize::MAX).clamp(1, *SAMPLES.end())
    }

    /// What gusts add to the sensors.
    fn gust(&self, plan: &Plan) -> Result<DMatrix<f64>, SimulateError> {
        let fault = |error: &dyn std::error::Error| SimulateError::computation(error);
        let gusty = in_side_gust(&self.continuous, GUST_RAD_S).map_err(|error| fault(&error))?;
        let noise = ContinuousNoise::new(&gusty, self.period).map_err(|error| fault(&error))?;
        let y = noise
            .sampled(self.steps(RUN_IN_S), self.samples, &mut self.stream(plan, Purpose::Gust))
            .map_err(|error| fault(&error))?;
        // g(k+1) = e g(k) + (1 - e) n(k) between two steps: variance (1 - e) / (1 + e).
        let decay = (-GUST_RAD_S * substep(self.period)).exp();
        Ok(y * (self.args.gust / ((1.0 - decay) / (1.0 + decay)).sqrt()))
    }

    /// The noise of each sensor, from the records that a surface moves.
    fn levels(
        &self,
        plans: &[Plan],
        responses: &[DMatrix<f64>],
    ) -> Result<Vec<f64>, SimulateError> {
        let sensors = &self.args.outputs;
        match &self.args.noise {
            Noise::Absent => Ok(vec![0.0; sensors.len()]),
            Noise::Levels(levels) => Ok(sensors
                .iter()
                .map(|sensor| {
                    levels.iter().find(|(of, _)| of == sensor).map_or(0.0, |(_, level)| *level)
                })
                .collect()),
            Noise::Ratio(ratio) => {
                let moved: Vec<&DMatrix<f64>> = plans
                    .iter()
                    .zip(responses)
                    .filter(|(plan, _)| !plan.surfaces.is_empty())
                    .map(|(_, y)| y)
                    .collect();
                if moved.is_empty() {
                    return Err(SimulateError::NoSignal { ratio: *ratio });
                }
                let mean = |sensor: usize| {
                    let deviations = moved.iter().map(|y| y.row(sensor).variance().sqrt());
                    deviations.sum::<f64>() / moved.len() as f64
                };
                Ok((0..sensors.len()).map(|sensor| mean(sensor) / ratio).collect())
            }
        }
    }
}

/// What a stream of random numbers is for.
#[derive(Clone, Copy, Debug)]
enum Purpose {
    Aileron = 0,
    Rudder = 1,
    Noise = 2,
    Gust = 3,
}

fn check(args: &SimulateArgs) -> Result<(), SimulateError> {
    if args.excitation == ExcitationKind::None && args.surface.is_some() {
        return Err(SimulateError::NothingMoves { option: "--surface" });
    }
    if args.excitation == ExcitationKind::None
        && let Noise::Ratio(ratio) = args.noise
    {
        return Err(SimulateError::NoSignal { ratio });
    }
    let twice = |index: usize, sensor: &Sensor| args.outputs[..index].contains(sensor);
    if let Some((_, sensor)) =
        args.outputs.iter().enumerate().find(|(index, sensor)| twice(*index, sensor))
    {
        return Err(SimulateError::SensorTwice { sensor: sensor.name() });
    }
    if let Noise::Levels(levels) = &args.noise
        && let Some((sensor, _)) = levels.iter().find(|(sensor, _)| !args.outputs.contains(sensor))
    {
        return Err(SimulateError::NoSuchSensor { sensor: sensor.name() });
    }
    samples(args).map(|_| ())
}

fn samples(args: &SimulateArgs) -> Result<usize, SimulateError> {
    let asked = args.duration / args.sample_period;
    whole(asked).filter(|samples| SAMPLES.contains(samples)).ok_or(SimulateError::Samples {
        duration_s: args.duration,
        period_s: args.sample_period,
        samples: asked.round(),
        least: *SAMPLES.start(),
        most: *SAMPLES.end(),
    })
}

/// Seconds between two steps of the simulation of what is not held.
fn substep(period: SamplePeriod) -> f64 {
    period.seconds() / flight::SUBSTEPS as f64
}

/// Standard deviation of white noise of unit variance behind the low-pass filter: the power that its band lets through.
///
/// Noise held for `h` seconds has the two-sided density `h`, and a Butterworth filter of fourth order with corner `w` the noise bandwidth
/// `w / 8 / sin(pi / 8)` in rad/s per pi.
fn low_pass_deviation(period: SamplePeriod) -> f64 {
    let bandwidth = LOW_PASS_RAD_S / 8.0 / std::f64::consts::FRAC_PI_8.sin();
    (substep(period) * bandwidth).sqrt()
}
