//! The unknowns of the fit and where each of them stands in the vector of parameters.

use lti::SamplePeriod;
use nalgebra::{DMatrix, DVector};

use crate::SharedModel;
use crate::model::Hold;

/// A, C, and for each record b_j and d_j, in scaled sensors.
#[derive(Clone, Debug)]
pub(crate) struct System {
    pub(crate) a: DMatrix<f64>,
    pub(crate) c: DMatrix<f64>,
    pub(crate) b: Vec<DVector<f64>>,
    /// m entries each; those that are not free are zero, or what the hold makes them (see `first_order_hold.rs`).
    pub(crate) d: Vec<DVector<f64>>,
    /// The parameters that it was made of, where these are not its entries (see `lateral.rs`).
    pub(crate) derivatives: Option<DVector<f64>>,
}

/// The order of the parameters: A by columns, C by columns, then for each record b_j and those entries of d_j that are free.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub(crate) order: usize,
    pub(crate) sensors: usize,
    pub(crate) records: usize,
    /// The sensors that read the excitation directly, each with a free entry of d_j.
    pub(crate) feedthrough: Vec<usize>,
    /// How the excitation moves between samples. Unless it is held, every sensor has an entry of d_j, those without feedthrough one that
    /// follows from A, C and b_j.
    pub(crate) hold: Hold,
}

impl Layout {
    /// Parameters of each record: b_j and the free entries of d_j.
    pub(crate) fn per_record(&self) -> usize {
        self.order + self.feedthrough.len()
    }

    /// Parameters of A and C.
    pub(crate) fn shared(&self) -> usize {
        self.order * (self.order + self.sensors)
    }

    pub(crate) fn parameters(&self) -> usize {
        self.shared() + self.records * self.per_record()
    }

    /// How many changes leave the likelihood as it is: the basis of the states and the scale of each excitation.
    pub(crate) fn invariants(&self) -> usize {
        self.order * self.order + self.records
    }

    /// n J + m n - J, and one more per free entry of d_j.
    pub(crate) fn identifiable(&self) -> usize {
        self.parameters() - self.invariants()
    }

    /// Index in the vector of parameters of local parameter `local` of record `record`: A and C first, then its own b and d.
    pub(crate) fn global(&self, local: usize, record: usize) -> usize {
        if local < self.shared() { local } else { local + record * self.per_record() }
    }

    /// The sensors with an entry of d_j, free or not.
    pub(crate) fn direct(&self) -> Vec<usize> {
        match self.hold {
            Hold::ZeroOrder => self.feedthrough.clone(),
            Hold::FirstOrder => (0..self.sensors).collect(),
        }
    }

    /// A, C and all entries of b_j and d_j as free parameters.
    pub(crate) fn untied(&self) -> Self {
        Self { feedthrough: self.direct(), hold: Hold::ZeroOrder, ..*self }
    }

    /// Adds a matrix over a record's cells to one over all parameters. `tangent` has the derivatives of the cells by the record's parameters, if these
    /// are not the same.
    pub(crate) fn add(
        &self,
        record: usize,
        tangent: Option<&DMatrix<f64>>,
        cells: DMatrix<f64>,
        sum: &mut DMatrix<f64>,
    ) {
        let own = match tangent {
            Some(tangent) => tangent.tr_mul(&cells) * tangent,
            None => cells,
        };
        for k in 0..own.ncols() {
            let column = self.global(k, record);
            for i in 0..own.nrows() {
                sum[(self.global(i, record), column)] += own[(i, k)];
            }
        }
    }

    /// Adds a vector over a record's parameters to one over all of them.
    pub(crate) fn add_vector(&self, record: usize, own: &DVector<f64>, sum: &mut DVector<f64>) {
        for (local, entry) in own.iter().enumerate() {
            sum[self.global(local, record)] += entry;
        }
    }

    /// Each entry of A, C, b and d that is not always zero as (row, column) of [A b; C d]: row i < n is a state, row n + s is sensor s; column n is
    /// the excitation. Under a zero-order hold these are the local parameters.
    pub(crate) fn local_cells(&self) -> Vec<(usize, usize)> {
        let (n, m) = (self.order, self.sensors);
        let a = (0..n).flat_map(move |l| (0..n).map(move |i| (i, l)));
        let c = (0..n).flat_map(move |l| (0..m).map(move |s| (n + s, l)));
        let b = (0..n).map(move |i| (i, n));
        let d = self.direct().into_iter().map(move |s| (n + s, n));
        a.chain(c).chain(b).chain(d).collect()
    }
}

