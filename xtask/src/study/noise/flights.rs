//! The records of a case: the paper's aircraft, moved through the aileron in one record and through the rudder in the other, with noise.

use lti::{Continuous, Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use num_complex::Complex;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use reconstruct::{Channel, Record, SharedModel};

use super::case::{Case, Excitation};
use crate::TaskError;
use crate::reproduce::flight::sampled_aircraft;

const PART: &str = "records";
const SENSORS: [&str; 3] = ["beta", "p", "r"];
const SURFACES: [&str; 2] = ["aileron", "rudder"];

/// Corner of the band-limited excitation in rad/s: 1 Hz, beyond what a pilot does.
const CORNER_RAD_S: f64 = std::f64::consts::TAU;
/// Steps of the simulation between two samples where the excitation is not held.
const SUBSTEPS: usize = 20;
/// The multistep: its first step, samples of a single step (0.7 s), lengths and signs.
const FIRST_STEP: usize = 10;
const STEP: usize = 7;
const STEPS: [(usize, f64); 4] = [(3, 1.0), (2, -1.0), (1, 1.0), (1, -1.0)];

/// The eigenvalues that a reconstruction is to find, in 1/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrueModes {
    pub(crate) spiral: Complex<f64>,
    pub(crate) roll: Complex<f64>,
    /// The one with positive imaginary part.
    pub(crate) dutch_roll: Complex<f64>,
}

impl TrueModes {
    /// Spiral, roll, Dutch roll.
    pub(crate) fn list(&self) -> [Complex<f64>; 3] {
        [self.spiral, self.roll, self.dutch_roll]
    }
}

/// Two records, and the noise in them.
pub(crate) struct Pair {
    pub(crate) records: [Record; 2],
    /// Standard deviation of each sensor's noise, the same in both records: from the mean of the signal's root mean squares in the two, each
    /// about its own mean.
    pub(crate) levels: Vec<f64>,
    /// Sensors that the methods are told to read the excitation directly. None, as by default.
    pub(crate) direct: Vec<usize>,
}

/// Makes records.
pub(crate) struct Simulator {
    discrete: StateSpace<Discrete>,
    /// For each surface, noise to sensors, through a low-pass filter in continuous time.
    filtered: Vec<StateSpace<Discrete>>,
    modes: TrueModes,
}

impl Simulator {
    pub(crate) fn new() -> Result<Self, TaskError> {
        let aircraft = sampled_aircraft()?;
        let period = aircraft.discrete.period().seconds();
        let fine =
            SamplePeriod::new(period / count(SUBSTEPS)).map_err(TaskError::computation(PART))?;
        let filtered = (0..SURFACES.len()).map(|surface| {
            let system = behind_filter(&aircraft.continuous, surface)?;
            system.zoh(fine).map_err(TaskError::computation(PART))
        });
        let filtered = filtered.collect::<Result<_, _>>()?;
        let poles = aircraft.continuous.poles().map_err(TaskError::computation(PART))?;
        Ok(Self { discrete: aircraft.discrete, filtered, modes: told_apart(&poles)? })
    }

    pub(crate) fn modes(&self) -> TrueModes {
        self.modes
    }

    /// The system as the methods see it.
    pub(crate) fn truth(&self) -> SharedModel {
        let column = |surface| self.discrete.b().column(surface).into_owned();
        SharedModel {
            a: self.discrete.a().clone(),
            c: self.discrete.c().clone(),
            b: (0..SURFACES.len()).map(column).collect(),
            feedthrough: None,
            period: self.discrete.period(),
        }
    }

    /// The records of a case. Excitation and noise depend on its seed alone, so that records of one seed differ only in the size of the noise.
    pub(crate) fn fly(&self, case: &Case) -> Result<Pair, TaskError> {
        self.fly_at(case.excitation, f64::from(case.signal_to_noise), case.seed)
    }

    /// The same for any signal to noise ratio; infinity is no noise.
    pub(crate) fn fly_at(
        &self,
        excitation: Excitation,
        signal_to_noise: f64,
        seed: u64,
    ) -> Result<Pair, TaskError> {
        let clean = [self.clean(excitation, seed, 0)?, self.clean(excitation, seed, 1)?];
        let levels: Vec<f64> = (0..SENSORS.len())
            .map(|sensor| {
                let deviations = clean.iter().map(|y| y.row(sensor).variance().sqrt());
                deviations.sum::<f64>() / count(clean.len()) / signal_to_noise
            })
            .collect();
        let noisy = |surface: usize| {
            let y = &clean[surface];
            let mut random = stream(seed, 2 + surface as u64);
            let noise: DMatrix<f64> = normal(SENSORS.len(), y.ncols(), &mut random);
            let channels = SENSORS.iter().enumerate().map(|(sensor, name)| {
                let level = levels[sensor];
                let value = |k| y[(sensor, k)] + level * noise[(sensor, k)];
                Channel::new(*name, (0..y.ncols()).map(value).collect())
            });
            Record::new(SURFACES[surface], self.discrete.period(), channels.collect())
                .map_err(TaskError::computation(PART))
        };
        Ok(Pair { records: [noisy(0)?, noisy(1)?], levels, direct: Vec::new() })
    }

