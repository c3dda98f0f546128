//! The lasso and the nuclear norm as conic programs with a diagonal quadratic term.
//!
//! ```text
//! minimise    1/2 v' diag(quadratic) v + linear' v     subject to   offsets - constraints v  in  cones
//! ```
//!
//! The variables are v = [x e extra]: the parameters x (c, then g), the residual e, and what the penalty needs. Tying
//! A x + sqrt(lambda) e = b by equations instead of forming A'A keeps the condition number from being squared. The objective is divided by
//! lambda, so that it has the size of the penalty: a small lambda then asks for a small residual and not for a tiny
//! change of an objective that the solver's tolerance cannot see.

use nalgebra::{DMatrix, DVector};

use crate::Structure;

/// The penalties with corners, which need a cone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cornered {
    Lasso,
    NuclearNorm,
}

/// A cone for consecutive rows of the constraints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cone {
    /// All zero: equations.
    Zero(usize),
    /// All at least zero.
    Nonnegative(usize),
    /// The upper triangle, column by column and off-diagonals times the square root of two, of a positive semidefinite matrix
    /// with this many rows.
    SemidefiniteTriangle(usize),
}

/// One element of the constraint matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Entry {
    pub(crate) row: usize,
    pub(crate) column: usize,
    pub(crate) value: f64,
}

/// A conic program; see the module.
#[derive(Debug, Clone, Default)]
pub(crate) struct Program {
    pub(crate) quadratic: Vec<f64>,
    pub(crate) linear: Vec<f64>,
    pub(crate) constraints: Vec<Entry>,
    pub(crate) offsets: Vec<f64>,
    pub(crate) cones: Vec<Cone>,
}

impl Program {
    /// 1/2 ||e||^2 + P(x) with A x + sqrt(lambda) e = b, for square A, lambda above zero and a penalty that is not quadratic.
    pub(crate) fn new(
        a: &DMatrix<f64>,
        b: &DVector<f64>,
        structure: Structure,
        penalty: Cornered,
        lambda: f64,
    ) -> Self {
        let mut program = Self::default();
        let parameters = a.ncols();
        program.add_variables(parameters, 0.0, 0.0);
        let residual = program.add_variables(b.len(), 1.0, 0.0);
        for (i, row) in a.row_iter().enumerate() {
            for (j, value) in row.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                program.constraints.push(Entry { row: i, column: j, value: *value });
            }
            program.constraints.push(Entry { row: i, column: residual + i, value: lambda.sqrt() });
        }
        program.offsets.extend(b.iter());
        program.cones.push(Cone::Zero(b.len()));
        let markov = structure.denominator_count();
        match penalty {
            Cornered::Lasso => program.add_magnitudes(markov, structure.markov_count()),
            Cornered::NuclearNorm => {
                let zero = markov + structure.orders.anticausal();
                let causal: Vec<usize> =
                    (1..=structure.orders.causal()).map(|i| zero + i).collect();
                let anticausal: Vec<usize> =
                    (1..=structure.orders.anticausal()).map(|i| zero - i).collect();
                program.add_nuclear_norm(&causal);
                program.add_nuclear_norm(&anticausal);
            }
        }
        program
    }

    /// The sum of the magnitudes of `count` variables from `first` on: t_i - x_i and t_i + x_i are at least zero.
    fn add_magnitudes(&mut self, first: usize, count: usize) {
        let bound = self.add_variables(count, 0.0, 1.0);
        for sign in [1.0, -1.0] {
            for i in 0..count {
                let row = self.offsets.len();
                self.constraints.push(Entry { row, column: first + i, value: sign });
                self.constraints.push(Entry { row, column: bound + i, value: -1.0 });
                self.offsets.push(0.0);
            }
        }
        self.cones.push(Cone::Nonnegative(2 * count));
    }

    /// The sum of singular values of the Hankel matrix H of these variables: half the smallest trace of
    /// W_1 and W_2 with [W_1 H; H' W_2] positive semidefinite.
    fn add_nuclear_norm(&mut self, sequence: &[usize]) {
        let (rows, columns) = hankel_shape(sequence.len());
        if rows == 0 {
            return;
        }
        let side = rows + columns;
        for j in 0..side {
            for i in 0..=j {
                let variable = if i < rows && j >= rows {
                    sequence[i + j - rows]
                } else {
                    self.add_variables(1, 0.0, if i == j { 0.5 } else { 0.0 })
                };
                let value = if i == j { -1.0 } else { -std::f64::consts::SQRT_2 };
                self.constraints.push(Entry { row: self.offsets.len(), column: variable, value });
                self.offsets.push(0.0);
            }
        }
        self.cones.push(Cone::SemidefiniteTriangle(side));
    }

    /// Adds variables and returns the index of the first.
    fn add_variables(&mut self, count: usize, quadratic: f64, linear: f64) -> usize {
        let first = self.linear.len();
        self.quadratic.resize(first + count, quadratic);
        self.linear.resize(first + count, linear);
        first
    }
}

/// The most nearly square Hankel matrix that uses each of `count` elements; 0 x 0 for none.
pub(crate) fn hankel_shape(count: usize) -> (usize, usize) {
    let rows = count.div_ceil(2);
    (rows, if rows == 0 { 0 } else { count + 1 - rows })
}

/// Sum of the singular values of the Hankel matrix of a sequence.
pub(crate) fn nuclear_norm(sequence: &[f64]) -> f64 {
    let (rows, columns) = hankel_shape(sequence.len());
    if rows == 0 {
        return 0.0;
    }
    DMatrix::from_fn(rows, columns, |i, j| sequence[i + j]).singular_values().sum()
}
