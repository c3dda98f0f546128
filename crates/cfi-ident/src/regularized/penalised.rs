//! The penalised problem in the units of the solver, and its solution in those of the record.

use nalgebra::{DMatrix, DVector};

use super::{
    lambda::HoldOutScore,
    penalty::{Regularization, penalty, square_weights},
    program::{Cornered, Program},
    settings::Settings,
    solver::{Solution, Status, solve},
};
use crate::{
    CfiModel, FitError, Segment, Structure,
    factor::Factor,
    gram::{Reduced, reduce},
    regressors::{Counts, check, scale},
    triangle::Triangle,
};

/// A model found by penalised least squares. There is no covariance: the estimate is biased on purpose.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RegularizedFit {
    /// The model.
    pub model: CfiModel,
    /// What was penalised.
    pub regularization: Regularization,
    /// How much; given, or chosen by hold-out.
    pub lambda: f64,
    /// The objective at the solution, as the module states it.
    pub objective: f64,
    /// P(g) at the solution.
    pub penalty: f64,
    /// Distance between the objective and the solver's lower bound for it, over the objective. Zero for penalties of squares, which
    /// need no solver.
    pub relative_gap: f64,
    /// 2-norm of the residual Psi - theta Phi, in the unit of the pseudo output.
    pub residual_norm: f64,
    /// Root of the mean square of the residual.
    pub residual_rms: f64,
    /// Residual norm over the norm of Psi; 0 if Psi is zero.
    pub relative_residual: f64,
    /// How the solver ended: solved or almost solved.
    pub status: Status,
    /// Iterations of the solver; 0 for penalties of squares.
    pub iterations: u32,
    /// Equations, that is columns of Phi.
    pub equations: usize,
    /// What each candidate reached on the held-out samples; empty for a given lambda.
    pub hold_out: Vec<HoldOutScore>,
}

/// The equations in units in which every column has a norm near one: what the solver gets, for any penalty and lambda.
pub(crate) struct Penalised {
    structure: Structure,
    counts: Counts,
    reduced: Reduced,
    /// x = theta' * unit, for theta' in the scaled channels.
    units: DVector<f64>,
    a: DMatrix<f64>,
    b: DVector<f64>,
}

impl Penalised {
    pub(crate) fn new(segments: &[Segment<'_>], structure: &Structure) -> Result<Self, FitError> {
        let counts = check(segments, structure, structure.denominator_count() + 1)?;
        let reduced = reduce(segments, structure)?;
        let mut a = reduced.a.clone();
        let middle = structure.denominator_count() + structure.orders.anticausal();
        let positive = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
        let input = positive(a.column(middle).norm());
        let output = positive(reduced.target_norm);
        let units = DVector::from_fn(a.ncols(), |i, _| {
            if i < structure.denominator_count() { 1.0 } else { input / output }
        });
        for (mut column, unit) in a.column_iter_mut().zip(&units) {
            column /= *unit * output;
        }
        let b = &reduced.b / output;
        Ok(Self { structure: *structure, counts, reduced, units, a, b })
    }

    pub(crate) fn solve(
        &self,
        regularization: Regularization,
        lambda: f64,
        settings: &Settings,
    ) -> Result<RegularizedFit, FitError> {
        let structure = self.structure;
        let cornered = match regularization {
            _ if lambda == 0.0 => None,
            Regularization::Lasso => Some(Cornered::Lasso),
            Regularization::NuclearNorm => Some(Cornered::NuclearNorm),
            Regularization::Ridge | Regularization::ExponentiallyWeighted { .. } => None,
        };
        let (solution, bound) = match cornered {
            Some(penalty) => {
                let program = Program::new(&self.a, &self.b, structure, penalty, lambda);
                let solution = solve(&program, settings)?;
                let bound = lambda * solution.dual_objective;
                (solution, Some(bound))
            }
            None => {
                let weights = square_weights(structure, regularization) * lambda;
                (self.solve_directly(&weights)?, None)
            }
        };
        let parameters = self.a.ncols();
        let x = DVector::from_column_slice(&solution.variables[..parameters]);
        let in_given_units = |(i, theta): (usize, &f64)| {
            let input = i >= structure.denominator_count();
            let Reduced { input_exponent, output_exponent, .. } = self.reduced;
            scale(*theta, if input { output_exponent - input_exponent } else { 0 })
        };
        let theta: Vec<f64> =
            x.component_div(&self.units).iter().enumerate().map(in_given_units).collect();
        if theta.iter().any(|x| !x.is_finite()) {
            return Err(FitError::Overflow { what: "a parameter" });
        }
        let target = self.reduced.target_norm;
        // What no parameter can explain is a constant that the program leaves out.
        let unexplained = if target > 0.0 { self.reduced.unexplained_norm / target } else { 0.0 };
        let explained = (&self.b - &self.a * &x).norm();
        let relative_residual = explained.hypot(unexplained);
        let penalty = penalty(structure, regularization, &x);
        let objective = relative_residual.powi(2) / 2.0 + lambda * penalty;
        let gap = bound.map_or(0.0, |bound| (objective - bound - unexplained.powi(2) / 2.0).abs());
        let residual_norm = scale(relative_residual * target, self.reduced.output_exponent);
        Ok(RegularizedFit {
            model: CfiModel::from_theta(structure, &theta)?,
            regularization,
            lambda,
            objective,
            penalty,
            relative_gap: if objective > 0.0 { gap / objective } else { 0.0 },
            residual_norm,
            residual_rms: residual_norm / (self.counts.equations as f64).sqrt(),
            relative_residual,
            status: solution.status,
            iterations: solution.iterations,
            equations: self.counts.equations,
            hold_out: Vec::new(),
        })
    }

    /// Squares as a penalty: the rows sqrt(weights) are folded into the triangle, and the solution is one of plain least squares.
    fn solve_directly(&self, weights: &DVector<f64>) -> Result<Solution, FitError> {
        let parameters = self.a.ncols();
        let mut triangle = Triangle::new(parameters);
        let rows = self.a.nrows();
        let mut block = DMatrix::zeros(rows + parameters, parameters + 1);
        block.view_mut((0, 0), (rows, parameters)).copy_from(&self.a);
        block.view_mut((0, parameters), (rows, 1)).copy_from(&self.b);
        for (i, weight) in weights.iter().enumerate() {
            block[(rows + i, i)] = weight.sqrt();
        }
        triangle.absorb(&mut block);
        let factor =
            Factor::new(&triangle, f64::EPSILON * self.counts.equations.max(parameters) as f64)?;
        let variables = factor.solve(&triangle.right_hand_side()).as_slice().to_vec();
        Ok(Solution { variables, dual_objective: 0.0, status: Status::Solved, iterations: 0 })
    }
}
