//! Eigenvalues and both kinds of eigenvectors of a real matrix, refined and with their condition numbers.

use doubled::{DoubleDoubleComplex, times_power_of_two};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, MatRef, Par};
use nalgebra::DMatrix;
use num_complex::Complex;

use crate::LtiError;
use crate::dense::CVector;
use crate::doubled_product::row_product;
use crate::scaling::{WidelyBalanced, balance_widely, exponent};

/// One eigenvalue with its vectors: A v = lambda v, w^H A = lambda w^H, |v| = 1 and w^H v = 1.
#[derive(Debug, Clone)]
pub(crate) struct Eigenpair {
    pub(crate) value: Complex<f64>,
    /// Unit length, its largest component real and positive.
    pub(crate) right: CVector,
    /// Scaled so that w^H v = 1; of unit length if the condition is infinite.
    pub(crate) left: CVector,
    /// |v| |w| / |w^H v| in the coordinates of A; infinite for a defective eigenvalue and beyond about 1e307.
    pub(crate) condition: f64,
    /// |w|^T |A| |v| / |w^H v|: the change of the eigenvalue per relative change of the entries of A.
    pub(crate) entrywise_condition: f64,
}

/// The order of eigenvalues everywhere in this crate: by real part, then by modulus of the imaginary part,
/// ascending, positive imaginary part first. The roots of polynomials come in the same order.
pub(crate) fn compare(x: &Complex<f64>, y: &Complex<f64>) -> core::cmp::Ordering {
    x.re.total_cmp(&y.re).then(x.im.abs().total_cmp(&y.im.abs())).then(y.im.total_cmp(&x.im))
}

