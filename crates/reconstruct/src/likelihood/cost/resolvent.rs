//! (zI - A)^-1 applied to vectors at one frequency after another, without allocation.

use num_complex::Complex;

/// The factors of zI - A by Gaussian elimination with partial pivoting, in buffers that are used again.
#[derive(Debug)]
pub(crate) struct Resolvent {
    order: usize,
    /// Row by row: multipliers below the diagonal, the upper factor above it, inverse pivots on it.
    factors: Vec<Complex<f64>>,
    /// Row `k` was exchanged with row `pivots[k]`.
    pivots: Vec<usize>,
    /// The smallest pivot over the largest entry of zI - A.
    smallest_pivot: f64,
}

const ZERO: Complex<f64> = Complex::new(0.0, 0.0);

impl Resolvent {
    pub(crate) fn new(order: usize) -> Self {
        Self {
            order,
            factors: vec![ZERO; order * order],
            pivots: vec![0; order],
            smallest_pivot: 1.0,
        }
    }

    /// Factors zI - A; `a` holds A row by row. A pivot that vanishes is replaced by rounding level: z is then an eigenvalue to working
    /// precision, and the solution points along its eigenvector.
    pub(crate) fn factor(&mut self, z: Complex<f64>, a: &[f64]) {
        let n = self.order;
        let mut largest = 0.0_f64;
        for (factor, &entry) in self.factors.iter_mut().zip(a) {
            *factor = Complex::new(-entry, 0.0);
            largest = largest.max(entry.abs());
        }
        for i in 0..n {
            self.factors[i * n + i] += z;
        }
        largest = largest.max(z.norm());
        let mut smallest = f64::INFINITY;
        for k in 0..n {
            let (mut pivot, mut best) = (k, self.factors[k * n + k].norm_sqr());
            for i in k + 1..n {
                let size = self.factors[i * n + k].norm_sqr();
                if size > best {
                    (pivot, best) = (i, size);
                }
            }
            self.pivots[k] = pivot;
            if pivot != k {
                for l in 0..n {
                    self.factors.swap(k * n + l, pivot * n + l);
                }
            }
            let floor = largest * f64::EPSILON;
            if best < floor * floor {
                self.factors[k * n + k] = Complex::new(floor, 0.0);
                best = floor * floor;
            }
            smallest = smallest.min(best);
            let inverse = self.factors[k * n + k].conj() / best;
            self.factors[k * n + k] = inverse;
            let (upper, lower) = self.factors.split_at_mut((k + 1) * n);
            let row_k = &upper[k * n..];
            for row in lower.chunks_exact_mut(n) {
                let multiplier = row[k] * inverse;
                row[k] = multiplier;
                for l in k + 1..n {
                    row[l] -= multiplier * row_k[l];
                }
            }
        }
        self.smallest_pivot = smallest.sqrt() / largest;
    }

    /// The smallest pivot over the largest entry: about the distance of z from the closest eigenvalue, relative to A.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    /// Replaces the row x by x (zI - A)^-1.
    pub(crate) fn solve_row(&self, x: &mut [Complex<f64>]) {
        let n = self.order;
        for k in 0..n {
            let value = x[k] * self.factors[k * n + k];
            x[k] = value;
            let (row, rest) = (&self.factors[k * n + k + 1..(k + 1) * n], &mut x[k + 1..]);
            for (x, factor) in rest.iter_mut().zip(row) {
                *x -= factor * value;
            }
        }
        for k in (0..n).rev() {
            let column = self.factors[k..].iter().step_by(n).skip(k + 1);
            let known: Complex<f64> = column.zip(&x[k + 1..]).map(|(factor, x)| factor * x).sum();
            x[k] -= known;
        }
        for k in (0..n).rev() {
            x.swap(k, self.pivots[k]);
        }
    }
}

#[cfg(test)]
mod tests;
