//! The lateral equations as what is free: derivatives instead of the entries of the matrices, and what is known of them beforehand.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::parameters::{Layout, System};
use super::spectrum::RecordSpectrum;
use crate::model::lateral_equations::{LateralEquations, MOMENTS, NAMES, Prior, STATES};

/// The lateral equations with one unknown control for each record. The parameters are the derivatives of the equations; then for each record the side force of
/// its control and the angle whose cosine and sine are its rolling and its yawing moment.
#[derive(Clone, Debug)]
pub(crate) struct LateralParameters {
    equations: LateralEquations,
    /// The unit of each scaled sensor.
    units: Vec<f64>,
    layout: Layout,
}

/// Side force and angle.
const OF_CONTROL: usize = 2;
/// A control turns the aircraft: its side force is a small part of its moment.
const SIDE_FORCE: f64 = 0.1;

impl LateralParameters {
    /// `None` unless the sensors read beta, p and r, nothing but these and phi, and no excitation directly.
    pub(crate) fn new(names: &[&str], units: &[f64], layout: &Layout, period: f64) -> Option<Self> {
        let equations = LateralEquations::new(names, layout.records, layout.hold, period)?;
        layout.feedthrough.is_empty().then(|| Self {
            equations,
            units: units.to_vec(),
            layout: layout.clone(),
        })
    }

    pub(crate) fn count(&self) -> usize {
        Self::side(self.layout.records)
    }

    /// The sensors that read beta, p and r.
    pub(crate) fn sensors(&self) -> Option<[usize; MOMENTS]> {
        let of = |state: usize| self.equations.reads.iter().position(|&read| read == state);
        Some([of(0)?, of(1)?, of(2)?])
    }

    /// What a sensor reads at frequency k, in its unit.
    pub(crate) fn reading(
        &self,
        spectrum: &RecordSpectrum,
        k: usize,
        sensor: usize,
    ) -> Complex<f64> {
        spectrum.y[k * self.layout.sensors + sensor] * self.units[sensor]
    }

    /// In s.
    pub(crate) fn period(&self) -> f64 {
        self.equations.period
    }

    /// The parameters from derivatives, and Y, L and N of each control.
    pub(crate) fn of_derivatives(
        &self,
        derivatives: &DVector<f64>,
        controls: &[[f64; MOMENTS]],
    ) -> DVector<f64> {
        let mut parameters = DVector::zeros(self.count());
        parameters.rows_mut(0, NAMES.len()).copy_from(&derivatives.rows(0, NAMES.len()));
        for (record, [side, roll, yaw]) in controls.iter().enumerate() {
            let length = roll.hypot(*yaw);
            let part = if length > 0.0 { side / length } else { 0.0 };
            parameters[Self::side(record)] = part.clamp(-SIDE_FORCE, SIDE_FORCE);
            parameters[Self::side(record) + 1] = yaw.atan2(*roll);
        }
        parameters
    }

    /// The side force of a record's control; its angle follows.
    fn side(record: usize) -> usize {
        NAMES.len() + OF_CONTROL * record
    }

    /// The parameters as the equations have them.
    fn of_equations(&self, parameters: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(self.equations.parameters());
        all.rows_mut(0, NAMES.len()).copy_from(&parameters.rows(0, NAMES.len()));
        for record in 0..self.layout.records {
            let place = Self::side(record);
            let (yaw, roll) = parameters[place + 1].sin_cos();
            for (row, value) in [parameters[place], roll, yaw].into_iter().enumerate() {
                all[LateralEquations::control(row, record)] = value;
            }
        }
        all
    }

    /// The system in scaled sensors, with b_j of unit length; `None` where the equations have none.
    pub(crate) fn system(&self, parameters: DVector<f64>) -> Option<System> {
        let sampled = self.equations.sampled(&self.of_equations(&parameters))?;
        let mut c = sampled.c;
        for (mut row, unit) in c.row_iter_mut().zip(&self.units) {
            row /= *unit;
        }
        let d = vec![DVector::zeros(self.layout.sensors); self.layout.records];
        let b = sampled.b.column_iter().map(|column| column.normalize()).collect();
        let system = System { a: sampled.a, c, b, d, derivatives: Some(parameters) };
        system.is_finite().then_some(system)
    }

    /// The derivatives of the entries of A, C, and b_j, in the order of [`Layout`], by the parameters; `None` for a system of other origin.
    pub(crate) fn tangent(&self, system: &System) -> Option<DMatrix<f64>> {
        let parameters = system.derivatives.as_ref()?;
        let entries = self.equations.tangent(&self.of_equations(parameters))?;
        let sampled = self.equations.sampled(&self.of_equations(parameters))?;
        let mut tangent = DMatrix::zeros(self.layout.parameters(), self.count());
        let (a, own) = (STATES * STATES, NAMES.len());
        tangent.view_mut((0, 0), (a, own)).copy_from(&entries.view((0, 0), (a, own)));
        for record in 0..self.layout.records {
            let first = self.layout.shared() + record * self.layout.per_record();
            let b = sampled.b.column(record);
            // A change of b_j but for its length.
            let unit = b.normalize();
            let across = |change: DVector<f64>| (&change - &unit * unit.dot(&change)) / b.norm();
            let of_entries = |k: usize| entries.view((a + record * STATES, k), (STATES, 1));
            for k in 0..own {
                let column = across(of_entries(k).column(0).into_owned());
                tangent.view_mut((first, k), (STATES, 1)).copy_from(&column);
            }
            let place = Self::side(record);
            let (sine, cosine) = parameters[place + 1].sin_cos();
            let [side, roll, yaw] = [0, 1, 2].map(|row| {
                of_entries(LateralEquations::control(row, record)).column(0).into_owned()
            });
            let turned = yaw * cosine - roll * sine;
            tangent.view_mut((first, place), (STATES, 1)).copy_from(&across(side));
            tangent.view_mut((first, place + 1), (STATES, 1)).copy_from(&across(turned));
        }
        Some(tangent)
    }

    /// What is known of any aircraft in flight, and of its controls.
    pub(crate) fn priors(&self, parameters: &DVector<f64>) -> Vec<Prior> {
        let mut priors = self.equations.priors(parameters);
        priors.extend((0..self.layout.records).map(|record| {
            let parameter = Self::side(record);
            let slope = 1.0 / SIDE_FORCE;
            Prior { deviation: parameters[parameter] * slope, parameter, slope }
        }));
        priors
    }
}