/// The eigenvalues of a square finite matrix in the order of [`compare`]; conjugate pairs are exact.
pub(crate) fn eigenvalues(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, LtiError> {
    Ok(eigenpairs(a)?.into_iter().map(|pair| pair.value).collect())
}

/// The eigenpairs of a square finite matrix in the order of [`compare`].
///
/// A is balanced, faer's QR algorithm gives values and vectors, and each value is refined once by its two-sided
/// Rayleigh quotient with a residual in double-double arithmetic. The error of a simple eigenvalue is then of
/// second order in the error of its vectors: almost full accuracy unless it is ill conditioned.
///
/// The entries may have any exponents. Errors are relative to the norm of the balanced matrix: a value more than
/// 2^-1074 below it, as in diag(1e300, 1e-300), comes out as 0. An eigenvalue that is not a finite number is
/// [`LtiError::Overflow`].
pub(crate) fn eigenpairs(a: &DMatrix<f64>) -> Result<Vec<Eigenpair>, LtiError> {
    let n = a.nrows();
    if n == 0 {
        return Ok(Vec::new());
    }
    let WidelyBalanced { matrix, diagonal, scale } = balance_widely(a);
    let raw = raw_eigenpairs(&matrix)?;
    let norm = matrix.norm();
    let mut pairs = Vec::with_capacity(n);
    for (value, right, left) in raw {
        let value = refined(&matrix, norm, value, &right, &left);
        check_residual(&matrix, norm, value, &right)?;
        let entrywise_condition =
            times_power_of_two(entrywise_condition(&matrix, &right, &left), scale);
        let original_right = in_units(&right, |i| diagonal[i]);
        let original_left = in_units(&left, |i| -diagonal[i]);
        let (right, left, condition) = normalised(original_right, original_left);
        // Asked before scaling, which may take the imaginary part out of the range.
        let complex = value.im != 0.0;
        let value = scaled(value, scale)?;
        if complex {
            // A pair whose imaginary part is too small for a double is two equal real values: both im = +0.
            pairs.push(Eigenpair {
                value: Complex::new(value.re, 0.0 - value.im),
                right: right.map(|x| x.conj()),
                left: left.map(|x| x.conj()),
                condition,
                entrywise_condition,
            });
        }
        pairs.push(Eigenpair { value, right, left, condition, entrywise_condition });
    }
    pairs.sort_by(|x, y| compare(&x.value, &y.value));
    Ok(pairs)
}

/// value 2^exponent, which has to be a finite number.
fn scaled(value: Complex<f64>, exponent: i32) -> Result<Complex<f64>, LtiError> {
    let part = |x: f64| times_power_of_two(x, exponent);
    let result = Complex::new(part(value.re), part(value.im));
    if result.is_finite() {
        Ok(result)
    } else {
        Err(LtiError::Overflow { operation: "an eigenvalue of the state matrix" })
    }
}

/// The components times 2^power(i), all divided by one power of two that makes the largest about 1.
fn in_units(vector: &CVector, power: impl Fn(usize) -> i32) -> CVector {
    let nonzero = vector.iter().enumerate().filter(|(_, x)| x.norm() > 0.0);
    let top = nonzero.map(|(i, x)| exponent(x.norm()) + power(i)).max().unwrap_or(0);
    CVector::from_fn(vector.len(), |i, _| {
        let part = |x: f64| times_power_of_two(x, power(i) - top);
        Complex::new(part(vector[i].re), part(vector[i].im))
    })
}

/// (lambda, v, w) from faer; of a complex pair only the one with positive imaginary part.
fn raw_eigenpairs(a: &DMatrix<f64>) -> Result<Vec<(Complex<f64>, CVector, CVector)>, LtiError> {
    let n = a.nrows();
    let view = MatRef::from_column_major_slice(a.as_slice(), n, n);
    let mut re = Diag::<f64>::zeros(n);
    let mut im = Diag::<f64>::zeros(n);
    let mut left = Mat::<f64>::zeros(n, n);
    let mut right = Mat::<f64>::zeros(n, n);
    let scratch = evd_scratch::<f64>(
        n,
        ComputeEigenvectors::Yes,
        ComputeEigenvectors::Yes,
        Par::Seq,
        Default::default(),
    );
    evd_real(
        view,
        re.as_mut(),
        im.as_mut(),
        Some(left.as_mut()),
        Some(right.as_mut()),
        Par::Seq,
        MemStack::new(&mut MemBuffer::new(scratch)),
        Default::default(),
    )
    .map_err(|_| LtiError::NotConverged {
        operation: "the eigenvalue iteration",
        residual: f64::NAN,
    })?;

    let mut pairs = Vec::with_capacity(n);
    let mut j = 0;
    while j < n {
        let value = Complex::new(re[j], im[j]);
        if value.im == 0.0 || j + 1 == n {
            let column = |m: &Mat<f64>| CVector::from_fn(n, |i, _| Complex::new(m[(i, j)], 0.0));
            pairs.push((Complex::new(value.re, 0.0), column(&right), column(&left)));
            j += 1;
        } else {
            let column =
                |m: &Mat<f64>| CVector::from_fn(n, |i, _| Complex::new(m[(i, j)], m[(i, j + 1)]));
            let (value, v, w) = (value, column(&right), column(&left));
            if value.im > 0.0 {
                pairs.push((value, v, w));
            } else {
                pairs.push((value.conj(), v.map(|x| x.conj()), w.map(|x| x.conj())));
            }
            j += 2;
        }
    }
    Ok(pairs)
}

/// A v - lambda v, each component summed in double-double arithmetic and then rounded.
fn residual(a: &DMatrix<f64>, value: Complex<f64>, right: &CVector) -> CVector {
    CVector::from_fn(a.nrows(), |i, _| {
        (row_product(a, i, right) - DoubleDoubleComplex::product(value, right[i])).value()
    })
}

/// lambda + w^H (A v - lambda v) / (w^H v), where that is a correction of the size rounding explains.
fn refined(
    a: &DMatrix<f64>,
    norm: f64,
    value: Complex<f64>,
    right: &CVector,
    left: &CVector,
) -> Complex<f64> {
    // Beyond this condition the vectors are too wrong for the quotient to gain anything.
    const WORST_CONDITION: f64 = 1e6;
    let overlap = left.dotc(right);
    let condition = left.norm() * right.norm() / overlap.norm();
    let accepted = condition < WORST_CONDITION;
    if !accepted {
        return value;
    }
    let mut correction = left.dotc(&residual(a, value, right)) / overlap;
    if value.im == 0.0 {
        correction.im = 0.0;
    }
    let explained = 100.0 * a.nrows() as f64 * f64::EPSILON * norm * condition;
    let candidate = value + correction;
    // A pair stays a pair.
    let same_kind = (value.im == 0.0) == (candidate.im == 0.0) && candidate.im >= 0.0;
    if correction.norm() <= explained && same_kind { candidate } else { value }
}

fn check_residual(
    a: &DMatrix<f64>,
    norm: f64,
    value: Complex<f64>,
    right: &CVector,
) -> Result<(), LtiError> {
    // A backward stable method leaves about n u; this only tells a result from none.
    const FAR_FROM_ANY_RESULT: f64 = 1e-8;
    let size = norm * right.norm();
    let relative = if size == 0.0 { right.norm() } else { residual(a, value, right).norm() / size };
    let found = right.norm() > 0.0 && (size == 0.0 || relative <= FAR_FROM_ANY_RESULT);
    if found {
        Ok(())
    } else {
        Err(LtiError::NotConverged { operation: "the eigenvalue iteration", residual: relative })
    }
}

fn entrywise_condition(a: &DMatrix<f64>, right: &CVector, left: &CVector) -> f64 {
    let mut sum = 0.0;
    for j in 0..a.ncols() {
        for i in 0..a.nrows() {
            sum += left[i].norm() * a[(i, j)].abs() * right[j].norm();
        }
    }
    let overlap = left.dotc(right).norm();
    if overlap > 0.0 { sum / overlap } else { f64::INFINITY }
}

/// Unit length, largest component real and positive; w^H v = 1. Also the condition |v| |w| / |w^H v|.
fn normalised(right: CVector, left: CVector) -> (CVector, CVector, f64) {
    // Largest components to order one first: the powers of two of the balancing can be far apart.
    let right = &right / Complex::new(largest(&right).1, 0.0);
    let left = &left / Complex::new(largest(&left).1, 0.0);
    let (index, size) = largest(&right);
    let phase = right[index] / size;
    let right = &right / (phase * right.norm());
    let overlap = left.dotc(&right);
    let length = left.norm();
    if overlap.norm() <= f64::MIN_POSITIVE * length {
        let unit = &left / Complex::new(length, 0.0);
        return (right, unit, f64::INFINITY);
    }
    // The division and the norm square their operands: everything of order one first.
    let small = -exponent(overlap.norm());
    let times = |z: Complex<f64>| {
        Complex::new(times_power_of_two(z.re, small), times_power_of_two(z.im, small))
    };
    let left = left / times(overlap).conj();
    let condition = times_power_of_two(left.norm(), small);
    let left = left.map(times);
    (right, left, condition)
}

fn largest(vector: &CVector) -> (usize, f64) {
    let mut best = (0, 0.0);
    for (i, x) in vector.iter().enumerate() {
        // A tie within rounding goes to the first component, so that the choice doesn't hang on the last digit.
        if x.norm() > best.1 * (1.0 + 1e-10) {
            best = (i, x.norm());
        }
    }
    if best.1 > 0.0 { best } else { (0, 1.0) }
}

#[cfg(test)]
mod tests;
