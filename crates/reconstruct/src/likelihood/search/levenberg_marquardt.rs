//! Levenberg-Marquardt on the identifiable directions, with columns scaled to unit length.
//!
//! A change of basis of the states, or of the scale of an excitation, changes nothing: the Gram matrix G has these tangents N in its null space.
//! With the scale s_i = sqrt(G_ii), the step solves (G_s + lambda I + P) x = d_s with P the projector onto the scaled N. Since d is orthogonal to N, so
//! is x, and no basis of the identifiable directions is needed.
//!
//! Where noise makes up much of the spectrum, G is far from the curvature in some directions and the search would creep. What G misses is collected
//! from the differences of gradients, as in NL2SOL (Dennis, Gay & Welsch 1981).

use nalgebra::{DMatrix, DVector};

use super::eigenvalue_penalty::EigenvaluePenalty;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SearchStatus {
    /// The next step would be shorter than the tolerance.
    Converged,
    /// No step lowers the cost, and what it could still gain is rounding errors.
    AtRoundingLevel,
    /// No step lowers the cost although the gradient says that one should.
    Stalled,
    /// The largest number of steps was taken.
    StepLimit,
    /// The next steps will not come near what another search has reached.
    GivenUp,
}

/// The end of a search.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    pub(crate) evaluation: Evaluation,
    pub(crate) status: SearchStatus,
    /// Accepted steps.
    pub(crate) steps: usize,
    /// Evaluations of the likelihood.
    pub(crate) evaluations: usize,
    /// The length of the step that was not taken any more, in standard deviations of the estimate.
    pub(crate) remaining_step: f64,
}

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) steps: usize,
    pub(crate) step_tolerance: f64,
    /// Residuals less parameters: the cost over it is the variance of a residual.
    pub(crate) degrees_of_freedom: f64,
    /// The cost of explaining nothing, against which rounding errors are measured.
    pub(crate) energy: f64,
    /// The search is given up where its cost will stay above this.
    pub(crate) ceiling: f64,
    /// An eigenvalue that stays where it is.
    pub(crate) penalty: Option<EigenvaluePenalty>,
}

const FIRST_DAMPING: f64 = 1e-4;
const LEAST_DAMPING: f64 = 1e-13;
const MOST_DAMPING: f64 = 1e12;
/// Squared relative rounding error of a residual: costs below this part of the energy mean nothing.
const ROUNDING: f64 = 1e-26;

/// A cost that is not quadratic may fall by so many times what a quadratic one would.
const HOPE: f64 = 3.0;

/// Walks downhill from `start`. Each accepted step lowers the cost.
pub(crate) fn minimise(
    problem: &Problem,
    start: Evaluation,
    variances: &[f64],
    limits: Limits,
) -> Search {
    let mut search = Search {
        evaluation: penalised(start, &limits),
        status: SearchStatus::StepLimit,
        steps: 0,
        evaluations: 0,
        remaining_step: f64::INFINITY,
    };
    let mut damping = FIRST_DAMPING;
    let parameters = search.evaluation.descent.len();
    let mut missed = DMatrix::zeros(parameters, parameters);
    loop {
        let mut scaled = Scaled::new(&search.evaluation, &missed, problem);
        if scaled.step(LEAST_DAMPING).is_none() {
            missed.fill(0.0);
            scaled = Scaled::new(&search.evaluation, &missed, problem);
        }
        let variance = (search.evaluation.cost / limits.degrees_of_freedom).max(f64::MIN_POSITIVE);
        // What the cost would fall by, were it quadratic.
        let gain = scaled
            .step(LEAST_DAMPING)
            .map_or(f64::INFINITY, |step| step.dot(&search.evaluation.descent).max(0.0));
        search.remaining_step = (gain / variance).sqrt();
        if search.remaining_step <= limits.step_tolerance {
            search.status = SearchStatus::Converged;
            return search;
        }
        if search.evaluation.cost - HOPE * gain > limits.ceiling {
            search.status = SearchStatus::GivenUp;
            return search;
        }
        if search.steps == limits.steps {
            return search;
        }
        match lower(problem, &search.evaluation, &scaled, variances, &limits, &mut damping) {
            Attempt::Lower(next, step, evaluations) => {
                let change = &search.evaluation.descent - &next.descent;
                learn(&mut missed, &change, &next.gram, &step);
                search.evaluation = *next;
                search.steps += 1;
                search.evaluations += evaluations;
            }
            Attempt::None(status, evaluations) => {
                search.status = status;
                search.evaluations += evaluations;
                return search;
            }
        }
    }
}

fn penalised(mut evaluation: Evaluation, limits: &Limits) -> Evaluation {
    if let Some(penalty) = limits.penalty {
        penalty.penalise(&mut evaluation);
    }
    evaluation
}

