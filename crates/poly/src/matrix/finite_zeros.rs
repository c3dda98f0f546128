//! The finite zeros of a square polynomial matrix: where its determinant vanishes.
//!
//! `M(p) = M_0 + M_1 p + ... + M_d p^d` is scaled, written as the companion pencil `p E - A` of size `n d` and solved by the
//! QZ algorithm, so no determinant is expanded for the zeros themselves. Each zero is then refined by Newton's method on
//! the smallest singular value of `M(z)`: with singular vectors u, v the step is `-s / (u^H M'(z) v)`.

#[cfg(test)]
mod tests;

use super::PolyMatrix;
use crate::PolyError;
use crate::aberth::scale_by_power;
use crate::mroots::{order, symmetrize};
use faer::{Mat, c64};
use num_complex::Complex;

type C = Complex<f64>;

/// A matrix is taken as singular at a point when its smallest singular value is this many roundings of the largest.
const SINGULAR: f64 = 100.0;

/// Angles of the points at which the normal rank is tested: none of them special.
const TEST_ANGLES: [f64; 5] = [0.31, 1.13, 1.97, 2.41, 2.93];

/// Refinement steps; each must make the smallest singular value smaller.
const REFINEMENTS: usize = 5;

/// One zero of a polynomial matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FiniteZero {
    /// Where it is.
    pub value: C,
    /// Smallest singular value of `M(z)` over `sum |M_k| |z|^k` in Frobenius norms: the relative change of the
    /// coefficients that makes `value` a zero.
    pub residual: f64,
    /// `sum |M_k| |z|^k / (max(|z|, s) |u^H M'(z) v|)`: relative change of the zero per relative change of the
    /// coefficients, to first order; s is the scale of the zeros, a power of two (Tisseur 2000). Large for multiple zeros.
    pub condition: f64,
}

/// The finite zeros of a square polynomial matrix; made by [`PolyMatrix::finite_zeros`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FiniteZeros {
    /// The zeros, each as often as it occurs, by ascending real part, then modulus of the imaginary part, positive
    /// imaginary part first. Empty if the matrix is singular.
    pub zeros: Vec<FiniteZero>,
    /// Size of the pencil minus the number of finite zeros.
    pub infinite: usize,
    /// Rank of `M(z)` at general z.
    pub normal_rank: usize,
    /// Whether the determinant is the zero polynomial to rounding, so that every number is a zero.
    pub singular: bool,
    /// Whether every zero's residual is at rounding level, and the QZ algorithm and the degree of the determinant agree.
    pub converged: bool,
}

impl PolyMatrix<f64> {
    /// The zeros of the determinant, without expanding it.
    ///
    /// Zeros are exactly real or exactly conjugate. If the matrix of highest coefficients has full rank, there are as
    /// many as the pencil is large; else the number is the degree of [`PolyMatrix::determinant_f64`], where
    /// leading coefficients within their rounding error count as zero.
    ///
    /// # Errors
    /// [`PolyError::NotSquare`], [`PolyError::NonFiniteCoefficient`], [`PolyError::Overflow`].
    ///
    /// # Example
    /// ```
    /// use poly::PolyMatrix;
    ///
    /// // The zeros of pI - A are the eigenvalues of A: 1 and (3 +- j sqrt 3)/2.
    /// let m = PolyMatrix::linear(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
    ///     &[1.0, 1.0, 1.0, 0.0, 2.0, -1.0, 0.0, 1.0, 1.0])?;
    /// let zeros = m.finite_zeros()?.zeros;
    /// assert!((zeros[0].value.re - 1.0).abs() < 1e-15);
    /// assert!((zeros[1].value.im - 0.75_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn finite_zeros(&self) -> Result<FiniteZeros, PolyError> {
        let determinant = self.determinant_f64()?;
        let n = self.rows;
        let Some(degree) = self.degree().filter(|_| n > 0) else {
            // Empty or zero.
            let singular = n > 0;
            return Ok(FiniteZeros {
                zeros: Vec::new(),
                infinite: 0,
                normal_rank: 0,
                singular,
                converged: true,
            });
        };
        let scaled = Scaled::new(self, degree);
        let normal_rank = TEST_ANGLES
            .iter()
            .filter_map(|&angle| scaled.rank(C::from_polar(1.0, angle)))
            .max()
            .unwrap_or(0);
        let size = n * degree;
        let singular = normal_rank < n || determinant.polynomial.is_zero();
        if singular {
            return Ok(FiniteZeros {
                zeros: Vec::new(),
                infinite: 0,
                normal_rank,
                singular,
                converged: true,
            });
        }
        // A leading matrix of full rank leaves no zero at infinity; else the degree of the determinant decides.
        let count = if scaled.has_full_leading_rank() {
            size
        } else {
            determinant.polynomial.degree().unwrap_or(0).min(size)
        };
        let Some(mut values) = scaled.pencil_eigenvalues() else {
            return Ok(FiniteZeros {
                zeros: Vec::new(),
                infinite: size - count,
                normal_rank,
                singular,
                converged: false,
            });
        };
        values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        values.truncate(count);
        let complete = values.len() == count;
        let mut zeros: Vec<FiniteZero> =
            symmetrize(&values).into_iter().filter_map(|y| scaled.refine(y)).collect();
        let level = 1e3 * f64::EPSILON * f64::from(u32::try_from(size).unwrap_or(u32::MAX));
        let converged =
            complete && zeros.len() == count && zeros.iter().all(|zero| zero.residual <= level);
        zeros.sort_by(|a, b| order(a.value, b.value));
        Ok(FiniteZeros { zeros, infinite: size - count, normal_rank, singular, converged })
    }
}

