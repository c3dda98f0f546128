//! The penalised fit and its result.

use nalgebra::{DMatrix, DVector};

use super::{
    HoldOutScore, Lambda, Regularization, Settings, Status,
    hold_out::choose,
    program::{Program, penalty},
    solver::solve,
};
use crate::{
    CfiModel, FitError, Segment, Structure,
    fit::count,
    regressors::{Channel, Equations, scale},
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
    /// The objective minus the solver's lower bound for it, over the objective: how far from the optimum the solution can be.
    pub relative_gap: f64,
    /// 2-norm of the residual Psi - theta Phi, in the unit of the pseudo output.
    pub residual_norm: f64,
    /// Root of the mean square of the residual.
    pub residual_rms: f64,
    /// Residual norm over the norm of Psi; 0 if Psi is zero.
    pub relative_residual: f64,
    /// How the solver ended: solved or almost solved.
    pub status: Status,
    /// Iterations of the solver.
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
    equations: Equations,
    triangle: Triangle,
    /// x = theta' * unit, for theta' in the scaled channels.
    units: DVector<f64>,
    a: DMatrix<f64>,
    b: DVector<f64>,
}

impl Penalised {
    pub(crate) fn new(segments: &[Segment<'_>], structure: &Structure) -> Result<Self, FitError> {
        let equations = Equations::new(segments, structure, structure.denominator_count() + 1)?;
        let triangle = equations.triangle();
        let mut a = triangle.regressors();
        let middle = structure.denominator_count() + structure.orders.anticausal();
        let positive = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
        let input = positive(a.column(middle).norm());
        let output = positive(triangle.target_norm());
        let units = DVector::from_iterator(
            a.ncols(),
            equations.columns.iter().take(a.ncols()).map(|column| match column.channel {
                Channel::Input => input / output,
                Channel::Output => 1.0,
            }),
        );
        for (mut column, unit) in a.column_iter_mut().zip(&units) {
            column /= *unit * output;
        }
        let b = triangle.right_hand_side() / output;
        Ok(Self { equations, triangle, units, a, b })
    }

    pub(crate) fn solve(
        &self,
        regularization: Regularization,
        lambda: f64,
        settings: &Settings,
    ) -> Result<RegularizedFit, FitError> {
        let structure = self.equations.structure;
        let program = Program::new(&self.a, &self.b, structure, regularization, lambda);
        let solution = solve(&program, settings)?;
        let parameters = self.a.ncols();
        let x = DVector::from_column_slice(&solution.variables[..parameters]);
        let theta: Vec<f64> = x
            .component_div(&self.units)
            .iter()
            .zip(&self.equations.columns)
            .map(|(x, column)| scale(*x, self.equations.parameter_exponent(*column)))
            .collect();
        if theta.iter().any(|x| !x.is_finite()) {
            return Err(FitError::Overflow { what: "a parameter" });
        }
        let target = self.triangle.target_norm();
        // What no parameter can explain is a constant that the program leaves out.
        let unexplained = if target > 0.0 { self.triangle.residual_norm() / target } else { 0.0 };
        let explained = (&self.b - &self.a * &x).norm();
        let relative_residual = explained.hypot(unexplained);
        let penalty =
            penalty(structure, regularization, &x.as_slice()[structure.denominator_count()..]);
        let objective = relative_residual.powi(2) / 2.0 + lambda * penalty;
        let bound = solution.dual_objective + unexplained.powi(2) / 2.0;
        let residual_norm = scale(relative_residual * target, self.equations.output_exponent);
        Ok(RegularizedFit {
            model: CfiModel::from_theta(structure, &theta)?,
            regularization,
            lambda,
            objective,
            penalty,
            relative_gap: if objective > 0.0 {
                (objective - bound).max(0.0) / objective
            } else {
                0.0
            },
            residual_norm,
            residual_rms: residual_norm / count(self.equations.rows).sqrt(),
            relative_residual,
            status: solution.status,
            iterations: solution.iterations,
            equations: self.equations.rows,
            hold_out: Vec::new(),
        })
    }
}
