//! What is free in the matrices: all of them, or the derivatives of the lateral equations; and the lags.

use nalgebra::{DMatrix, DVector};

use super::black_box::BlackBox;
use super::cells::{Matrices, Sizes};
use super::options::Lag;
use crate::model::lateral_equations::{LateralEquations, Prior, STATES, Sampled};

/// The form of the equations.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    BlackBox(BlackBox),
    Lateral(LateralEquations),
}

/// Form and lags: parameters are those of the form, then each free lag.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parametrisation {
    pub(super) form: Form,
    pub(super) sensor_lags: Vec<Lag>,
    pub(super) input_lags: Vec<Lag>,
}

/// How large lags are expected to be, in s: records alone determine them weakly.
const TYPICAL_LAG: f64 = 0.2;

impl Parametrisation {
    fn of_form(&self) -> usize {
        match &self.form {
            Form::BlackBox(form) => form.parameters(),
            Form::Lateral(form) => form.parameters(),
        }
    }

    pub(super) fn sizes(&self) -> Sizes {
        match &self.form {
            Form::BlackBox(form) => form.sizes,
            Form::Lateral(form) => {
                Sizes { states: STATES, sensors: form.reads.len(), inputs: form.inputs }
            }
        }
    }

    /// The cells of the free lags.
    pub(super) fn free_lags(&self) -> Vec<usize> {
        let sizes = self.sizes();
        let sensors = self.sensor_lags.iter().enumerate();
        let inputs = self.input_lags.iter().enumerate();
        let sensors = sensors.filter(|(_, lag)| **lag == Lag::Free);
        let inputs = inputs.filter(|(_, lag)| **lag == Lag::Free);
        let sensors = sensors.map(|(sensor, _)| sizes.sensor_lag(sensor));
        sensors.chain(inputs.map(|(input, _)| sizes.input_lag(input))).collect()
    }

    pub(super) fn parameters(&self) -> usize {
        self.of_form() + self.free_lags().len()
    }

    /// Numbers that the records can determine: those of the form without changes of basis, and the lags.
    pub(super) fn identifiable(&self) -> usize {
        let invariant = match &self.form {
            Form::BlackBox(form) => form.sizes.states * form.sizes.states,
            Form::Lateral(_) => 0,
        };
        self.parameters() - invariant
    }

    /// `None` where the parameters make no system.
    pub(super) fn matrices(&self, parameters: &DVector<f64>) -> Option<Matrices> {
        let own = parameters.rows(0, self.of_form()).into_owned();
        let mut matrices = match &self.form {
            Form::BlackBox(form) => form.matrices(&own)?,
            Form::Lateral(form) => without_lags(form.sampled(&own)?),
        };
        let mut free = parameters.iter().skip(self.of_form());
        let mut value = |lag: &Lag| match lag {
            Lag::Given(seconds) => *seconds,
            Lag::Free => free.next().copied().unwrap_or_default(),
        };
        matrices.sensor_lags = self.sensor_lags.iter().map(&mut value).collect();
        matrices.input_lags = self.input_lags.iter().map(&mut value).collect();
        matrices.is_finite().then_some(matrices)
    }

    /// The derivatives of all cells by all parameters.
    pub(super) fn tangent(&self, parameters: &DVector<f64>) -> Option<DMatrix<f64>> {
        let own = parameters.rows(0, self.of_form()).into_owned();
        let of_form = match &self.form {
            Form::BlackBox(form) => form.tangent(&own)?,
            Form::Lateral(form) => form.tangent(&own)?,
        };
        let mut tangent = DMatrix::zeros(self.sizes().count(), self.parameters());
        tangent.view_mut((0, 0), of_form.shape()).copy_from(&of_form);
        for (place, cell) in self.free_lags().into_iter().enumerate() {
            tangent[(cell, self.of_form() + place)] = 1.0;
        }
        Some(tangent)
    }

    pub(super) fn priors(&self, parameters: &DVector<f64>) -> Vec<Prior> {
        let mut priors = match &self.form {
            Form::BlackBox(_) => Vec::new(),
            Form::Lateral(form) => form.priors(parameters),
        };
        priors.extend((self.of_form()..self.parameters()).map(|parameter| Prior {
            deviation: parameters[parameter] / TYPICAL_LAG,
            parameter,
            slope: 1.0 / TYPICAL_LAG,
        }));
        priors
    }
}

fn without_lags(sampled: Sampled) -> Matrices {
    let Sampled { a, b, c, d } = sampled;
    let (sensor_lags, input_lags) = (vec![0.0; c.nrows()], vec![0.0; b.ncols()]);
    Matrices { a, b, c, d, sensor_lags, input_lags }
}
