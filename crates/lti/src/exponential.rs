//! The matrix exponential by scaling and squaring (Al-Mohy & Higham 2009), kept as exp(A) - I where that is
//! the more accurate.

use nalgebra::DMatrix;

use crate::LtiError;
use crate::scaling::{balance_similarity, exponent, invertible_power_of_two, norm_1};
use crate::state_space::{check_finite, check_square};

/// Largest norms for which the Pade approximants of degree 3, 5, 7, 9 and 13 have a backward error below 2^-53
/// (Al-Mohy & Higham, SIAM J. Matrix Anal. Appl. 31 (2009)).
const THETA: [(usize, f64); 5] = [
    (3, 1.495_585_217_958_292e-2),
    (5, 2.539_398_330_063_23e-1),
    (7, 9.504_178_996_162_932e-1),
    (9, 2.097_847_961_257_068),
    (13, 4.25),
];

/// The matrix exponential, exp(A) = I + A + A^2/2 + ...
///
/// Method: diagonal balancing by powers of two, Pade approximants of degree 3 to 13 with scaling and squaring
/// (Al-Mohy & Higham 2009). The part exp(A) - I is carried along, so that the entries of a transition matrix
/// close to the identity keep their relative accuracy.
///
/// # Errors
///
/// [`LtiError::NotSquare`], [`LtiError::NotFinite`], and [`LtiError::Overflow`] where exp(A) is too large.
///
/// # Example
///
/// ```
/// use lti::exponential;
/// use nalgebra::dmatrix;
/// // A nilpotent matrix: the series ends.
/// let e = exponential(&dmatrix![0.0, 3.0; 0.0, 0.0])?;
/// assert_eq!(e, dmatrix![1.0, 3.0; 0.0, 1.0]);
/// # Ok::<(), lti::LtiError>(())
/// ```
pub fn exponential(a: &DMatrix<f64>) -> Result<DMatrix<f64>, LtiError> {
    check_square("the exponent", a)?;
    check_finite("the exponent", a)?;
    let parts = exponential_parts(a)?;
    Ok(parts.exponential())
}

/// Two forms of the exponential, each the more accurate in its place.
pub(crate) struct Exponential {
    /// exp(A) - I.
    pub(crate) minus_identity: DMatrix<f64>,
    /// exp(A), squared up on its own.
    direct: DMatrix<f64>,
    squarings: usize,
}

impl Exponential {
    /// exp(A) from the form with the smaller error bound.
    ///
    /// The error of exp(A) - I is about u in absolute terms, because a squaring X -> 2X + X^2 doubles the error
    /// together with the quantity; that of the direct form is about 2^s u relative to exp(A). So the direct form
    /// wins only where everything has decayed.
    pub(crate) fn exponential(&self) -> DMatrix<f64> {
        let growth = invertible_power_of_two(i32::try_from(self.squarings).unwrap_or(1000));
        if growth * norm_1(&self.direct) < norm_1(&self.minus_identity) {
            return self.direct.clone();
        }
        let mut result = self.minus_identity.clone();
        for i in 0..result.nrows() {
            result[(i, i)] += 1.0;
        }
        result
    }
}

pub(crate) fn exponential_parts(a: &DMatrix<f64>) -> Result<Exponential, LtiError> {
    // Sums of the largest entries would overflow: some squarings are taken off at once.
    const FAR_FROM_OVERFLOW: i32 = 900;
    const AT_ONCE: usize = 200;
    let n = a.nrows();
    let at_once = if exponent(a.amax()) > FAR_FROM_OVERFLOW { AT_ONCE } else { 0 };
    let (balanced, diagonal) = balance_similarity(&halve(a, at_once));
    let (degree, further) = choose_degree(&balanced);
    let scaled = halve(&balanced, further);
    let squarings = at_once + further;
    let mut minus_identity = pade_minus_identity(&scaled, degree)
        .ok_or(LtiError::Overflow { operation: "the matrix exponential" })?;
    let mut direct = &minus_identity + DMatrix::identity(n, n);
    for _ in 0..squarings {
        minus_identity = &minus_identity * 2.0 + &minus_identity * &minus_identity;
        direct = &direct * &direct;
    }
    for matrix in [&mut minus_identity, &mut direct] {
        for j in 0..n {
            for i in 0..n {
                matrix[(i, j)] *= diagonal[i] / diagonal[j];
            }
        }
    }
    if minus_identity.iter().chain(direct.iter()).all(|x| x.is_finite()) {
        Ok(Exponential { minus_identity, direct, squarings })
    } else {
        Err(LtiError::Overflow { operation: "the matrix exponential" })
    }
}

/// A / 2^squarings, in steps that stay in range.
fn halve(a: &DMatrix<f64>, squarings: usize) -> DMatrix<f64> {
    let mut scaled = a.clone();
    let mut left = squarings;
    while left > 0 {
        let step = left.min(500);
        scaled *= invertible_power_of_two(-i32::try_from(step).unwrap_or(500));
        left -= step;
    }
    scaled
}

