//! The number of states: how many directions all records have in common.

use nalgebra::{DMatrix, DMatrixView};

use super::dense::{Eigen, eigen, eigenvalues};
use crate::ReconstructError;

/// An eigenvalue below this fraction of the largest is zero: they come with rounding errors of some units of 1e-16 of it.
const ZERO: f64 = 1e-15;

/// What the records say about the number of states.
///
/// The eigenvalues of `sum_j N_j N_j'` lie between 0 and J (with a quiet record they have no such bound). A direction that all records have in their signal has the eigenvalue 0, but for the
/// noise; there are n of them, the columns of the extended observability matrix. The other directions have larger ones, so that the
/// eigenvalues show a gap behind the n-th. `N_j` itself depends on n, so that each order has eigenvalues of its own and is judged by
/// its own gap, the ratio `w_(n+1) / w_n`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OrderEvidence {
    /// The order used, n.
    pub order: usize,
    /// Whether it was asked for; if not, the gaps decided.
    pub asked: bool,
    /// The eigenvalues of `sum_j N_j N_j'` at that order, ascending, at least 1e-15 of the largest; one for each row of the
    /// block-Hankel matrix.
    pub eigenvalues: Vec<f64>,
    /// `w_(n+1) / w_n` at that order; near 1 the order is arbitrary.
    pub gap: f64,
    /// The order and its gap of every order looked at, ascending. Those asked for are looked at alone.
    pub gaps: Vec<(usize, f64)>,
}

/// A gap below this is no evidence. The gaps of orders that are too high are mostly below 4; now and then one reaches the root of the gap at the
/// true order.
pub(crate) const WEAK_GAP: f64 = 6.0;

/// A gap counts beside the largest one if it reaches this power of it. Slow modes leave a smaller gap at the true order than there is before
/// them.
const COMPETING: f64 = 0.5;

/// The noise directions of the records, for any order.
pub(super) struct Spaces {
    /// For each record the eigenvectors by ascending eigenvalue, as annihilators in units of the sensors' deviations.
    pub(super) annihilators: Vec<DMatrix<f64>>,
    /// The number of noise directions of each record for an order of 0.
    pub(super) noise: usize,
    /// The number of directions in which a record shows nothing but rounding errors: they annihilate it, whatever the order.
    pub(super) silent: Vec<usize>,
    /// Whether the annihilators of a record are orthonormal, as they are for white noise.
    pub(super) orthonormal: bool,
}

impl Spaces {
    /// The number of noise directions of a record for an order.
    fn count(&self, record: usize, order: usize) -> usize {
        (self.noise - order).max(self.silent[record])
    }

    /// `N_j` of a record for an order.
    pub(super) fn annihilators(&self, record: usize, order: usize) -> DMatrixView<'_, f64> {
        self.annihilators[record].columns(0, self.count(record, order))
    }

    /// `sum_j N_j N_j'` for an order.
    fn sum(&self, order: usize) -> DMatrix<f64> {
        let rows = self.annihilators[0].nrows();
        let mut sum = DMatrix::zeros(rows, rows);
        for record in 0..self.annihilators.len() {
            let directions = self.annihilators(record, order);
            sum.gemm(1.0, &directions, &directions.transpose(), 1.0);
        }
        sum
    }

    /// The directions common to all records, with the evidence for their number.
    pub(super) fn common(
        &self,
        order: usize,
    ) -> Result<(DMatrix<f64>, OrderEvidence), ReconstructError> {
        let Eigen { values, vectors } = eigen(&self.sum(order))?;
        let eigenvalues = positive(values);
        let gap = gap(&eigenvalues, order);
        let mut directions = vectors.columns(0, order).into_owned();
        for mut direction in directions.column_iter_mut() {
            // Signs of eigenvectors are arbitrary: make the largest entry positive.
            if direction[direction.icamax()] < 0.0 {
                direction.neg_mut();
            }
        }
        let gaps = vec![(order, gap)];
        Ok((directions, OrderEvidence { order, asked: true, eigenvalues, gap, gaps }))
    }

    /// The gap of every order up to the largest.
    pub(super) fn gaps(&self, largest: usize) -> Result<Vec<(usize, f64)>, ReconstructError> {
        if self.orthonormal && self.annihilators.len() == 2 {
            return (1..=largest)
                .map(|order| Ok((order, gap(&positive(self.angles(order)?), order))))
                .collect();
        }
        let mut sum = self.sum(largest);
        let mut gaps = Vec::with_capacity(largest);
        for order in (1..=largest).rev() {
            gaps.push((order, gap(&positive(eigenvalues(&sum)?), order)));
            for (record, annihilators) in self.annihilators.iter().enumerate() {
                let count = self.count(record, order);
                if self.count(record, order - 1) > count {
                    let next = annihilators.column(count);
                    sum.ger(1.0, &next, &next, 1.0);
                }
            }
        }
        gaps.reverse();
        Ok(gaps)
    }

    /// The eigenvalues of `N_1 N_1' + N_2 N_2'` up to 1, ascending, from a matrix of a third of the size: they are 1 - cos of the angles
    /// between the signal spaces, `S_2' N_1 N_1' S_2` has the squares of their sines.
    fn angles(&self, order: usize) -> Result<Vec<f64>, ReconstructError> {
        let count = self.count(1, order);
        let rows = self.annihilators[1].nrows();
        let signal = self.annihilators[1].columns(count, rows - count);
        let outside = self.annihilators(0, order).tr_mul(&signal);
        let squares = eigenvalues(&outside.tr_mul(&outside))?;
        let angle = |sine_squared: f64| {
            let sine_squared = sine_squared.clamp(0.0, 1.0);
            sine_squared / (1.0 + (1.0 - sine_squared).sqrt())
        };
        let mut values: Vec<f64> = squares.into_iter().map(angle).collect();
        // The next ones belong to directions outside of a signal space.
        values.push(1.0);
        Ok(values)
    }
}

/// The largest order whose gap competes with the largest gap.
pub(crate) fn best(gaps: &[(usize, f64)]) -> usize {
    let largest = gaps.iter().fold(0.0, |largest: f64, (_, gap)| largest.max(*gap));
    let enough = largest.powf(COMPETING).max(WEAK_GAP).min(largest);
    gaps.iter().rev().find(|(_, gap)| *gap >= enough).map_or(1, |(order, _)| *order)
}

fn positive(values: Vec<f64>) -> Vec<f64> {
    let floor = ZERO * values.last().copied().unwrap_or(0.0) + f64::MIN_POSITIVE;
    values.into_iter().map(|value| value.max(floor)).collect()
}

fn gap(eigenvalues: &[f64], order: usize) -> f64 {
    let last = eigenvalues.len() - 1;
    eigenvalues[order.min(last)] / eigenvalues[(order - 1).min(last)]
}

#[cfg(test)]
mod tests;
