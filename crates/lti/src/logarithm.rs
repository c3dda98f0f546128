//! The principal matrix logarithm by inverse scaling and squaring on the Schur form
//! (Al-Mohy & Higham 2012, Higham 2008 chapter 11).

use nalgebra::DMatrix;
use num_complex::Complex;

use crate::LtiError;
use crate::complex_schur::{ComplexSchur, complex_schur};
use crate::dense::CMatrix;
use crate::eigen::eigenvalues;
use crate::exponential::exponential;
use crate::scaling::{balance_similarity, norm_1};
use crate::state_space::{check_finite, check_square};

/// With ||X||_1 at most this the Pade approximant of log(I + X) of degree 7 is correct to 1e-16
/// (Higham, Functions of Matrices, 2008, chapter 11).
const THETA_7: f64 = 0.264;

/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1] (Abramowitz & Stegun, table 25.4, n = 7).
const NODES: [(f64, f64); 7] = [
    (-0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
    (-0.741_531_185_599_394_5, 0.279_705_391_489_276_64),
    (-0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.0, 0.417_959_183_673_469_4),
    (0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.741_531_185_599_394_5, 0.279_705_391_489_276_64),
    (0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
];

/// A real logarithm, and how well its exponential gives the matrix back.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Logarithm {
    /// log(A): the principal logarithm, eigenvalues with imaginary part in (-pi, pi).
    pub value: DMatrix<f64>,
    /// ||exp(log(A)) - A|| / ||A|| in the 1-norm.
    pub residual: f64,
    /// How many square roots were taken.
    pub square_roots: usize,
}

/// The principal logarithm of a real matrix: exp(X) = A with the eigenvalues of X in the strip |im| < pi.
///
/// Method: diagonal balancing by powers of two; next to the identity the Pade approximant of degree 7 at once,
/// elsewhere complex Schur form, square roots of the triangular factor until
/// it is close to the identity (Bjorck & Hammarling 1983), a Gauss-Legendre form of the Pade approximant of
/// degree 7, and the diagonal and first superdiagonal recomputed from their closed forms.
///
/// # Errors
///
/// [`LtiError::NoRealLogarithm`] if an eigenvalue is negative, zero, or below the rounding level n u ||A|| where
/// it can't be told from zero; [`LtiError::NotSquare`], [`LtiError::NotFinite`]; [`LtiError::NotConverged`] if
/// the Schur form does not converge.
///
/// # Example
///
/// ```
/// use lti::logarithm;
/// use nalgebra::dmatrix;
/// let log = logarithm(&dmatrix![1.0, 3.0; 0.0, 1.0])?;
/// assert_eq!(log.value, dmatrix![0.0, 3.0; 0.0, 0.0]);
/// # Ok::<(), lti::LtiError>(())
/// ```
pub fn logarithm(a: &DMatrix<f64>) -> Result<Logarithm, LtiError> {
    check_square("the matrix", a)?;
    check_finite("the matrix", a)?;
    let n = a.nrows();
    if n == 0 {
        return Ok(Logarithm { value: a.clone(), residual: 0.0, square_roots: 0 });
    }
    check_spectrum(a)?;
    let (balanced, diagonal) = balance_similarity(a);
    let minus_identity = &balanced - DMatrix::identity(n, n);
    let (mut value, square_roots) = if norm_1(&minus_identity) <= THETA_7 {
        // Next to the identity no Schur form is needed, and the small entries keep their relative accuracy.
        (pade_log1p_real(&minus_identity)?, 0)
    } else {
        let ComplexSchur { q, t } = complex_schur(&balanced)?;
        let (logarithm, square_roots) = logarithm_of_triangular(&t);
        ((&q * logarithm * q.adjoint()).map(|x| x.re), square_roots)
    };
    for j in 0..n {
        for i in 0..n {
            value[(i, j)] *= diagonal[i] / diagonal[j];
        }
    }
    if value.iter().any(|x| !x.is_finite()) {
        return Err(LtiError::Overflow { operation: "the matrix logarithm" });
    }
    let residual = norm_1(&(exponential(&value)? - a)) / norm_1(a);
    Ok(Logarithm { value, residual, square_roots })
}

fn check_spectrum(a: &DMatrix<f64>) -> Result<(), LtiError> {
    let rounding_level = a.nrows() as f64 * f64::EPSILON * a.norm();
    for eigenvalue in eigenvalues(a)? {
        if (eigenvalue.im == 0.0 && eigenvalue.re <= 0.0) || eigenvalue.norm() <= rounding_level {
            return Err(LtiError::NoRealLogarithm { eigenvalue });
        }
    }
    Ok(())
}

fn logarithm_of_triangular(triangular: &CMatrix) -> (CMatrix, usize) {
    const MOST_SQUARE_ROOTS: usize = 1200; // The range of the exponent: nothing finite needs more.
    let n = triangular.nrows();
    let mut root = triangular.clone();
    let mut square_roots = 0;
    let near_identity = |root: &CMatrix, count: usize| {
        let mut x = root.clone();
        for i in 0..n {
            x[(i, i)] = root_minus_one(triangular[(i, i)], count);
        }
        x
    };
    let mut x = near_identity(&root, 0);
    while complex_norm_1(&x) > THETA_7 && square_roots < MOST_SQUARE_ROOTS {
        root = square_root_of_triangular(&root);
        square_roots += 1;
        for i in 0..n {
            // The diagonal from the diagonal, not from roots of roots.
            root[(i, i)] = root_minus_one(triangular[(i, i)], square_roots) + 1.0;
        }
        x = near_identity(&root, square_roots);
    }
    let mut logarithm = pade_log1p(&x);
    for _ in 0..square_roots {
        logarithm *= Complex::new(2.0, 0.0);
    }
    for i in 0..n {
        logarithm[(i, i)] = log(triangular[(i, i)]);
    }
    for i in 0..n.saturating_sub(1) {
        logarithm[(i, i + 1)] = superdiagonal_of_logarithm(
            triangular[(i, i)],
            triangular[(i + 1, i + 1)],
            triangular[(i, i + 1)],
        );
    }
    (logarithm, square_roots)
}

fn log(z: Complex<f64>) -> Complex<f64> {
    Complex::new(crate::time::log_modulus(z), z.arg())
}

/// z^(1/2^k) - 1 without cancellation (Al-Mohy, Numer. Algorithms 59 (2012)).
fn root_minus_one(z: Complex<f64>, k: usize) -> Complex<f64> {
    if k == 0 {
        return z - 1.0;
    }
    let (mut root, mut left) = (z, k);
    if root.arg().abs() >= core::f64::consts::FRAC_PI_2 {
        root = root.sqrt();
        left -= 1;
    }
    let difference = root - 1.0;
    // z - 1 = (z^(1/2) - 1)(z^(1/2) + 1), again and again.
    let mut product = Complex::new(1.0, 0.0);
    for _ in 0..left {
        root = root.sqrt();
        product *= root + 1.0;
    }
    difference / product
}

/// The principal square root of an upper triangular matrix (Bjorck & Hammarling 1983).
fn square_root_of_triangular(t: &CMatrix) -> CMatrix {
    let n = t.nrows();
    let mut root = CMatrix::zeros(n, n);
    for j in 0..n {
        root[(j, j)] = t[(j, j)].sqrt();
        for i in (0..j).rev() {
            let mut sum = t[(i, j)];
            for k in i + 1..j {
                sum -= root[(i, k)] * root[(k, j)];
            }
            root[(i, j)] = sum / (root[(i, i)] + root[(j, j)]);
        }
    }
    root
}

/// As [`pade_log1p`], for a real matrix that needn't be triangular.
fn pade_log1p_real(x: &DMatrix<f64>) -> Result<DMatrix<f64>, LtiError> {
    let n = x.nrows();
    let mut sum = DMatrix::zeros(n, n);
    for (node, weight) in NODES {
        let shifted = DMatrix::identity(n, n) + x * (0.5 * (1.0 + node));
        let term = shifted
            .lu()
            .solve(x)
            .ok_or(LtiError::Overflow { operation: "the matrix logarithm" })?;
        sum += term * (0.5 * weight);
    }
    Ok(sum)
}

/// log(I + X) by the Pade approximant of degree 7 in the form sum_j w_j (I + x_j X)^-1 X,
/// x_j and w_j the nodes and weights of Gauss-Legendre quadrature on [0, 1].
fn pade_log1p(x: &CMatrix) -> CMatrix {
    let n = x.nrows();
    let mut sum = CMatrix::zeros(n, n);
    for (node, weight) in NODES {
        let mut shifted = x * Complex::new(0.5 * (1.0 + node), 0.0);
        for i in 0..n {
            shifted[(i, i)] += 1.0;
        }
        sum += solve_upper_triangular(&shifted, x) * Complex::new(0.5 * weight, 0.0);
    }
    sum
}

/// T^-1 X for upper triangular T with a diagonal away from zero and upper triangular X.
fn solve_upper_triangular(t: &CMatrix, x: &CMatrix) -> CMatrix {
    let n = t.nrows();
    let mut solution = x.clone();
    for j in 0..n {
        for i in (0..=j).rev() {
            let mut sum = solution[(i, j)];
            for k in i + 1..=j {
                sum -= t[(i, k)] * solution[(k, j)];
            }
            solution[(i, j)] = sum / t[(i, i)];
        }
    }
    solution
}

/// The entry (1, 2) of the logarithm of [a t; 0 b]: t (log b - log a) / (b - a), without cancellation
/// (Higham 2008, eq. (11.28)).
fn superdiagonal_of_logarithm(a: Complex<f64>, b: Complex<f64>, t: Complex<f64>) -> Complex<f64> {
    if a == b {
        return t / a;
    }
    if a.norm() < 0.5 * b.norm() || b.norm() < 0.5 * a.norm() {
        return t * (log(b) - log(a)) / (b - a);
    }
    let ratio = (b - a) / (b + a);
    let unwinding = ((log(b) - log(a)).im / core::f64::consts::TAU).round();
    // log b - log a = 2 atanh(ratio) + 2 pi i unwinding.
    let difference = atanh(ratio) * 2.0 + Complex::new(0.0, core::f64::consts::TAU * unwinding);
    t * difference / (b - a)
}

/// atanh(z) = log(1 + 2 z / (1 - z)) / 2, with full relative accuracy for small z.
fn atanh(z: Complex<f64>) -> Complex<f64> {
    let w = z * 2.0 / (1.0 - z);
    let modulus = 0.5 * (2.0 * w.re + w.norm_sqr()).ln_1p();
    Complex::new(modulus, w.im.atan2(1.0 + w.re)) * 0.5
}

fn complex_norm_1(matrix: &CMatrix) -> f64 {
    matrix.column_iter().map(|column| column.iter().map(|x| x.norm()).sum()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
