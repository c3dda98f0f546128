//! Eigenvalues and their shapes in the sensors -> modes with names.

use aircraft::{Eigenpair, ModeName, ModeShape, NamedMode, WhyUnnamed, name_modes, name_neutrally};
use num_complex::Complex;
use reconstruct::{FoundMode, Reconstruction, Record};

use crate::CommandError;

/// A mode as a person asks for it.
#[derive(Clone, Debug)]
pub(crate) struct IdentifiedMode {
    pub(crate) named: NamedMode,
    /// Eigenvalues, frequency, damping, and how certain they are where the method says it.
    pub(crate) mode: FoundMode,
    /// The mode's share in each channel, the largest of them 1; empty where nothing tells it.
    pub(crate) shape: Vec<Complex<f64>>,
    /// Largest distance in z between the versions that the differences of transmissibilities have of it; from the paper's method alone.
    pub(crate) spread: Option<f64>,
}

impl IdentifiedMode {
    /// The 95 % interval of a real mode's eigenvalue in 1/s: from the likelihood where that was looked at, otherwise from the deviation. An end may be infinite.
    pub(crate) fn eigenvalue_interval_95(&self) -> Option<[f64; 2]> {
        let around = || {
            let reach = NORMAL_95 * self.mode.estimate.as_ref()?.continuous.real_standard_error();
            let at = self.mode.mode.eigenvalue.re;
            Some([at - reach, at + reach])
        };
        let is_real = self.mode.mode.period_s.is_none();
        self.mode.interval_95.or_else(around).filter(|_| is_real)
    }

    /// The 95 % interval of a real mode's time constant in s: from the likelihood where that was looked at, otherwise from the deviation. `None` where
    /// that of the eigenvalue contains zero.
    pub(crate) fn time_constant_interval_95(&self) -> Option<[f64; 2]> {
        self.mode.mode.time_constant_s?;
        match self.mode.interval_95 {
            Some([low, high]) => (low * high > 0.0).then(|| [-1.0 / low, -1.0 / high]).map(ordered),
            None => self.mode.estimate.as_ref()?.time_constant_interval_95,
        }
    }
}

/// The normal distribution holds 95 % within this many deviations.
const NORMAL_95: f64 = 1.959_963_984_540_054;

fn ordered([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// Names the modes: by their shapes where the channels are called beta, p and r, by the pattern of the eigenvalues where
/// only two of beta, p, r and phi are there, and otherwise neutrally, since nothing says that it is an aircraft.
///
/// Complex pairs come once; the fastest mode comes first.
pub(crate) fn name(
    result: &Reconstruction,
    record: &Record,
) -> Result<Vec<IdentifiedMode>, CommandError> {
    let shapes: Vec<_> = result.modes.iter().map(|mode| shape(result, mode)).collect();
    // A mode that alternates is no motion, and must not take the name of one.
    let still = ModeShape::from_sensors(Complex::ZERO, Complex::ZERO, Complex::ZERO);
    let pair = |(mode, shape): (&FoundMode, &Vec<Complex<f64>>)| Eigenpair {
        eigenvalue: mode.mode.eigenvalue,
        shape: lateral_shape(shape, record)
            .map(|shape| if alternates(mode) { still } else { shape }),
    };
    let pairs: Vec<Eigenpair> = result.modes.iter().zip(&shapes).map(pair).collect();
    let named = if is_of_an_aircraft(record) {
        name_modes(&pairs)
    } else {
        let eigenvalues: Vec<_> = pairs.iter().map(|pair| pair.eigenvalue).collect();
        name_neutrally(&eigenvalues, record.period().seconds() * record.samples() as f64)
    };
    let named = named.map_err(|error| CommandError::Reconstruct(error.to_string()))?;
    let mut found: Vec<IdentifiedMode> = named
        .into_iter()
        .zip(&result.modes)
        .zip(shapes)
        .map(|((mut named, mode), shape)| {
            if alternates(mode) {
                named.name = ModeName::Unnamed(WhyUnnamed::Alternating);
            }
            let (spread, mode) = (spread(result, mode), mode.clone());
            IdentifiedMode { named, spread, mode, shape: scaled(shape) }
        })
        .collect();
    let frequency = |found: &IdentifiedMode| found.mode.mode.natural_frequency_rad_s;
    found.sort_by(|a, b| frequency(b).total_cmp(&frequency(a)));
    Ok(found)
}

/// Whether two channels have the names of lateral sensors.
fn is_of_an_aircraft(record: &Record) -> bool {
    let is_lateral = |name: &str| {
        ["beta", "p", "r", "phi"].iter().any(|sensor| name.eq_ignore_ascii_case(sensor))
    };
    record.channels().iter().filter(|channel| is_lateral(&channel.name)).count() >= 2
}

/// Whether its eigenvalue in z is real and negative: one state, which noise and too high an order make.
fn alternates(mode: &FoundMode) -> bool {
    mode.mode.discrete_eigenvalue.is_some_and(|z| z.im == 0.0 && z.re < 0.0)
}

/// C v with the eigenvector v of A, or what the paper's method says of its own mode.
fn shape(result: &Reconstruction, mode: &FoundMode) -> Vec<Complex<f64>> {
    if let (Some(c), Some(vector)) = (result.readings(), &mode.mode.eigenvector) {
        let reading = |row: usize| {
            let entries = c.row(row);
            entries.iter().zip(vector.iter()).map(|(entry, part)| part * *entry).sum()
        };
        return (0..c.nrows()).map(reading).collect();
    }
    let solution = result.paper();
    let own = solution.and_then(|solution| {
        let distance = |z: Complex<f64>| mode.mode.discrete_eigenvalue.map(|own| (own - z).norm());
        solution.modes.iter().min_by(|a, b| {
            let key = |shared: usize| distance(solution.shared.zeros[shared].value);
            key(a.shared).unwrap_or(0.0).total_cmp(&key(b.shared).unwrap_or(0.0))
        })
    });
    own.map_or_else(Vec::new, |own| own.shape.clone())
}

/// The shape with its largest part 1.
fn scaled(mut shape: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    let largest = shape.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()));
    if let Some(largest) = largest.filter(|largest| largest.norm() > 0.0) {
        shape.iter_mut().for_each(|part| *part /= largest);
    }
    shape
}

/// The spread of the shared zero that the mode comes from.
fn spread(result: &Reconstruction, mode: &FoundMode) -> Option<f64> {
    let z = mode.mode.discrete_eigenvalue?;
    let zeros = &result.paper()?.shared.zeros;
    let closest = zeros.iter().min_by(|a, b| (a.value - z).norm().total_cmp(&(b.value - z).norm()));
    closest.map(|zero| zero.spread)
}

fn lateral_shape(shape: &[Complex<f64>], record: &Record) -> Option<ModeShape> {
    let part = |name: &str| {
        let index =
            record.channels().iter().position(|channel| channel.name.eq_ignore_ascii_case(name))?;
        shape.get(index).copied().filter(|value| value.is_finite())
    };
    Some(ModeShape::from_sensors(part("beta")?, part("p")?, part("r")?))
}