/// `M(2^e y)` with rows scaled to about 1.
struct Scaled {
    size: usize,
    degree: usize,
    exponent: i64,
    /// Coefficient matrices, row by row, degree ascending.
    coefficients: Vec<Vec<f64>>,
    norms: Vec<f64>,
}

impl Scaled {
    fn new(matrix: &PolyMatrix<f64>, degree: usize) -> Self {
        let n = matrix.rows;
        let exponent = matrix.variable_exponent();
        let mut coefficients = vec![vec![0.0; n * n]; degree + 1];
        for i in 0..n {
            let row = &matrix.entries[i * n..(i + 1) * n];
            let heights = row.iter().flat_map(|p| {
                p.coefficients()
                    .iter()
                    .zip(0..)
                    .filter(|(c, _)| **c != 0.0)
                    .map(|(c, k): (&f64, i64)| log2_floor(*c) + exponent * k)
            });
            let shift = heights.max().unwrap_or(0);
            for (j, p) in row.iter().enumerate() {
                for ((&c, matrix), k) in p.coefficients().iter().zip(&mut coefficients).zip(0..) {
                    let scaled: i64 = exponent * k - shift;
                    matrix[i * n + j] = scale_by_power(C::new(c, 0.0), scaled).re;
                }
            }
        }
        let norms =
            coefficients.iter().map(|m| m.iter().map(|c| c * c).sum::<f64>().sqrt()).collect();
        Self { size: n, degree, exponent, coefficients, norms }
    }

    /// The matrix and its derivative at y.
    fn at(&self, y: C) -> (Mat<c64>, Mat<c64>) {
        let n = self.size;
        let entry = |i: usize, j: usize| {
            let mut value = C::new(0.0, 0.0);
            let mut slope = C::new(0.0, 0.0);
            for matrix in self.coefficients.iter().rev() {
                slope = slope * y + value;
                value = value * y + matrix[i * n + j];
            }
            (value, slope)
        };
        (Mat::from_fn(n, n, |i, j| entry(i, j).0), Mat::from_fn(n, n, |i, j| entry(i, j).1))
    }

    fn rank(&self, y: C) -> Option<usize> {
        self.numerical_rank(&self.at(y).0)
    }

    fn has_full_leading_rank(&self) -> bool {
        let n = self.size;
        let leading = &self.coefficients[self.degree];
        let matrix = Mat::from_fn(n, n, |i, j| C::new(leading[i * n + j], 0.0));
        self.numerical_rank(&matrix) == Some(n)
    }

    fn numerical_rank(&self, matrix: &Mat<c64>) -> Option<usize> {
        let singular = matrix.singular_values().ok()?;
        let largest = singular.iter().copied().fold(0.0, f64::max);
        let n = f64::from(u32::try_from(self.size).unwrap_or(u32::MAX));
        let level = SINGULAR * n * f64::EPSILON * largest;
        Some(singular.iter().filter(|&&s| s > level).count())
    }

    /// Eigenvalues of the companion pencil; `None` if the QZ algorithm fails. Infinite ones are left out.
    fn pencil_eigenvalues(&self) -> Option<Vec<C>> {
        let (n, size) = (self.size, self.size * self.degree);
        // A = [-M_(d-1) ... -M_0; I 0], E = diag(M_d, I): complex, since the real QZ of faer 0.24 cannot do pairs.
        let a = Mat::<c64>::from_fn(size, size, |i, j| {
            let value = if i < n {
                -self.coefficients[self.degree - 1 - j / n][i * n + j % n]
            } else if i - n == j {
                1.0
            } else {
                0.0
            };
            C::new(value, 0.0)
        });
        let e = Mat::<c64>::from_fn(size, size, |i, j| {
            let value = if i < n && j < n {
                self.coefficients[self.degree][i * n + j]
            } else if i == j {
                1.0
            } else {
                0.0
            };
            C::new(value, 0.0)
        });
        if size == 1 {
            return Some([a[(0, 0)] / e[(0, 0)]].into_iter().filter(|y| y.is_finite()).collect());
        }
        let eigen = a.generalized_eigen(&e).ok()?;
        let (alpha, beta) = (eigen.S_a(), eigen.S_b());
        let quotients = alpha.column_vector().iter().zip(beta.column_vector().iter());
        Some(quotients.map(|(a, b)| a / b).filter(|y| y.is_finite()).collect())
    }

    /// Newton's method on the smallest singular value, and what it says about the zero.
    fn refine(&self, start: C) -> Option<FiniteZero> {
        let mut best = self.singular(start)?;
        for _ in 0..REFINEMENTS {
            let mut step = best.value / best.slope;
            if start.im == 0.0 {
                step.im = 0.0;
            }
            let next = best.y - step;
            if !next.is_finite() || next == best.y {
                break;
            }
            match self.singular(next) {
                Some(there) if there.value < best.value => best = there,
                _ => break,
            }
        }
        let modulus = best.y.norm();
        let terms = self.norms.iter().rev().fold(0.0, |sum, norm| sum * modulus + norm);
        Some(FiniteZero {
            value: scale_by_power(best.y, self.exponent),
            residual: best.value / terms,
            condition: terms / (modulus.max(1.0) * best.slope.norm()),
        })
    }

    fn singular(&self, y: C) -> Option<Singular> {
        let (matrix, derivative) = self.at(y);
        let svd = matrix.svd().ok()?;
        let last = self.size - 1;
        let (u, v) = (svd.U().col(last), svd.V().col(last));
        let slope = u.adjoint() * &derivative * v;
        Some(Singular { y, value: svd.S()[last].re, slope })
    }
}

/// The smallest singular value at y and its derivative in y.
struct Singular {
    y: C,
    value: f64,
    slope: C,
}

fn log2_floor(c: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "a binary logarithm of a float")]
    let integer = c.abs().log2().floor() as i64;
    integer
}
