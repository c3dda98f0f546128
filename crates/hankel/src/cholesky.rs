//! Cholesky's factorisation in doubled precision, with pivoting, and what it says about rank and condition.

use doubled::DoubleDouble;
use nalgebra::DMatrix;
use pulp::Arch;

use crate::{
    Gram, HankelError,
    scale::{exponent, power_of_two},
    sums::times,
    tile::count,
};

/// `P' S G S P = L L'` of a Gram matrix G = X' X: S scales each column of X to a norm between one and two by a power of two, P puts
/// the column farthest from those before it next.
///
/// Squaring X doubles the digits that its condition number costs; the doubled precision of G and L pays for it. So L' is the triangle of a QR
/// factorisation of X S P to the digits of a double, as long as the condition number stays below the inverse root of [`Gram::rounding`], about 1e14.
#[derive(Debug, Clone, PartialEq)]
pub struct Cholesky {
    /// Column-major p x p, lower triangle, rows and columns in pivot order; columns from `rank` on mean nothing.
    high: Vec<f64>,
    low: Vec<f64>,
    /// `order[k]` is the column that became the k-th.
    order: Vec<usize>,
    /// Columns that stand above rounding.
    found: usize,
    /// Singular values of X with its columns scaled to norm one, descending, p of them.
    singular_values: Vec<f64>,
    rank: usize,
    /// The columns of X, in units of 2^exponents, have norms between one and two.
    exponents: Vec<i32>,
    /// Those norms.
    norms: Vec<f64>,
}

impl Gram {
    /// Factorises. Singular values of X, its columns scaled to norm one, at or below `tolerance` times the largest count as zero.
    ///
    /// `None` takes the root of p times [`Gram::rounding`], the smallest that the matrix can tell from zero: 1e-14 or so.
    ///
    /// # Errors
    ///
    /// [`HankelError::NotSquare`] for a cross product, [`HankelError::BadValue`] for a tolerance outside 0 .. 1.
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Layout, Options, gram};
    ///
    /// // A sine obeys x(k+2) = 2 cos(1) x(k+1) - x(k): two of any number of shifted copies are independent.
    /// let sine: Vec<f64> = (0..100).map(|k| f64::from(k).sin()).collect();
    /// let factor = gram(&Layout::block_hankel(1, 5)?, &[&sine], &Options::default())?.cholesky(None)?;
    /// assert_eq!(factor.rank(), 2);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn cholesky(&self, tolerance: Option<f64>) -> Result<Cholesky, HankelError> {
        self.square()?;
        if let Some(value) = tolerance
            && !(0.0..1.0).contains(&value)
        {
            let what = "the rank tolerance";
            return Err(HankelError::BadValue {
                what,
                value,
                needed: "at least 0 and less than 1",
            });
        }
        let size = self.shape().0;
        let level = (count(size) * self.rounding()).sqrt();
        // Powers of two that bring the diagonal to 1 .. 4.
        let halves: Vec<i32> = (0..size)
            .map(|i| match self.at(i, i).value() {
                diagonal if diagonal > 0.0 => exponent(diagonal).div_euclid(2),
                _ => 0,
            })
            .collect();
        let value = |i: usize, j: usize| times(self.at(i, j), power_of_two(-halves[i] - halves[j]));
        let values: Vec<DoubleDouble> = (0..size)
            .flat_map(|j| (0..size).map(move |i| (i, j)))
            .map(|(i, j)| value(i, j))
            .collect();
        let norms = (0..size).map(|i| values[i + i * size].value().max(0.0).sqrt()).collect();
        let mut factor = Cholesky {
            high: values.iter().map(|x| x.high()).collect(),
            low: values.iter().map(|x| x.low()).collect(),
            order: (0..size).collect(),
            found: 0,
            singular_values: Vec::new(),
            rank: 0,
            exponents: (0..size).map(|i| self.exponent(i) + halves[i]).collect(),
            norms,
        };
        Arch::new().dispatch(|| factor.factorise(level));
        factor.singular_values = singular_values(factor.triangle());
        let largest = factor.singular_values.first().copied().unwrap_or(0.0);
        let floor = tolerance.unwrap_or(level) * largest;
        factor.rank = factor.singular_values.iter().take_while(|value| **value > floor).count();
        factor.rank = factor.rank.min(factor.found);
        Ok(factor)
    }
}

