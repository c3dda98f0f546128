//! The part of an excitation that moves on straight between samples which the sensors read directly.

use nalgebra::DMatrix;

use super::parameters::{Layout, System};
use crate::model::Hold;
use crate::model::triangle_hold::TriangleHold;

/// d_j of the sensors whose entries are not free.
pub(crate) struct FirstOrder(TriangleHold);

impl FirstOrder {
    /// `None` where an eigenvalue of A is negative and hits a point of the rule.
    pub(crate) fn new(a: &DMatrix<f64>) -> Option<Self> {
        TriangleHold::new(a).map(Self)
    }

    /// Sets the entries of d_j that are not free.
    pub(crate) fn tie(&self, system: &mut System, layout: &Layout) {
        for record in 0..layout.records {
            let read = &system.c * (&self.0.k * &system.b[record]);
            for sensor in tied(layout) {
                system.d[record][sensor] = read[sensor];
            }
        }
    }

    /// The derivatives of a record's cells (A, C, b, d) by its parameters (A, C, b, the free entries of d).
    pub(crate) fn tangent(&self, system: &System, record: usize, layout: &Layout) -> DMatrix<f64> {
        let (n, m) = (layout.order, layout.sensors);
        let b = &system.b[record];
        let (before, own) = (layout.shared() + n, layout.feedthrough.len());
        let mut tangent = DMatrix::zeros(before + m, before + own);
        tangent.view_mut((0, 0), (before, before)).fill_with_identity();
        for (place, &sensor) in layout.feedthrough.iter().enumerate() {
            tangent[(before + sensor, before + place)] = 1.0;
        }
        let driven = &self.0.k * b;
        let weights = &system.c * &self.0.k;
        for sensor in tied(layout) {
            let row = before + sensor;
            let slope = self.0.slope(&system.c.row(sensor).into_owned(), b);
            for (k, entry) in slope.iter().enumerate() {
                tangent[(row, k)] = *entry;
            }
            for l in 0..n {
                tangent[(row, n * n + l * m + sensor)] = driven[l];
                tangent[(row, n * (n + m) + l)] = weights[(sensor, l)];
            }
        }
        tangent
    }
}

/// The sensors whose entry of d_j follows from the hold.
fn tied(layout: &Layout) -> impl Iterator<Item = usize> {
    let free = &layout.feedthrough;
    let all = if layout.hold == Hold::FirstOrder { layout.sensors } else { 0 };
    (0..all).filter(move |sensor| !free.contains(sensor))
}

#[cfg(test)]
mod tests;
