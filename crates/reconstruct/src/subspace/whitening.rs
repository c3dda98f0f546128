//! Coordinates in which noise is white with variance 1.

use nalgebra::DMatrix;

use super::dense::{Eigen, eigen, eigen_of_square, eigenvalues};
use crate::ReconstructError;

/// What turns the noise of the stacked sensors, mL of them, into white noise of variance 1.
#[derive(Clone, Debug)]
pub(super) enum Whitening {
    /// One deviation for each sensor.
    Levels(Vec<f64>),
    /// The lower triangle of the noise covariance's Cholesky factorisation, with the deviation of each sensor.
    Factor { lower: DMatrix<f64>, deviations: Vec<f64> },
}

/// The covariance of the stacked sensors, as it is or as its triangle.
#[derive(Clone, Debug)]
pub(super) enum Source {
    /// `H H' / M`: enough where noise stands above its rounding errors.
    Covariance(DMatrix<f64>),
    /// R with `R' R = H H' / M`: for signals with next to no noise.
    Triangle(DMatrix<f64>),
}

impl Whitening {
    /// The deviation of each sensor.
    pub(super) fn deviations(&self) -> &[f64] {
        match self {
            Self::Levels(deviations) | Self::Factor { deviations, .. } => deviations,
        }
    }

    /// The whitened source of the first `rows` rows of H alone: the leading part of a covariance, but all rows of so many columns of R, of which
    /// any may be the longest.
    fn apply(&self, source: &Source, rows: usize) -> Source {
        match (self, source) {
            (Self::Levels(s), Source::Covariance(g)) => {
                let m = s.len();
                Source::Covariance(DMatrix::from_fn(rows, rows, |i, k| {
                    g[(i, k)] / (s[i % m] * s[k % m])
                }))
            }
            (Self::Levels(s), Source::Triangle(r)) => {
                let all = r.nrows();
                Source::Triangle(DMatrix::from_fn(all, rows, |i, k| r[(i, k)] / s[k % s.len()]))
            }
            (Self::Factor { lower, .. }, Source::Covariance(g)) => {
                let half = solve_lower(lower, g.view((0, 0), (rows, rows)).into_owned());
                let whole = solve_lower(lower, half.transpose());
                Source::Covariance((&whole + whole.transpose()) * 0.5)
            }
            (Self::Factor { lower, .. }, Source::Triangle(r)) => {
                Source::Triangle(solve_lower(lower, r.columns(0, rows).transpose()).transpose())
            }
        }
    }

    /// Eigenvalues in units of the noise's variance, ascending, and their vectors in whitened coordinates.
    pub(super) fn spectrum(&self, source: &Source, rows: usize) -> Result<Eigen, ReconstructError> {
        match self.apply(source, rows) {
            Source::Covariance(matrix) => eigen(&matrix),
            Source::Triangle(factor) => eigen_of_square(&factor),
        }
    }

    /// The eigenvalues alone.
    pub(super) fn values(
        &self,
        source: &Source,
        rows: usize,
    ) -> Result<Vec<f64>, ReconstructError> {
        match self.apply(source, rows) {
            Source::Covariance(matrix) => eigenvalues(&matrix),
            Source::Triangle(factor) => Ok(eigen_of_square(&factor)?.values),
        }
    }

    /// Directions in units of the sensors' deviations -> the same in whitened coordinates.
    pub(super) fn whitened(&self, mut directions: DMatrix<f64>) -> DMatrix<f64> {
        match self {
            Self::Levels(_) => directions,
            Self::Factor { lower, deviations } => {
                for (i, mut row) in directions.row_iter_mut().enumerate() {
                    row *= deviations[i % deviations.len()];
                }
                solve_lower(lower, directions)
            }
        }
    }

    /// What annihilates a direction in whitened coordinates -> what annihilates it in units of the sensors' deviations.
    pub(super) fn annihilators(&self, whitened: DMatrix<f64>) -> DMatrix<f64> {
        match self {
            Self::Levels(_) => whitened,
            Self::Factor { lower, deviations } => {
                let rows = whitened.nrows();
                let mut annihilator = whitened;
                let solved = lower
                    .view((0, 0), (rows, rows))
                    .tr_solve_lower_triangular_mut(&mut annihilator);
                debug_assert!(solved, "the diagonal of a Cholesky factor is positive");
                for (i, mut row) in annihilator.row_iter_mut().enumerate() {
                    row *= deviations[i % deviations.len()];
                }
                annihilator
            }
        }
    }
}

/// `lower^-1 matrix`, with the leading part of the triangle.
fn solve_lower(lower: &DMatrix<f64>, mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    let rows = matrix.nrows();
    let solved = lower.view((0, 0), (rows, rows)).solve_lower_triangular_mut(&mut matrix);
    debug_assert!(solved, "the diagonal of a Cholesky factor is positive");
    matrix
}

#[cfg(test)]
mod tests;
