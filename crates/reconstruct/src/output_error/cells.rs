//! The matrices of a model whose inputs are all recorded, and where each of their entries stands in a vector.

use nalgebra::DMatrix;

/// How many states, sensors and inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sizes {
    pub(super) states: usize,
    pub(super) sensors: usize,
    pub(super) inputs: usize,
}

/// x(k+1) = A x(k) + B u(k), y(k) = C x(k) + D u(k), each sensor and input late by its lag.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Matrices {
    pub(super) a: DMatrix<f64>,
    pub(super) b: DMatrix<f64>,
    pub(super) c: DMatrix<f64>,
    pub(super) d: DMatrix<f64>,
    /// In s, one for each sensor.
    pub(super) sensor_lags: Vec<f64>,
    /// In s, one for each input.
    pub(super) input_lags: Vec<f64>,
}

/// All entries in one vector: A, B, C, D by columns, then the lags of sensors and of inputs.
impl Sizes {
    pub(super) fn count(self) -> usize {
        self.input_lag(self.inputs)
    }

    pub(super) fn a(self, row: usize, column: usize) -> usize {
        column * self.states + row
    }

    pub(super) fn b(self, row: usize, column: usize) -> usize {
        self.states * (self.states + column) + row
    }

    pub(super) fn c(self, row: usize, column: usize) -> usize {
        self.states * (self.states + self.inputs) + column * self.sensors + row
    }

    pub(super) fn d(self, row: usize, column: usize) -> usize {
        self.c(0, self.states) + column * self.sensors + row
    }

    pub(super) fn sensor_lag(self, sensor: usize) -> usize {
        self.d(0, self.inputs) + sensor
    }

    pub(super) fn input_lag(self, input: usize) -> usize {
        self.sensor_lag(self.sensors) + input
    }
}

impl Matrices {
    pub(super) fn sizes(&self) -> Sizes {
        Sizes { states: self.a.nrows(), sensors: self.c.nrows(), inputs: self.b.ncols() }
    }

    pub(super) fn is_finite(&self) -> bool {
        let lags = self.sensor_lags.iter().chain(&self.input_lags);
        [&self.a, &self.b, &self.c, &self.d]
            .into_iter()
            .flat_map(DMatrix::iter)
            .chain(lags)
            .all(|entry| entry.is_finite())
    }

    /// All entries in the order of [`Sizes`].
    pub(super) fn entries(&self) -> Vec<f64> {
        let matrices = [&self.a, &self.b, &self.c, &self.d].into_iter().flat_map(DMatrix::iter);
        matrices.chain(&self.sensor_lags).chain(&self.input_lags).copied().collect()
    }
}
