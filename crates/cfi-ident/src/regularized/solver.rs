//! The conic solver: the only file that knows Clarabel.

use clarabel::{
    algebra::CscMatrix,
    solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT},
};

use super::{
    program::{Cone, Program},
    settings::Settings,
};
use crate::FitError;

/// How the solver ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// Solved to the tolerance.
    Solved,
    /// Solved to the reduced tolerance only.
    AlmostSolved,
    /// The iterations ran out.
    IterationLimit,
    /// The steps became too short to go on.
    InsufficientProgress,
    /// A linear system could not be solved accurately.
    NumericalError,
    /// The solver claims that there is no solution, or refused the program. The objective is bounded below and always feasible, so
    /// this points at numbers too large or too small.
    Rejected,
}

impl std::fmt::Display for Status {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Solved => "solved",
            Self::AlmostSolved => "almost solved",
            Self::IterationLimit => "iteration limit reached",
            Self::InsufficientProgress => "insufficient progress",
            Self::NumericalError => "numerical error",
            Self::Rejected => "program rejected",
        })
    }
}

/// A solution of a conic program.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) variables: Vec<f64>,
    pub(crate) dual_objective: f64,
    pub(crate) status: Status,
    pub(crate) iterations: u32,
}

/// Solves a program. Anything that is not at least almost solved is an error.
pub(crate) fn solve(program: &Program, settings: &Settings) -> Result<Solution, FitError> {
    let n = program.linear.len();
    let nonzero: Vec<usize> = (0..n).filter(|i| program.quadratic[*i] > 0.0).collect();
    let weights = nonzero.iter().map(|i| program.quadratic[*i]).collect();
    let quadratic = CscMatrix::new_from_triplets(n, n, nonzero.clone(), nonzero, weights);
    let rows = program.constraints.iter().map(|entry| entry.row).collect();
    let columns = program.constraints.iter().map(|entry| entry.column).collect();
    let values = program.constraints.iter().map(|entry| entry.value).collect();
    let constraints = CscMatrix::new_from_triplets(program.offsets.len(), n, rows, columns, values);
    let cones: Vec<SupportedConeT<f64>> = program
        .cones
        .iter()
        .map(|cone| match cone {
            Cone::Zero(rows) => SupportedConeT::ZeroConeT(*rows),
            Cone::Nonnegative(rows) => SupportedConeT::NonnegativeConeT(*rows),
            Cone::SemidefiniteTriangle(side) => SupportedConeT::PSDTriangleConeT(*side),
        })
        .collect();
    let rejected = FitError::Unsolved { status: Status::Rejected };
    let options = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_threads(1)
        .max_iter(settings.max_iterations)
        .tol_gap_abs(settings.tolerance)
        .tol_gap_rel(settings.tolerance)
        .tol_feas(settings.tolerance)
        .reduced_tol_gap_abs(settings.reduced_tolerance)
        .reduced_tol_gap_rel(settings.reduced_tolerance)
        .reduced_tol_feas(settings.reduced_tolerance)
        .build()
        .map_err(|_| rejected.clone())?;
    let mut solver = DefaultSolver::new(
        &quadratic,
        &program.linear,
        &constraints,
        &program.offsets,
        &cones,
        options,
    )
    .map_err(|_| rejected)?;
    solver.solve();
    let status = match solver.solution.status {
        SolverStatus::Solved => Status::Solved,
        SolverStatus::AlmostSolved => Status::AlmostSolved,
        SolverStatus::MaxIterations | SolverStatus::MaxTime => Status::IterationLimit,
        SolverStatus::InsufficientProgress => Status::InsufficientProgress,
        SolverStatus::NumericalError => Status::NumericalError,
        _ => Status::Rejected,
    };
    if !matches!(status, Status::Solved | Status::AlmostSolved) {
        return Err(FitError::Unsolved { status });
    }
    Ok(Solution {
        variables: solver.solution.x,
        dual_objective: solver.solution.obj_val_dual,
        status,
        iterations: solver.solution.iterations,
    })
}