/// The degree of the Pade approximant and the number of squarings, from norms of powers.
fn choose_degree(a: &DMatrix<f64>) -> (usize, usize) {
    let norm = norm_1(a);
    if norm == 0.0 {
        return (3, 0);
    }
    // Powers of A / 2^e stay in range; the roots of their norms are scaled back.
    let binary = exponent(norm);
    let unit = a * invertible_power_of_two(-binary);
    let back = invertible_power_of_two(binary);
    let square = &unit * &unit;
    let fourth = &square * &square;
    let sixth = &fourth * &square;
    let root = |matrix: &DMatrix<f64>, k: f64| back * norm_1(matrix).powf(1.0 / k);
    let d4 = root(&fourth, 4.0);
    let d6 = root(&sixth, 6.0);
    let eta1 = d4.max(d6);
    let d8 = root(&(&fourth * &fourth), 8.0);
    let eta3 = d6.max(d8);
    for (degree, theta) in THETA {
        let eta = match degree {
            3 | 5 => eta1,
            7 | 9 => eta3,
            _ => continue,
        };
        if eta <= theta && extra_squarings(a, degree) == 0 {
            return (degree, 0);
        }
    }
    let d10 = root(&(&fourth * &sixth), 10.0);
    let eta5 = eta3.min(d8.max(d10));
    let (degree, theta) = THETA[4];
    let mut squarings = ceil_log2(eta5 / theta);
    squarings += extra_squarings(&halve(a, squarings), degree);
    (degree, squarings)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to 0..=2200 before the cast"
)]
fn ceil_log2(ratio: f64) -> usize {
    if ratio > 1.0 { ratio.log2().ceil().clamp(0.0, 2200.0) as usize } else { 0 }
}

/// Squarings needed beyond the norms of powers, where |A|^(2m+1) is much larger than they say
/// (the second condition of Al-Mohy & Higham 2009).
fn extra_squarings(a: &DMatrix<f64>, degree: usize) -> usize {
    let norm = norm_1(a);
    if norm == 0.0 {
        return 0;
    }
    // 1 / |c_2m+1| = binomial(2m, m) (2m + 1)!
    let mut reciprocal = 1.0;
    for k in 1..=degree {
        let (k, m) = (k as f64, degree as f64);
        reciprocal *= (m + k) / k;
    }
    for k in 1..=2 * degree + 1 {
        let k = k as f64;
        reciprocal *= k;
    }
    // || |A|^(2m+1) ||_1 / ||A||_1 with |A| scaled to norm one: the power of the scale comes back as a logarithm.
    let unit = a.map(|x| x.abs() / norm);
    let mut row = nalgebra::RowDVector::from_element(a.nrows(), 1.0);
    for _ in 0..2 * degree + 1 {
        row = &row * &unit;
    }
    let power = 2.0 * degree as f64;
    let log_alpha = row.amax().log2() + power * norm.log2() - f64::log2(reciprocal);
    ceil_log2_of_log((log_alpha + 53.0) / power)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to 0..=2200 before the cast"
)]
fn ceil_log2_of_log(log: f64) -> usize {
    log.ceil().clamp(0.0, 2200.0) as usize
}

/// r_m(A) - I = 2 (V - U)^-1 U with U the odd and V the even part of the numerator of the Pade approximant.
fn pade_minus_identity(a: &DMatrix<f64>, degree: usize) -> Option<DMatrix<f64>> {
    let n = a.nrows();
    let coefficients = pade_coefficients(degree);
    let square = a * a;
    // Horner in A^2 for both parts; the degree is small and so are the matrices.
    let mut even = DMatrix::zeros(n, n);
    let mut odd = DMatrix::zeros(n, n);
    for k in (0..=degree).rev().step_by(2) {
        odd = if k == degree { odd } else { &odd * &square };
        add_to_diagonal(&mut odd, coefficients[k]);
        even = if k == degree { even } else { &even * &square };
        add_to_diagonal(&mut even, coefficients[k - 1]);
    }
    let odd = a * odd;
    (&even - &odd).lu().solve(&(odd * 2.0))
}

fn add_to_diagonal(matrix: &mut DMatrix<f64>, value: f64) {
    for i in 0..matrix.nrows() {
        matrix[(i, i)] += value;
    }
}

/// Coefficients of the numerator of the diagonal Pade approximant of exp, ascending, the first being 1:
/// c_k = m! (2m - k)! / ((2m)! k! (m - k)!).
fn pade_coefficients(degree: usize) -> Vec<f64> {
    let mut coefficients = vec![1.0];
    for k in 1..=degree {
        let ratio = (degree + 1 - k) as f64 / ((2 * degree + 1 - k) as f64 * k as f64);
        coefficients.push(coefficients[k - 1] * ratio);
    }
    coefficients
}

#[cfg(test)]
mod tests;
