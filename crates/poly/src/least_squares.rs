//! Small dense least squares by Householder QR, kept here so that the crate stands without linear algebra.
//!
//! Complex throughout; real data stay exactly real.

#[cfg(test)]
mod tests;

use num_complex::Complex;

type C = Complex<f64>;
const ZERO: C = Complex::new(0.0, 0.0);

/// Steps of inverse iteration; each squares the ratio of the two smallest singular values.
const INVERSE_ITERATIONS: usize = 6;

/// The factors of an m x n matrix, m >= n: `H_n ... H_1 A = [R; 0]`.
#[derive(Debug, Clone)]
pub(crate) struct Factored {
    rows: usize,
    /// Column j: the entries of R above the diagonal, then Householder's vector from row j on.
    columns: Vec<Vec<C>>,
    diagonal: Vec<C>,
    /// Two over the squared norm of each Householder vector; zero for none.
    factors: Vec<f64>,
}

fn norm(x: &[C]) -> f64 {
    let largest = x.iter().fold(0.0_f64, |m, c| m.max(c.re.abs()).max(c.im.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * x.iter().map(|c| (c / largest).norm_sqr()).sum::<f64>().sqrt()
}

impl Factored {
    /// Factors the matrix with the given columns; `None` if there are more columns than rows or a number is not finite.
    pub(crate) fn new(columns: Vec<Vec<C>>) -> Option<Self> {
        let rows = columns.first().map_or(0, Vec::len);
        let finite = |c: &C| c.re.is_finite() && c.im.is_finite();
        if columns.len() > rows || !columns.iter().flatten().all(finite) {
            return None;
        }
        let mut columns = columns;
        let mut diagonal = Vec::with_capacity(columns.len());
        let mut factors = Vec::with_capacity(columns.len());
        for j in 0..columns.len() {
            let (done, rest) = columns.split_at_mut(j + 1);
            let vector = &mut done[j][j..];
            let length = norm(vector);
            if length == 0.0 {
                diagonal.push(ZERO);
                factors.push(0.0);
                continue;
            }
            let head = vector[0];
            let phase = if head == ZERO { C::new(1.0, 0.0) } else { head / head.norm() };
            let reflected = -phase * length;
            vector[0] = head - reflected;
            let factor = 2.0 / vector.iter().map(C::norm_sqr).sum::<f64>();
            diagonal.push(reflected);
            factors.push(factor);
            for column in rest {
                reflect(vector, factor, &mut column[j..]);
            }
        }
        Some(Self { rows, columns, diagonal, factors })
    }

    fn size(&self) -> usize {
        self.columns.len()
    }

    /// The least-squares solution for one right-hand side; not finite if the matrix is exactly rank deficient.
    pub(crate) fn solve(&self, right: &[C]) -> Vec<C> {
        let mut right = right.to_vec();
        right.resize(self.rows, ZERO);
        for j in 0..self.size() {
            reflect(&self.columns[j][j..], self.factors[j], &mut right[j..]);
        }
        right.truncate(self.size());
        self.back_substitute(&mut right);
        right
    }

    /// `R x = b`, in place.
    fn back_substitute(&self, b: &mut [C]) {
        for j in (0..self.size()).rev() {
            b[j] /= self.diagonal[j];
            let value = b[j];
            for (x, r) in b[..j].iter_mut().zip(&self.columns[j][..j]) {
                *x -= r * value;
            }
        }
    }

    /// `R^H x = b`, in place.
    fn forward_substitute(&self, b: &mut [C]) {
        for j in 0..self.size() {
            let sum: C = self.columns[j][..j].iter().zip(&*b).map(|(r, x)| r.conj() * x).sum();
            b[j] = (b[j] - sum) / self.diagonal[j].conj();
        }
    }

    /// The smallest singular value and its right singular vector, by inverse iteration on R.
    pub(crate) fn smallest_singular(&self) -> (f64, Vec<C>) {
        let n = self.size();
        if let Some(j) = self.diagonal.iter().position(|d| *d == ZERO) {
            // Exactly singular: R x = 0 with x_j = 1 and nothing below.
            let mut vector = vec![ZERO; n];
            vector[j] = C::new(1.0, 0.0);
            for i in (0..j).rev() {
                let sum: C = (i + 1..=j).map(|k| self.columns[k][i] * vector[k]).sum();
                vector[i] = -sum / self.diagonal[i];
            }
            let length = norm(&vector);
            return (0.0, vector.iter().map(|x| x / length).collect());
        }
        // A fixed start without symmetry, so that no singular vector is orthogonal to it by structure.
        let mut vector: Vec<C> = (0..n)
            .map(|k| C::new(1.0 + 0.37 * u32::try_from(k % 7).map_or(0.0, f64::from), 0.0))
            .collect();
        let mut singular = 0.0;
        for _ in 0..INVERSE_ITERATIONS {
            self.forward_substitute(&mut vector);
            self.back_substitute(&mut vector);
            let length = norm(&vector);
            if !length.is_finite() || length == 0.0 {
                break;
            }
            for x in &mut vector {
                *x /= length;
            }
            singular = 1.0 / length.sqrt();
        }
        (singular, vector)
    }

    /// The pseudoinverse, one vector per row of the matrix: entry `[k][i]` is the change of unknown i per unit of residual k.
    pub(crate) fn pseudoinverse_columns(&self) -> Vec<Vec<C>> {
        (0..self.rows)
            .map(|k| {
                let mut unit = vec![ZERO; self.rows];
                unit[k] = C::new(1.0, 0.0);
                self.solve(&unit)
            })
            .collect()
    }
}

/// Applies `I - factor v v^H`.
fn reflect(v: &[C], factor: f64, x: &mut [C]) {
    if factor == 0.0 {
        return;
    }
    let product: C = v.iter().zip(&*x).map(|(a, b)| a.conj() * b).sum();
    let step = product * factor;
    for (b, a) in x.iter_mut().zip(v) {
        *b -= a * step;
    }
}
