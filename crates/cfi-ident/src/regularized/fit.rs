//! The penalised fit and its result.

use nalgebra::{DMatrix, DVector};

use super::{
    HoldOutScore, Lambda, Regularization, Settings, Status,
    hold_out::choose,
    program::{Cornered, Program, nuclear_norm},
    solver::{Solution, solve},
    weight,
};
use crate::{
    CfiModel, FitError, Parameter, Segment, Structure,
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

/// Fits a model with a penalty on its Markov parameters; the [module](super) states the objective.
///
/// Unlike the plain fit it may have fewer equations than parameters, as long as there is at least one more than D(q) has unknown
/// coefficients.
///
/// # Errors
///
/// As the plain fit, and [`FitError::Unsolved`] if the solver did not reach its reduced tolerance, [`FitError::BadValue`] for a lambda, a
/// hold-out fraction or a setting out of range.
///
/// # Example
///
/// A gain of 2, seen through an alternating input of root mean square 1, so that s_i = 1 and s_o = 2. Then g = h/2 minimises
/// (1 - g)^2 / 2 + lambda g^2 / 2, which is g = 1 / (1 + lambda):
///
/// ```
/// use cfi_ident::{ConstantTerm, Orders, Segment, Structure, regularized};
/// use regularized::{Lambda, Regularization, Settings};
///
/// let input = [1.0, -1.0, 1.0, -1.0];
/// let output = [2.0, -2.0, 2.0, -2.0];
/// let structure = Structure::new(Orders::new(0, 0, 0)?, ConstantTerm::Omitted);
/// let segments = [Segment::new(&input, &output)?];
/// let (ridge, lambda) = (Regularization::Ridge, Lambda::Given(0.25));
/// let fit = regularized::fit(&segments, &structure, &ridge, &lambda, &Settings::default())?;
/// assert!((fit.model.markov_parameter(0) - 1.6).abs() < 1e-6);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
pub fn fit(
    segments: &[Segment<'_>],
    structure: &Structure,
    regularization: &Regularization,
    lambda: &Lambda,
    settings: &Settings,
) -> Result<RegularizedFit, FitError> {
    settings.check()?;
    lambda.check()?;
    let orders = structure.orders;
    regularization.check(orders.causal().max(orders.anticausal()))?;
    let (lambda, hold_out) = match lambda {
        Lambda::Given(lambda) => (*lambda, Vec::new()),
        Lambda::HoldOut { candidates, fraction } => {
            choose(segments, structure, *regularization, candidates, *fraction, settings)?
        }
    };
    let mut fit = Penalised::new(segments, structure)?.solve(*regularization, lambda, settings)?;
    fit.hold_out = hold_out;
    Ok(fit)
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

/// The weight of each parameter's square, twice the penalty's factor; zero for what is not penalised by squares.
fn square_weights(structure: Structure, regularization: Regularization) -> DVector<f64> {
    let of = |parameter| match (parameter, regularization) {
        (Parameter::Markov(_), Regularization::Ridge) => 1.0,
        (Parameter::Markov(i), Regularization::ExponentiallyWeighted { decay }) => {
            weight(decay, i.unsigned_abs())
        }
        _ => 0.0,
    };
    DVector::from_iterator(structure.parameter_count(), structure.parameters().map(of))
}

/// P(g): the penalty without its factor.
fn penalty(structure: Structure, regularization: Regularization, x: &DVector<f64>) -> f64 {
    let g = &x.as_slice()[structure.denominator_count()..];
    match regularization {
        Regularization::Ridge | Regularization::ExponentiallyWeighted { .. } => {
            square_weights(structure, regularization).component_mul(x).dot(x) / 2.0
        }
        Regularization::Lasso => g.iter().map(|g| g.abs()).sum(),
        Regularization::NuclearNorm => {
            let (future, past) = g.split_at(structure.orders.anticausal());
            let future: Vec<f64> = future.iter().rev().copied().collect();
            nuclear_norm(&past[1..]) + nuclear_norm(&future)
        }
    }
}