/// Updates what the Gram matrix misses, so that it explains the last change of the gradient (Dennis, Gay & Welsch 1981, eq. 3.1 to 3.3).
fn learn(
    missed: &mut DMatrix<f64>,
    change: &DVector<f64>,
    gram: &DMatrix<f64>,
    step: &DVector<f64>,
) {
    // Below this cosine the change of the gradient says nothing about curvature.
    const LEAST_COSINE: f64 = 1e-8;
    let curvature = change.dot(step);
    if curvature <= LEAST_COSINE * change.norm() * step.norm() {
        return;
    }
    let unexplained = change - gram * step;
    let known = step.dot(&(&*missed * step)).abs();
    if known > 0.0 {
        *missed *= (step.dot(&unexplained).abs() / known).min(1.0);
    }
    let rest = unexplained - &*missed * step;
    let mixed = &rest * change.transpose();
    *missed += (&mixed + mixed.transpose()) / curvature
        - change * change.transpose() * (rest.dot(step) / (curvature * curvature));
}

enum Attempt {
    Lower(Box<Evaluation>, DVector<f64>, usize),
    None(SearchStatus, usize),
}

/// Tries steps with more and more damping until one lowers the cost.
fn lower(
    problem: &Problem,
    here: &Evaluation,
    scaled: &Scaled,
    variances: &[f64],
    limits: &Limits,
    damping: &mut f64,
) -> Attempt {
    let mut evaluations = 0;
    while *damping < MOST_DAMPING {
        let Some(step) = scaled.step(*damping) else {
            *damping = (*damping * 10.0).max(LEAST_DAMPING);
            continue;
        };
        let predicted = 2.0 * step.dot(&here.descent) - step.dot(&(&scaled.curvature * &step));
        if let Some(system) = problem.moved(&here.system, &step) {
            let coefficients = here.coefficients_after(&step, &problem.layout);
            let trial = penalised(problem.evaluate_around(system, coefficients, variances), limits);
            evaluations += 1;
            if trial.cost < here.cost {
                let ratio = (here.cost - trial.cost) / predicted;
                let factor = if ratio > 0.9 { 0.1 } else { 1.0 - (2.0 * ratio - 1.0).powi(3) };
                *damping = (*damping * factor.clamp(0.1, 4.0)).max(LEAST_DAMPING);
                return Attempt::Lower(Box::new(trial), step, evaluations);
            }
        }
        if predicted <= ROUNDING * limits.energy {
            return Attempt::None(SearchStatus::AtRoundingLevel, evaluations);
        }
        *damping = (*damping * 10.0).max(LEAST_DAMPING);
    }
    *damping = FIRST_DAMPING;
    Attempt::None(SearchStatus::Stalled, evaluations)
}

/// The normal equations with unit diagonal.
struct Scaled {
    matrix: DMatrix<f64>,
    descent: DVector<f64>,
    inverse_scale: DVector<f64>,
    /// The same matrix without scale and projector.
    curvature: DMatrix<f64>,
}

impl Scaled {
    fn new(evaluation: &Evaluation, missed: &DMatrix<f64>, problem: &Problem) -> Self {
        let gram = &evaluation.gram;
        let inverse_scale =
            gram.diagonal().map(|entry| if entry > 0.0 { 1.0 / entry.sqrt() } else { 1.0 });
        let mut q = problem.invariant_tangents(&evaluation.system);
        for (mut row, inverse) in q.row_iter_mut().zip(inverse_scale.iter()) {
            row /= *inverse;
        }
        if q.ncols() > 0 {
            q = q.qr().q();
        }
        let curvature = gram + missed;
        let unit = DMatrix::from_fn(gram.nrows(), gram.ncols(), |i, k| {
            curvature[(i, k)] * inverse_scale[i] * inverse_scale[k]
        });
        // What was learnt may have drifted along N.
        let half = &unit - &q * (q.transpose() * &unit);
        let matrix = &half - (&half * &q) * q.transpose() + &q * q.transpose();
        let descent = evaluation.descent.component_mul(&inverse_scale);
        // Along N the descent is rounding errors; they would not move the cost, only the basis.
        let descent = &descent - &q * (q.transpose() * &descent);
        Self { matrix, descent, inverse_scale, curvature }
    }

    fn step(&self, damping: f64) -> Option<DVector<f64>> {
        let mut matrix = self.matrix.clone();
        for k in 0..matrix.nrows() {
            matrix[(k, k)] += damping;
        }
        let step = matrix.cholesky()?.solve(&self.descent).component_mul(&self.inverse_scale);
        step.iter().all(|entry| entry.is_finite()).then_some(step)
    }
}

#[cfg(test)]
mod tests;
