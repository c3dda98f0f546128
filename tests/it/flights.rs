//! Simulated flights of the paper's aircraft, as files.

use std::fmt::Write;

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use lti::SamplePeriod;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Who moves what, and what the sensors add.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flight {
    /// Standard deviations of the deflections, moved independently: aileron, rudder.
    pub(crate) moved: [f64; 2],
    pub(crate) samples: usize,
    pub(crate) period_s: f64,
    /// Standard deviation of the noise of beta, p and r.
    pub(crate) levels: [f64; 3],
    pub(crate) seed: u64,
}

/// A hundredth of the sensors' deviations under a white excitation.
pub(crate) const LEVELS: [f64; 3] = [0.03, 0.076, 0.059];

pub(crate) const AILERON: Flight =
    Flight { moved: [1.0, 0.0], samples: 1500, period_s: 0.1, levels: LEVELS, seed: 1 };
pub(crate) const RUDDER: Flight = Flight { moved: [0.0, 1.0], seed: 2, ..AILERON };
/// Nobody moves anything.
pub(crate) const QUIET: Flight = Flight { moved: [0.0, 0.0], seed: 3, ..AILERON };

impl Flight {
    /// The columns time, beta, p, r, aileron and rudder.
    pub(crate) fn columns(&self) -> [Vec<f64>; 6] {
        let entry = catalog::PAPER_AIRCRAFT;
        let model = LateralModel::new(entry.derivatives, entry.inertia).unwrap();
        let sensors = [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];
        let system = model
            .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &sensors)
            .unwrap()
            .zoh(SamplePeriod::new(self.period_s).unwrap())
            .unwrap();
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
        let mut inputs = DMatrix::zeros(2, self.samples);
        for (surface, deviation) in self.moved.into_iter().enumerate() {
            for k in 0..self.samples {
                inputs[(surface, k)] = deviation * normal();
            }
        }
        let outputs = system.simulate(&inputs, None).unwrap().outputs;
        let sensor = |index: usize, normal: &mut dyn FnMut() -> f64| -> Vec<f64> {
            let level = self.levels[index];
            outputs.row(index).iter().map(|value| value + level * normal()).collect()
        };
        let time = (0..self.samples).map(|k| f64::from(u32::try_from(k).unwrap()) * self.period_s);
        let input = |index: usize| inputs.row(index).iter().copied().collect();
        [
            time.collect(),
            sensor(0, &mut normal),
            sensor(1, &mut normal),
            sensor(2, &mut normal),
            input(0),
            input(1),
        ]
    }

    /// The file with these columns under their names.
    pub(crate) fn csv(&self) -> String {
        table("time,beta,p,r,aileron,rudder", &self.columns())
    }
}

/// A text of columns, with all digits.
pub(crate) fn table(header: &str, columns: &[Vec<f64>]) -> String {
    let mut text = format!("{header}\n");
    for row in 0..columns[0].len() {
        for (index, column) in columns.iter().enumerate() {
            let comma = if index > 0 { "," } else { "" };
            let _ = write!(text, "{comma}{}", column[row]);
        }
        text.push('\n');
    }
    text
}
