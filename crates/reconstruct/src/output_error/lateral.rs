//! The lateral equations of an aircraft: states beta, p, r, phi, with dimensional derivatives as parameters.
//!
//! ```text
//! beta' = Y_beta beta + Y_p p + Y_r r + (g/U) phi + Y_delta delta
//! p'    = L_beta beta + L_p p + L_r r             + L_delta delta
//! r'    = N_beta beta + N_p p + N_r r             + N_delta delta
//! phi'  =                   p + tan(theta) r
//! ```
//!
//! Y_r stands for what is usually written Y_r - 1, Y_p for Y_p + sin(alpha), g/U for (g/U) cos(theta); products of inertia are within L and N. Records determine
//! the moments well; Y_p, Y_r, g/U and tan(theta) hardly matter to what sensors read, and are held near what they are in flight.

use lti::exponential;
use nalgebra::{DMatrix, DVector};

use super::cells::{Matrices, Sizes};
use super::parametrisation::Prior;
use crate::likelihood::Hold;

/// Which sensor reads which state.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LateralEquations {
    /// For each sensor the state that it reads: 0 beta, 1 p, 2 r, 3 phi.
    pub(super) reads: Vec<usize>,
    pub(super) inputs: usize,
    pub(super) hold: Hold,
    /// In s.
    pub(super) period: f64,
}

/// The names of the derivatives, in the order of the parameters; control derivatives follow, Y, L, N of each input.
pub(super) const NAMES: [&str; 11] =
    ["Y_beta", "Y_p", "Y_r", "g/U", "L_beta", "L_p", "L_r", "N_beta", "N_p", "N_r", "tan(theta)"];
pub(super) const G_OVER_U: usize = 3;
const TAN_THETA: usize = 10;
const STATES: usize = 4;
const MOMENTS: usize = 3;

/// The states, as sensors are called.
pub(super) const STATE_NAMES: [&str; STATES] = ["beta", "p", "r", "phi"];

impl LateralEquations {
    /// `None` unless the sensors read beta, p and r, and nothing but these and phi.
    pub(super) fn new(names: &[&str], inputs: usize, hold: Hold, period: f64) -> Option<Self> {
        let state =
            |name: &&str| STATE_NAMES.iter().position(|state| state.eq_ignore_ascii_case(name));
        let reads = names.iter().map(state).collect::<Option<Vec<_>>>()?;
        let complete = (0..MOMENTS).all(|needed| reads.contains(&needed));
        complete.then_some(Self { reads, inputs, hold, period })
    }

    pub(super) fn sizes(&self) -> Sizes {
        Sizes { states: STATES, sensors: self.reads.len(), inputs: self.inputs }
    }

    pub(super) fn parameters(&self) -> usize {
        NAMES.len() + MOMENTS * self.inputs
    }

    /// The place of a control derivative: row 0 for Y, 1 for L, 2 for N.
    pub(super) fn control(row: usize, input: usize) -> usize {
        NAMES.len() + MOMENTS * input + row
    }

    /// A and B of the equations as they stand above.
    pub(super) fn continuous(&self, parameters: &DVector<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
        let p = parameters;
        #[rustfmt::skip]
        let a = DMatrix::from_row_slice(STATES, STATES, &[
            p[0], p[1], p[2], p[G_OVER_U],
            p[4], p[5], p[6], 0.0,
            p[7], p[8], p[9], 0.0,
            0.0, 1.0, p[TAN_THETA], 0.0,
        ]);
        let b = DMatrix::from_fn(STATES, self.inputs, |row, input| {
            if row < MOMENTS { p[Self::control(row, input)] } else { 0.0 }
        });
        (a, b)
    }

    pub(super) fn matrices(&self, parameters: &DVector<f64>) -> Option<Matrices> {
        let (a, b) = self.continuous(parameters);
        let (n, inputs) = (STATES, self.inputs);
        // exp [A T, B T, 0; 0, 0, I; 0, 0, 0] holds the responses to a step and to a ramp within one period.
        let mut all = DMatrix::zeros(n + 2 * inputs, n + 2 * inputs);
        all.view_mut((0, 0), (n, n)).copy_from(&(a * self.period));
        all.view_mut((0, n), (n, inputs)).copy_from(&(b * self.period));
        all.view_mut((n, n + inputs), (inputs, inputs)).fill_with_identity();
        let all = exponential(&all).ok()?;
        let a = all.view((0, 0), (n, n)).into_owned();
        let step = all.view((0, n), (n, inputs)).into_owned();
        let ramp = all.view((0, n + inputs), (n, inputs)).into_owned();
        let c = DMatrix::from_fn(self.reads.len(), n, |sensor, state| {
            if self.reads[sensor] == state { 1.0 } else { 0.0 }
        });
        let (b, d) = match self.hold {
            Hold::ZeroOrder => (step, DMatrix::zeros(self.reads.len(), inputs)),
            Hold::FirstOrder => (step - &ramp + &a * &ramp, &c * ramp),
        };
        let (sensor_lags, input_lags) = (vec![0.0; self.reads.len()], vec![0.0; inputs]);
        Some(Matrices { a, b, c, d, sensor_lags, input_lags })
    }

    /// The derivatives of all cells by all parameters, by central differences.
    pub(super) fn tangent(&self, parameters: &DVector<f64>) -> Option<DMatrix<f64>> {
        const STEP: f64 = 1e-5;
        const LEAST: f64 = 0.1;
        let mut tangent = DMatrix::zeros(self.sizes().count(), self.parameters());
        for parameter in 0..self.parameters() {
            let step = STEP * parameters[parameter].abs().max(LEAST);
            let at = |step: f64| {
                let mut moved = parameters.clone();
                moved[parameter] += step;
                self.matrices(&moved).map(|matrices| DVector::from_vec(matrices.entries()))
            };
            tangent.set_column(parameter, &((at(step)? - at(-step)?) / (2.0 * step)));
        }
        Some(tangent)
    }

    /// What is known of any aircraft in flight.
    pub(super) fn priors(&self, parameters: &DVector<f64>) -> Vec<Prior> {
        // Parameter, expected value, standard deviation.
        const LOOSE: [(usize, f64, f64); 3] =
            [(1, 0.07, 0.1), (2, -1.0, 0.05), (TAN_THETA, 0.05, 0.1)];
        const USUAL_G_OVER_U: f64 = 0.08;
        const FACTOR: f64 = 0.8;
        let mut priors: Vec<Prior> = LOOSE
            .iter()
            .map(|&(parameter, expected, deviation)| Prior {
                deviation: (parameters[parameter] - expected) / deviation,
                parameter,
                slope: 1.0 / deviation,
            })
            .collect();
        // Between a glider and a jet.
        let ratio = parameters[G_OVER_U].max(1e-6);
        priors.push(Prior {
            deviation: (ratio / USUAL_G_OVER_U).ln() / FACTOR,
            parameter: G_OVER_U,
            slope: 1.0 / (FACTOR * ratio),
        });
        priors
    }
}
