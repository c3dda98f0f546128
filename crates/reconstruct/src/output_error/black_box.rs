//! A system of so many states of which nothing else is known: all entries of A, B and C are free.

use nalgebra::{DMatrix, DVector};

use super::cells::{Matrices, Sizes};
use crate::likelihood::Hold;
use crate::model::triangle_hold::TriangleHold;

/// All of A, B, C, and the rows of D of sensors with a feedthrough; the other rows follow from the hold.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BlackBox {
    pub(super) sizes: Sizes,
    pub(super) hold: Hold,
    /// Sensors that read inputs directly.
    pub(super) feedthrough: Vec<usize>,
}

impl BlackBox {
    pub(super) fn parameters(&self) -> usize {
        self.sizes.d(0, 0) + self.feedthrough.len() * self.sizes.inputs
    }

    /// The parameters of these matrices; entries of D that are not free are dropped.
    pub(super) fn of(&self, matrices: &Matrices) -> DVector<f64> {
        let entries = matrices.entries();
        let own = entries[..self.sizes.d(0, 0)].iter().copied();
        let direct = self.free().map(|(sensor, input)| matrices.d[(sensor, input)]);
        DVector::from_vec(own.chain(direct).collect())
    }

    /// The entries of D that are parameters.
    fn free(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.sizes.inputs)
            .flat_map(|input| self.feedthrough.iter().map(move |&sensor| (sensor, input)))
    }

    /// The sensors whose rows of D follow from the hold.
    fn tied(&self) -> impl Iterator<Item = usize> {
        let all = if self.hold == Hold::FirstOrder { self.sizes.sensors } else { 0 };
        (0..all).filter(|sensor| !self.feedthrough.contains(sensor))
    }

    pub(super) fn matrices(&self, parameters: &DVector<f64>) -> Option<Matrices> {
        let Sizes { states, sensors, inputs } = self.sizes;
        let all = parameters.as_slice();
        let (a, rest) = all.split_at(states * states);
        let (b, rest) = rest.split_at(states * inputs);
        let (c, direct) = rest.split_at(sensors * states);
        let mut matrices = Matrices {
            a: DMatrix::from_column_slice(states, states, a),
            b: DMatrix::from_column_slice(states, inputs, b),
            c: DMatrix::from_column_slice(sensors, states, c),
            d: DMatrix::zeros(sensors, inputs),
            sensor_lags: vec![0.0; sensors],
            input_lags: vec![0.0; inputs],
        };
        if self.hold == Hold::FirstOrder {
            let read = &matrices.c * TriangleHold::new(&matrices.a)?.k * &matrices.b;
            for sensor in self.tied() {
                matrices.d.set_row(sensor, &read.row(sensor));
            }
        }
        for ((sensor, input), &value) in self.free().zip(direct) {
            matrices.d[(sensor, input)] = value;
        }
        Some(matrices)
    }

    /// The derivatives of all cells by all parameters.
    pub(super) fn tangent(&self, parameters: &DVector<f64>) -> Option<DMatrix<f64>> {
        let sizes = self.sizes;
        let before = sizes.d(0, 0);
        let mut tangent = DMatrix::zeros(sizes.count(), self.parameters());
        tangent.view_mut((0, 0), (before, before)).fill_with_identity();
        for (place, (sensor, input)) in self.free().enumerate() {
            tangent[(sizes.d(sensor, input), before + place)] = 1.0;
        }
        if self.hold == Hold::FirstOrder {
            let matrices = self.matrices(parameters)?;
            let hold = TriangleHold::new(&matrices.a)?;
            let (driven, weights) = (&hold.k * &matrices.b, &matrices.c * &hold.k);
            for sensor in self.tied() {
                let row_of_c = matrices.c.row(sensor).into_owned();
                for input in 0..sizes.inputs {
                    let cell = sizes.d(sensor, input);
                    let column_of_b = matrices.b.column(input).into_owned();
                    let slope = hold.slope(&row_of_c, &column_of_b);
                    for l in 0..sizes.states {
                        for i in 0..sizes.states {
                            tangent[(cell, sizes.a(i, l))] = slope[(i, l)];
                        }
                        tangent[(cell, sizes.c(sensor, l))] = driven[(l, input)];
                        tangent[(cell, sizes.b(l, input))] = weights[(sensor, l)];
                    }
                }
            }
        }
        Some(tangent)
    }
}

#[cfg(test)]
mod tests;
