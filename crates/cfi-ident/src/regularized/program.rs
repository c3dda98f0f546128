//! The penalised least-squares problem as a conic program with a diagonal quadratic term.
//!
//! ```text
//! minimise    1/2 v' diag(quadratic) v + linear' v     subject to   offsets - constraints v  in  cones
//! ```
//!
//! The variables are v = [x e extra]: the parameters x (c, then g), the residual e, and what the penalty needs. Tying e = b - A x by
//! equations instead of forming A'A keeps the condition number from being squared.

use nalgebra::{DMatrix, DVector};

use super::{Regularization, weight};
use crate::{Parameter, Structure};

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
    /// 1/2 ||b - A x||^2 + lambda P, for square A.
    pub(crate) fn new(
        a: &DMatrix<f64>,
        b: &DVector<f64>,
        structure: Structure,
        regularization: Regularization,
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
            program.constraints.push(Entry { row: i, column: residual + i, value: 1.0 });
        }
        program.offsets.extend(b.iter());
        program.cones.push(Cone::Zero(b.len()));
        if lambda > 0.0 {
            program.penalise(structure, regularization, lambda);
        }
        program
    }

    fn penalise(&mut self, structure: Structure, regularization: Regularization, lambda: f64) {
        let markov = structure.denominator_count();
        match regularization {
            Regularization::Ridge => self.weigh_squares(structure, |_| lambda),
            Regularization::ExponentiallyWeighted { decay } => {
                self.weigh_squares(structure, |i| lambda * weight(decay, i));
            }
            Regularization::Lasso => {
                // t_i - x_i and t_i + x_i are at least zero.
                let count = structure.markov_count();
                let bound = self.add_variables(count, 0.0, lambda);
                for sign in [1.0, -1.0] {
                    for i in 0..count {
                        let row = self.offsets.len();
                        self.constraints.push(Entry { row, column: markov + i, value: sign });
                        self.constraints.push(Entry { row, column: bound + i, value: -1.0 });
                        self.offsets.push(0.0);
                    }
                }
                self.cones.push(Cone::Nonnegative(2 * count));
            }
            Regularization::NuclearNorm => {
                let zero = markov + structure.orders.anticausal();
                let causal: Vec<usize> =
                    (1..=structure.orders.causal()).map(|i| zero + i).collect();
                let anticausal: Vec<usize> =
                    (1..=structure.orders.anticausal()).map(|i| zero - i).collect();
                self.add_nuclear_norm(&causal, lambda);
                self.add_nuclear_norm(&anticausal, lambda);
            }
        }
    }

    /// The quadratic term of h_i becomes `weight(|i|)`.
    fn weigh_squares(&mut self, structure: Structure, weight: impl Fn(usize) -> f64) {
        for (position, parameter) in structure.parameters().enumerate() {
            if let Parameter::Markov(i) = parameter {
                self.quadratic[position] = weight(i.unsigned_abs());
            }
        }
    }

    /// lambda times the sum of singular values of the Hankel matrix H of these variables: half the smallest trace of
    /// W_1 and W_2 with [W_1 H; H' W_2] positive semidefinite.
    fn add_nuclear_norm(&mut self, sequence: &[usize], lambda: f64) {
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
                    self.add_variables(1, 0.0, if i == j { lambda / 2.0 } else { 0.0 })
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

/// P(g): the penalty without its factor.
pub(crate) fn penalty(structure: Structure, regularization: Regularization, g: &[f64]) -> f64 {
    let half_squares = |weight: &dyn Fn(usize) -> f64| {
        let markov = structure.parameters().filter_map(|parameter| match parameter {
            Parameter::Markov(i) => Some(weight(i.unsigned_abs())),
            Parameter::Denominator(_) => None,
        });
        markov.zip(g).map(|(weight, g)| weight * g * g).sum::<f64>() / 2.0
    };
    match regularization {
        Regularization::Ridge => half_squares(&|_| 1.0),
        Regularization::ExponentiallyWeighted { decay } => half_squares(&|i| weight(decay, i)),
        Regularization::Lasso => g.iter().map(|g| g.abs()).sum(),
        Regularization::NuclearNorm => {
            let (future, past) = g.split_at(structure.orders.anticausal());
            let future: Vec<f64> = future.iter().rev().copied().collect();
            nuclear_norm(&past[1..]) + nuclear_norm(&future)
        }
    }
}

/// Sum of the singular values of the Hankel matrix of a sequence.
fn nuclear_norm(sequence: &[f64]) -> f64 {
    let (rows, columns) = hankel_shape(sequence.len());
    if rows == 0 {
        return 0.0;
    }
    DMatrix::from_fn(rows, columns, |i, j| sequence[i + j]).singular_values().sum()
}
