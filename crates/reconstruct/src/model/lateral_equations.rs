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

use super::Hold;

/// Which sensor reads which state.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LateralEquations {
    /// For each sensor the state that it reads: 0 beta, 1 p, 2 r, 3 phi.
    pub(crate) reads: Vec<usize>,
    pub(crate) inputs: usize,
    pub(crate) hold: Hold,
    /// In s.
    pub(crate) period: f64,
}

/// The names of the derivatives, in the order of the parameters; control derivatives follow, Y, L, N of each input.
pub(crate) const NAMES: [&str; 11] =
    ["Y_beta", "Y_p", "Y_r", "g/U", "L_beta", "L_p", "L_r", "N_beta", "N_p", "N_r", "tan(theta)"];
pub(crate) const G_OVER_U: usize = 3;
pub(crate) const TAN_THETA: usize = 10;
pub(crate) const STATES: usize = 4;
pub(crate) const MOMENTS: usize = 3;

/// The states, as sensors are called.
pub(crate) const STATE_NAMES: [&str; STATES] = ["beta", "p", "r", "phi"];

/// x(k+1) = A x(k) + B u(k), y(k) = C x(k) + D u(k).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sampled {
    pub(crate) a: DMatrix<f64>,
    pub(crate) b: DMatrix<f64>,
    pub(crate) c: DMatrix<f64>,
    pub(crate) d: DMatrix<f64>,
}

impl Sampled {
    /// The entries of A, B, C, D, each by columns.
    fn entries(&self) -> Vec<f64> {
        let all = [&self.a, &self.b, &self.c, &self.d];
        all.into_iter().flat_map(DMatrix::iter).copied().collect()
    }
}

/// Something known beforehand about one number: its deviation from what is expected, over the standard deviation of that, and the derivative by one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Prior {
    pub(crate) deviation: f64,
    pub(crate) parameter: usize,
    pub(crate) slope: f64,
}

impl LateralEquations {
    /// `None` unless the sensors read beta, p and r, and nothing but these and phi.
    pub(crate) fn new(names: &[&str], inputs: usize, hold: Hold, period: f64) -> Option<Self> {
        let state =
            |name: &&str| STATE_NAMES.iter().position(|state| state.eq_ignore_ascii_case(name));
        let reads = names.iter().map(state).collect::<Option<Vec<_>>>()?;
        let complete = (0..MOMENTS).all(|needed| reads.contains(&needed));
        complete.then_some(Self { reads, inputs, hold, period })
    }

    pub(crate) fn parameters(&self) -> usize {
        NAMES.len() + MOMENTS * self.inputs
    }

    /// The place of a control derivative: row 0 for Y, 1 for L, 2 for N.
    pub(crate) fn control(row: usize, input: usize) -> usize {
        NAMES.len() + MOMENTS * input + row
    }

    /// A and B of the equations as they stand above.
    pub(crate) fn continuous(&self, parameters: &DVector<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
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

    /// The sampled system; `None` where the equations have none.
    pub(crate) fn sampled(&self, parameters: &DVector<f64>) -> Option<Sampled> {
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
        Some(Sampled { a, b, c, d })
    }

    /// The derivatives of the entries of A, B, C, D, by columns, by all parameters; central differences.
    pub(crate) fn tangent(&self, parameters: &DVector<f64>) -> Option<DMatrix<f64>> {
        const STEP: f64 = 1e-5;
        const LEAST: f64 = 0.1;
        let entries = (STATES + self.reads.len()) * (STATES + self.inputs);
        let mut tangent = DMatrix::zeros(entries, self.parameters());
        for parameter in 0..self.parameters() {
            let step = STEP * parameters[parameter].abs().max(LEAST);
            let at = |step: f64| {
                let mut moved = parameters.clone();
                moved[parameter] += step;
                self.sampled(&moved).map(|sampled| DVector::from_vec(sampled.entries()))
            };
            tangent.set_column(parameter, &((at(step)? - at(-step)?) / (2.0 * step)));
        }
        Some(tangent)
    }

    /// What is known of any aircraft in flight.
    pub(crate) fn priors(&self, parameters: &DVector<f64>) -> Vec<Prior> {
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

/// What is said of records that the equations do not describe, with the reason.
pub(crate) fn contradiction(reason: &str) -> String {
    format!(
        "the lateral equations do not hold: {reason}; an actuator, a damper or a filter may be part of the records, so leave out --structure lateral"
    )
}
