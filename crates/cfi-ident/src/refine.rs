//! Iterative refinement of a least-squares solution against the data, with the residual in doubled precision.
//!
//! A backward stable solution is off by the condition number times the rounding unit, 1e-10 where the condition is 1e6. The data
//! themselves often support more: the noise-free record of a linear system obeys its equations to the last bit. One step computes
//! residual and gradient as if in twice the working precision and solves for the correction with the factor at hand:
//!
//! ```text
//! theta <- theta + (Phi Phi')^-1 Phi (Psi - theta Phi)'
//! ```
//!
//! Each step shrinks the error by about the condition number times the rounding unit, so two or three suffice (Björck, *Numerical
//! Methods for Least Squares Problems*, SIAM 1996: corrected seminormal equations).

use nalgebra::DVector;

use crate::{
    doubled::{Halves, LANES, Sum, add_dot, add_multiple},
    factor::Factor,
    regressors::{Channel, Equations},
};

/// Equations per block of a refinement pass: the pairs of a block stay in the L1 cache.
const BLOCK_ROWS: usize = 512;

/// How the refinement of the solution went.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Refinement {
    /// Corrections applied.
    pub steps: usize,
    /// Norm of the last correction over the norm of the parameters, in units in which each regressor has norm one; 0 without steps.
    pub last_correction: f64,
    /// Whether the last correction was at rounding level; `false` if no step was asked for.
    pub converged: bool,
}

/// A refined solution with its residual.
pub(crate) struct Refined {
    pub(crate) theta: DVector<f64>,
    pub(crate) residual_norm: f64,
    pub(crate) refinement: Refinement,
}

/// Refines `theta` with at most `steps` corrections. All in the scaled channels.
pub(crate) fn refine(
    equations: &Equations,
    factor: &Factor,
    theta: DVector<f64>,
    steps: usize,
) -> Refined {
    let data: Vec<[Halves; 2]> = equations
        .segments
        .iter()
        .map(|s| [Halves::new(s.input()), Halves::new(s.output())])
        .collect();
    let mut best = theta;
    let mut refinement = Refinement { steps: 0, last_correction: 0.0, converged: false };
    let (mut norm, mut gradient) = residual(equations, &data, &best);
    let mut previous = f64::INFINITY;
    for _ in 0..steps {
        let correction = factor.correction(&gradient);
        let size = factor.scaled_norm(&correction);
        let relative = if size > 0.0 { size / factor.scaled_norm(&best) } else { 0.0 };
        // A correction that does not shrink means that the condition number is beyond what refinement can mend.
        if !(relative < 0.5 * previous || relative <= f64::EPSILON) {
            break;
        }
        best += correction;
        (norm, gradient) = residual(equations, &data, &best);
        refinement = Refinement {
            steps: refinement.steps + 1,
            last_correction: relative,
            converged: relative <= f64::EPSILON,
        };
        if refinement.converged {
            break;
        }
        previous = relative;
    }
    Refined { theta: best, residual_norm: norm, refinement }
}

/// Norm of the residual Psi - theta Phi and the gradient Phi (Psi - theta Phi)', in doubled precision.
fn residual(
    equations: &Equations,
    data: &[[Halves; 2]],
    theta: &DVector<f64>,
) -> (f64, DVector<f64>) {
    let parameters = theta.len();
    let mut squares = Sum::default();
    let mut gradient = vec![[Sum::default(); LANES]; parameters];
    let mut high = Vec::with_capacity(BLOCK_ROWS);
    let mut low = Vec::with_capacity(BLOCK_ROWS);
    equations.for_each_block(BLOCK_ROWS, |index, step, count| {
        let segment = &equations.segments[index];
        let source = |column: usize| {
            let column = equations.columns[column];
            let from = segment.start(column, step);
            match column.channel {
                Channel::Input => (segment.input(), &data[index][0], from, column.sign),
                Channel::Output => (segment.output(), &data[index][1], from, column.sign),
            }
        };
        high.clear();
        high.resize(count, 0.0);
        low.clear();
        low.resize(count, 0.0);
        for j in 0..=parameters {
            let (signal, halves, from, sign) = source(j);
            let factor = if j == parameters { sign } else { -sign * theta[j] };
            add_multiple(&mut high, &mut low, factor, signal, halves, from);
        }
        high.iter_mut().zip(&low).for_each(|(high, low)| *high += low);
        high.iter().for_each(|r| squares.add(r * r));
        let residual = Halves::new(&high);
        for (j, sums) in gradient.iter_mut().enumerate() {
            let (signal, halves, from, _) = source(j);
            add_dot(sums, &high, &residual, signal, halves, from);
        }
    });
    let gradient = gradient
        .iter()
        .zip(&equations.columns)
        .map(|(sums, column)| column.sign * Sum::merge(sums).value());
    (squares.value().max(0.0).sqrt(), DVector::from_iterator(parameters, gradient))
}
