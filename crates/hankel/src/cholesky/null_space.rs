//! Where columns depend on one another: the directions that change nothing, and the solution without any of them.

use doubled::DoubleDouble;
use nalgebra::DMatrix;

use super::Cholesky;

impl Cholesky {
    /// Directions of coefficients, in units in which every column has norm one, that change nothing: p x (p - rank), orthonormal.
    #[must_use]
    pub fn null_directions(&self) -> DMatrix<f64> {
        let directions = self.directions();
        DMatrix::from_fn(self.size(), directions.len(), |i, j| directions[j][i].value())
    }

    /// The same in doubled precision.
    pub(crate) fn directions(&self) -> Vec<Vec<DoubleDouble>> {
        let mut directions: Vec<Vec<DoubleDouble>> = Vec::new();
        for position in self.rank..self.size() {
            // A dependent column is a combination of the independent ones.
            let coordinates: Vec<DoubleDouble> =
                (0..self.rank).map(|k| self.at(position, k)).collect();
            let mut direction = vec![DoubleDouble::ZERO; self.size()];
            for (k, weight) in self.backward(&coordinates).into_iter().enumerate() {
                let column = self.order[k];
                direction[column] = -weight * DoubleDouble::from(self.norms[column]);
            }
            let column = self.order[position];
            let norm = if self.norms[column] > 0.0 { self.norms[column] } else { 1.0 };
            direction[column] = DoubleDouble::from(norm);
            // Orthonormal to those before, twice to be sure.
            for _ in 0..2 {
                for done in &directions {
                    remove(&mut direction, done);
                }
            }
            let norm = dot(&direction, &direction).sqrt();
            direction.iter_mut().for_each(|x| *x /= norm);
            directions.push(direction);
        }
        directions
    }

    /// From the solution for the independent columns, in pivot order, to that of smallest norm in units in which every column has norm one; in the
    /// order of the layout.
    pub(crate) fn smallest(&self, y: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut solution = vec![DoubleDouble::ZERO; self.size()];
        for (column, value) in self.order.iter().zip(y) {
            solution[*column] = *value;
        }
        if self.rank < self.size() {
            let norms: Vec<DoubleDouble> =
                self.norms.iter().map(|norm| DoubleDouble::from(*norm)).collect();
            solution.iter_mut().zip(&norms).for_each(|(x, norm)| *x *= *norm);
            for direction in &self.directions() {
                remove(&mut solution, direction);
            }
            for (x, norm) in solution.iter_mut().zip(&norms) {
                *x = if norm.value() > 0.0 { *x / *norm } else { DoubleDouble::ZERO };
            }
        }
        solution
    }
}

/// Removes the part along a direction of norm one.
fn remove(vector: &mut [DoubleDouble], direction: &[DoubleDouble]) {
    let part = dot(vector, direction);
    vector.iter_mut().zip(direction).for_each(|(x, d)| *x -= part * *d);
}

fn dot(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    a.iter().zip(b).fold(DoubleDouble::ZERO, |sum, (a, b)| sum + *a * *b)
}