impl System {
    /// A model of the records, its sensors divided by their units.
    pub(crate) fn scaled(model: &SharedModel, units: &[f64], layout: &Layout) -> Self {
        let unit = DVector::from_column_slice(units);
        let mut c = model.c.clone();
        for (mut row, unit) in c.row_iter_mut().zip(units) {
            row /= *unit;
        }
        let d = (0..layout.records).map(|record| {
            let mut d = DVector::zeros(layout.sensors);
            if let Some(feedthrough) = &model.feedthrough {
                for &sensor in &layout.feedthrough {
                    d[sensor] = feedthrough[record][sensor] / unit[sensor];
                }
            }
            d
        });
        Self { a: model.a.clone(), c, b: model.b.clone(), d: d.collect(), derivatives: None }
    }

    /// The model in the sensors' own units.
    pub(crate) fn model(
        &self,
        units: &[f64],
        layout: &Layout,
        period: SamplePeriod,
    ) -> SharedModel {
        let unit = DVector::from_column_slice(units);
        let mut c = self.c.clone();
        for (mut row, unit) in c.row_iter_mut().zip(units) {
            row *= *unit;
        }
        let feedthrough = (!layout.feedthrough.is_empty())
            .then(|| self.d.iter().map(|d| d.component_mul(&unit)).collect());
        SharedModel { a: self.a.clone(), c, b: self.b.clone(), feedthrough, period }
    }

    /// The system after a step in the parameters.
    pub(crate) fn moved(&self, step: &DVector<f64>, layout: &Layout) -> Self {
        let (n, m) = (layout.order, layout.sensors);
        let mut moved = self.clone();
        moved.a += DMatrix::from_column_slice(n, n, &step.as_slice()[..n * n]);
        moved.c += DMatrix::from_column_slice(m, n, &step.as_slice()[n * n..n * (n + m)]);
        for record in 0..layout.records {
            let start = layout.shared() + record * layout.per_record();
            for i in 0..n {
                moved.b[record][i] += step[start + i];
            }
            for (k, &sensor) in layout.feedthrough.iter().enumerate() {
                moved.d[record][sensor] += step[start + n + k];
            }
        }
        moved
    }

    /// The tangents of changes that leave the likelihood as it is, one a column: X A - A X, -C X, X b_j for each unit matrix X, and (b_j, d_j)
    /// for each record.
    pub(crate) fn invariant_tangents(&self, layout: &Layout) -> DMatrix<f64> {
        let (n, m) = (layout.order, layout.sensors);
        let mut tangents = DMatrix::zeros(layout.parameters(), layout.invariants());
        for p in 0..n {
            for q in 0..n {
                // X has a one in row p, column q.
                let mut tangent = tangents.column_mut(p * n + q);
                for l in 0..n {
                    tangent[l * n + p] += self.a[(q, l)];
                    tangent[q * n + l] -= self.a[(l, p)];
                }
                for s in 0..m {
                    tangent[n * n + q * m + s] -= self.c[(s, p)];
                }
                for record in 0..layout.records {
                    tangent[layout.shared() + record * layout.per_record() + p] = self.b[record][q];
                }
            }
        }
        for record in 0..layout.records {
            let start = layout.shared() + record * layout.per_record();
            let mut tangent = tangents.column_mut(n * n + record);
            for i in 0..n {
                tangent[start + i] = self.b[record][i];
            }
            for (k, &sensor) in layout.feedthrough.iter().enumerate() {
                tangent[start + n + k] = self.d[record][sensor];
            }
        }
        tangents
    }

    /// The same system with |(b_j, d_j)| = 1.
    pub(crate) fn normalised(mut self) -> Self {
        for (b, d) in self.b.iter_mut().zip(&mut self.d) {
            let length = b.norm().hypot(d.norm());
            if length > 0.0 {
                *b /= length;
                *d /= length;
            }
        }
        self
    }

    /// The same system in the basis x = T z.
    pub(crate) fn in_basis(&self, t: &DMatrix<f64>, inverse: &DMatrix<f64>) -> Self {
        Self {
            a: inverse * &self.a * t,
            c: &self.c * t,
            b: self.b.iter().map(|b| inverse * b).collect(),
            d: self.d.clone(),
            derivatives: None,
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        let vectors = self.b.iter().chain(&self.d).flat_map(|vector| vector.iter());
        self.a.iter().chain(self.c.iter()).chain(vectors).all(|entry| entry.is_finite())
    }
}