impl Cholesky {
    #[inline(always)]
    fn factorise(&mut self, level: f64) {
        let size = self.order.len();
        for k in 0..size {
            // Ties go to the first, so that the order is that of the columns where nothing speaks against it.
            let (mut pivot, mut largest) = (k, -1.0);
            for i in k..size {
                let sine = self.sine_squared(i);
                if sine > largest {
                    (pivot, largest) = (i, sine);
                }
            }
            if largest <= level * level {
                return;
            }
            self.swap(k, pivot);
            let diagonal =
                DoubleDouble::sum(self.high[k + k * size], self.low[k + k * size]).sqrt();
            for i in k + 1..size {
                let at = i + k * size;
                let x = DoubleDouble::sum(self.high[at], self.low[at]) / diagonal;
                (self.high[at], self.low[at]) = (x.high(), x.low());
            }
            (self.high[k + k * size], self.low[k + k * size]) = (diagonal.high(), diagonal.low());
            self.found += 1;
            for j in k + 1..size {
                let (done, rest) = self.high.split_at_mut(j * size);
                let (done_low, rest_low) = self.low.split_at_mut(j * size);
                let factor = (done[j + k * size], done_low[j + k * size]);
                let range = j + k * size..(k + 1) * size;
                subtract_multiple(
                    (&mut rest[j..size], &mut rest_low[j..size]),
                    (&done[range.clone()], &done_low[range]),
                    factor,
                );
            }
        }
    }

    /// Squared distance of a column from the span of those before, over its squared norm.
    #[inline(always)]
    fn sine_squared(&self, i: usize) -> f64 {
        let norm = self.norms[self.order[i]];
        if norm > 0.0 { self.high[i + i * self.order.len()] / (norm * norm) } else { 0.0 }
    }

    /// Exchanges two columns, and the rows with them: in the factor so far, and in the lower triangle of what is left.
    #[inline(always)]
    fn swap(&mut self, k: usize, pivot: usize) {
        if k == pivot {
            return;
        }
        let size = self.order.len();
        self.order.swap(k, pivot);
        for values in [&mut self.high, &mut self.low] {
            for column in 0..k {
                values.swap(k + column * size, pivot + column * size);
            }
            values.swap(k + k * size, pivot + pivot * size);
            for between in k + 1..pivot {
                values.swap(between + k * size, pivot + between * size);
            }
            for row in pivot + 1..size {
                values.swap(row + k * size, row + pivot * size);
            }
        }
    }

    fn at(&self, row: usize, column: usize) -> DoubleDouble {
        let at = row + column * self.order.len();
        // The parts are those of a normalised number, so that this changes nothing.
        DoubleDouble::sum(self.high[at], self.low[at])
    }

    /// Number of columns.
    #[must_use]
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Numerical rank.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Columns in the order in which they were taken; the first [`Cholesky::rank`] are independent.
    #[must_use]
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// The unit of a column.
    pub(crate) fn exponent(&self, column: usize) -> i32 {
        self.exponents[column]
    }

    /// R with `R' R = D G D` to the digits of a double, D scaling each column of X to norm one: as many rows as columns stand above
    /// rounding, columns in the order of the layout, so that it is a triangle but for their order.
    ///
    /// Its singular values are those of X D.
    #[must_use]
    pub fn triangle(&self) -> DMatrix<f64> {
        let mut triangle = DMatrix::zeros(self.found, self.size());
        for (position, column) in self.order.iter().enumerate() {
            let norm = self.norms[*column];
            for k in 0..self.found.min(position + 1) {
                if norm > 0.0 {
                    triangle[(k, *column)] = self.high[position + k * self.size()] / norm;
                }
            }
        }
        triangle
    }

    /// Singular values of X with its columns scaled to norm one, descending, one for each column.
    #[must_use]
    pub fn singular_values(&self) -> &[f64] {
        &self.singular_values
    }

    /// Ratio of the largest singular value to the smallest that counts as different from zero; 1 for rank 0.
    #[must_use]
    pub fn condition(&self) -> f64 {
        match self.rank {
            0 => 1.0,
            rank => self.singular_values[0] / self.singular_values[rank - 1],
        }
    }

    /// Norms of the columns of X, in the units of the record, as `factor * 2^exponent`.
    #[must_use]
    pub fn norms(&self) -> Vec<(f64, i32)> {
        self.norms.iter().copied().zip(self.exponents.iter().copied()).collect()
    }