    /// What the sensors would read without noise: one row each.
    fn clean(
        &self,
        excitation: Excitation,
        seed: u64,
        surface: usize,
    ) -> Result<DMatrix<f64>, TaskError> {
        let samples = excitation.samples();
        let mut random = stream(seed, surface as u64);
        let input = match excitation {
            Excitation::White => normal(1, samples, &mut random),
            Excitation::Autoregressive => autoregressive(normal(1, samples, &mut random)),
            Excitation::Multistep => multistep(samples),
            Excitation::BandLimited => {
                let input = normal(1, samples * SUBSTEPS, &mut random);
                let simulation = self.filtered[surface]
                    .simulate(&input, None)
                    .map_err(TaskError::computation(PART))?;
                let fine = simulation.outputs;
                return Ok(DMatrix::from_fn(fine.nrows(), samples, |i, k| fine[(i, k * SUBSTEPS)]));
            }
        };
        let system = self
            .discrete
            .subsystem(&[0, 1, 2], &[surface])
            .map_err(TaskError::computation(PART))?;
        let simulation = system.simulate(&input, None).map_err(TaskError::computation(PART))?;
        Ok(simulation.outputs)
    }
}

/// Independent streams of one seed.
fn stream(seed: u64, number: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(number);
    random
}

fn normal(rows: usize, columns: usize, random: &mut ChaCha8Rng) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| StandardNormal.sample(random))
}

fn autoregressive(mut signal: DMatrix<f64>) -> DMatrix<f64> {
    const POLE: f64 = 0.9;
    for k in 1..signal.ncols() {
        signal[k] = POLE * signal[k - 1] + (1.0 - POLE * POLE).sqrt() * signal[k];
    }
    signal
}

fn multistep(samples: usize) -> DMatrix<f64> {
    let mut signal = DMatrix::zeros(1, samples);
    let mut at = FIRST_STEP;
    for (length, sign) in STEPS {
        for _ in 0..length * STEP {
            signal[at] = sign;
            at += 1;
        }
    }
    signal
}

/// White noise through a Butterworth filter of fourth order to one surface, and on to the sensors.
fn behind_filter(
    aircraft: &StateSpace<Continuous>,
    surface: usize,
) -> Result<StateSpace<Continuous>, TaskError> {
    const FILTER: usize = 4;
    let n = aircraft.order();
    let mut a = DMatrix::zeros(n + FILTER, n + FILTER);
    a.view_mut((0, 0), (n, n)).copy_from(aircraft.a());
    // The second section's output moves the surface.
    a.view_mut((0, n + 2), (n, 1)).copy_from(&aircraft.b().column(surface));
    let square = CORNER_RAD_S * CORNER_RAD_S;
    for (section, angle) in
        [(n, std::f64::consts::FRAC_PI_8), (n + 2, 3.0 * std::f64::consts::FRAC_PI_8)]
    {
        a[(section, section + 1)] = 1.0;
        a[(section + 1, section)] = -square;
        a[(section + 1, section + 1)] = -2.0 * angle.cos() * CORNER_RAD_S;
    }
    a[(n + 3, n)] = square;
    let mut b = DMatrix::zeros(n + FILTER, 1);
    b[(n + 1, 0)] = square;
    let mut c = DMatrix::zeros(aircraft.outputs(), n + FILTER);
    c.view_mut((0, 0), (aircraft.outputs(), n)).copy_from(aircraft.c());
    let d = DMatrix::zeros(aircraft.outputs(), 1);
    StateSpace::<Continuous>::new(a, b, c, d).map_err(TaskError::computation(PART))
}

/// Of the two real eigenvalues the roll mode is the faster one.
fn told_apart(poles: &[Complex<f64>]) -> Result<TrueModes, TaskError> {
    let mut real: Vec<_> = poles.iter().filter(|s| s.im.abs() <= 0.0).copied().collect();
    real.sort_by(|x, y| x.re.total_cmp(&y.re));
    let upper: Vec<_> = poles.iter().filter(|s| s.im > 0.0).copied().collect();
    match (real.as_slice(), upper.as_slice()) {
        ([roll, spiral], [dutch_roll]) => {
            Ok(TrueModes { spiral: *spiral, roll: *roll, dutch_roll: *dutch_roll })
        }
        _ => Err(TaskError::Computation {
            part: PART,
            message: format!("not two real eigenvalues and one pair: {poles:?}"),
        }),
    }
}

pub(super) fn count(number: usize) -> f64 {
    u32::try_from(number).map_or(f64::INFINITY, f64::from)
}

#[cfg(test)]
mod tests;