    /// `(D X' X D)^+`, D scaling each column of X to norm one: p x p, in the order of the layout.
    ///
    /// Times the variance of the target's errors, and with D on both sides, it is the covariance of the coefficients of smallest norm.
    #[must_use]
    pub fn inverse(&self) -> DMatrix<f64> {
        let (size, rank) = (self.size(), self.rank);
        // Columns of (L')^-1, which give the inverse of the independent columns' part.
        let mut half = DMatrix::zeros(rank, size);
        for k in 0..rank {
            let mut unit = vec![0.0; rank];
            unit[k] = 1.0;
            for i in k..rank {
                let pivot = unit[i] / self.high[i + i * size];
                unit[i] = pivot;
                let column = &self.high[i * size..i * size + rank];
                for (x, l) in unit.iter_mut().zip(column).skip(i + 1) {
                    *x -= pivot * l;
                }
            }
            for i in k..rank {
                half[(i, self.order[k])] = unit[i] * self.norms[self.order[k]];
            }
        }
        let mut inverse = half.tr_mul(&half);
        if rank < size {
            let null = self.null_directions();
            let rest = DMatrix::identity(size, size) - &null * null.transpose();
            inverse = &rest * inverse * &rest;
        }
        inverse
    }

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

    /// z with L z = b for the columns above rounding, b in pivot order and scaled.
    pub(crate) fn forward(&self, b: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let size = self.size();
        let mut high: Vec<f64> = b[..self.found].iter().map(|b| b.high()).collect();
        let mut low: Vec<f64> = b[..self.found].iter().map(|b| b.low()).collect();
        Arch::new().dispatch(|| {
            for k in 0..self.found {
                let pivot = DoubleDouble::sum(high[k], low[k]) / self.at(k, k);
                (high[k], low[k]) = (pivot.high(), pivot.low());
                let range = k + 1 + k * size..self.found + k * size;
                subtract_multiple(
                    (&mut high[k + 1..], &mut low[k + 1..]),
                    (&self.high[range.clone()], &self.low[range]),
                    (pivot.high(), pivot.low()),
                );
            }
        });
        high.iter().zip(&low).map(|(high, low)| DoubleDouble::sum(*high, *low)).collect()
    }

    /// y with L' y = z for the independent columns, in pivot order.
    pub(crate) fn backward(&self, z: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut y = z[..self.rank].to_vec();
        Arch::new().dispatch(|| {
            for k in (0..self.rank).rev() {
                let mut value = y[k];
                for (i, later) in y.iter().enumerate().skip(k + 1) {
                    value -= self.at(i, k) * *later;
                }
                y[k] = value / self.at(k, k);
            }
        });
        y
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

    /// Norm of a solution in units in which every column has norm one.
    pub(crate) fn scaled_norm(&self, solution: &[f64]) -> f64 {
        let squares = solution.iter().zip(&self.norms).map(|(b, norm)| (b * norm).powi(2));
        squares.sum::<f64>().sqrt()
    }
}

/// Descending, padded with zeros to one for each column.
fn singular_values(triangle: DMatrix<f64>) -> Vec<f64> {
    let columns = triangle.ncols();
    let mut values: Vec<f64> = if triangle.is_empty() {
        Vec::new()
    } else {
        triangle.singular_values().as_slice().to_vec()
    };
    values.sort_by(|a, b| b.total_cmp(a));
    values.resize(columns, 0.0);
    values
}

/// Removes the part along a direction of norm one.
fn remove(vector: &mut [DoubleDouble], direction: &[DoubleDouble]) {
    let part = dot(vector, direction);
    vector.iter_mut().zip(direction).for_each(|(x, d)| *x -= part * *d);
}

fn dot(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    a.iter().zip(b).fold(DoubleDouble::ZERO, |sum, (a, b)| sum + *a * *b)
}

/// `target -= factor * source`, each in two halves.
#[inline(always)]
fn subtract_multiple(
    target: (&mut [f64], &mut [f64]),
    source: (&[f64], &[f64]),
    factor: (f64, f64),
) {
    let targets = target.0.iter_mut().zip(target.1.iter_mut());
    for ((high, low), (x, x_low)) in targets.zip(source.0.iter().zip(source.1)) {
        let product = -factor.0 * x;
        let error = (-factor.0).mul_add(*x, -product) - factor.0.mul_add(*x_low, factor.1 * x);
        let sum = *high + product;
        let back = sum - *high;
        let rest = ((*high - (sum - back)) + (product - back)) + (*low + error);
        *high = sum + rest;
        *low = rest - (*high - sum);
    }
}
