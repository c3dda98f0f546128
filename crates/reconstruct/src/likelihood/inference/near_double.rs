//! Eigenvalues that the records hardly tell apart, and what they do tell of the two.
//!
//! Two eigenvalues s1, s2 that nearly coincide move with the square root of what moves the matrix: each is m +- sqrt(q) with
//!
//! ```text
//! m = (s1 + s2)/2,     q = ((s1 - s2)/2)^2
//! ```
//!
//! m and q are analytic in the matrix where the eigenvalues meet, so that first-order standard errors hold for them, and for s1 and s2 they do not: those take the slope of a square
//! root where it is far from straight. Sum and product of the two are 2 m and m^2 - q. Where q is real, the two are real above zero and a conjugate pair below.

use nalgebra::{DMatrix, DVector, Matrix2};
use num_complex::Complex;

use super::uncertainty::{ComplexEstimate, ModelBias};

/// Two eigenvalues of which the difference is hardly known.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct NearDouble {
    /// The other eigenvalue in rad/s; of a conjugate pair near the real axis the one below it.
    pub partner: Complex<f64>,
    /// Half the sum of the two, in rad/s.
    pub mean: ComplexEstimate,
    /// The square of half their difference, in (rad/s)^2: real where both are real (above zero) or conjugate (below zero).
    pub half_difference_squared: ComplexEstimate,
}

/// An eigenvalue in rad/s, and its derivatives by all entries of the matrix.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    pub(crate) value: Complex<f64>,
    pub(crate) slopes: DVector<Complex<f64>>,
}

/// Standard errors that q has to be away from zero. At four, a square root is straight enough over two of them for its slope to do.
const APART: f64 = 4.0;

/// The normal distribution holds 95 % within this many standard errors.
const NORMAL_95: f64 = 1.959_963_984_540_054;

impl Root {
    fn conjugate(&self) -> Self {
        Self { value: self.value.conj(), slopes: self.slopes.map(|slope| slope.conj()) }
    }
}

/// For each root that has one, the partner from which it is told apart worst. Of complex pairs the roots above the real axis are given.
pub(crate) fn near_doubles(
    roots: &[Option<Root>],
    covariance: &DMatrix<f64>,
    bias: ModelBias,
) -> Vec<Option<NearDouble>> {
    let is_pair = |root: &Root| root.value.im > 0.0;
    let of = |(index, root): (usize, &Option<Root>)| {
        let root = root.as_ref()?;
        let others = roots.iter().enumerate().filter(|(other, _)| *other != index);
        let mut partners: Vec<Root> = others
            .filter_map(|(_, other)| other.clone())
            // Real roots with real ones, and complex with complex.
            .filter(|other| is_pair(other) == is_pair(root))
            .collect();
        if is_pair(root) {
            partners.push(root.conjugate());
        }
        let judged = partners.iter().filter_map(|partner| judge(root, partner, covariance, bias));
        judged.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, found)| found)
    };
    roots.iter().enumerate().map(of).collect()
}

/// How many standard errors apart the two are, where those are few, and what is known of them.
fn judge(
    root: &Root,
    partner: &Root,
    covariance: &DMatrix<f64>,
    bias: ModelBias,
) -> Option<(f64, NearDouble)> {
    let half = (root.value - partner.value) * 0.5;
    let mean_slopes = (&root.slopes + &partner.slopes) * Complex::new(0.5, 0.0);
    let slopes = (&root.slopes - &partner.slopes) * half;
    let mut mean =
        ComplexEstimate::from_slopes((root.value + partner.value) * 0.5, &mean_slopes, covariance);
    let mut square = ComplexEstimate::from_slopes(half * half, &slopes, covariance);
    let shift = bias.deviation(mean.value.norm());
    // Sums and squares of conjugates are real.
    let imaginary = if mean.covariance[(1, 1)] > 0.0 { 1.0 } else { 0.0 };
    let axes = Matrix2::new(1.0, 0.0, 0.0, imaginary);
    mean.covariance += axes * (shift * shift);
    square.covariance += axes * (2.0 * half.norm() * shift).powi(2);
    let own = ComplexEstimate::from_slopes(root.value, &root.slopes, covariance);
    let size = |estimate: &ComplexEstimate| estimate.covariance.trace().max(0.0).sqrt();
    let distance = square.value.norm() / size(&square);
    // The two together are known, and better than each.
    let is_known = 2.0 * size(&mean) < mean.value.norm() && size(&mean) < size(&own);
    let found = NearDouble { partner: partner.value, mean, half_difference_squared: square };
    (is_known && distance.is_finite() && distance < APART).then_some((distance, found))
}

impl NearDouble {
    /// The variances of the real and of the imaginary part of one of the two: those of m, and the farthest that sqrt(q) is off within the 95 % region of q.
    pub(crate) fn variances(&self) -> Matrix2<f64> {
        const AROUND: u32 = 32;
        let square = &self.half_difference_squared;
        let here = square.value.sqrt();
        let ellipse = square.ellipse_95();
        // The region of one number holds 95 % within 1.96 standard errors, that of two within 2.45.
        let scale = match ellipse.minor > 0.0 {
            true => 1.0,
            false => NORMAL_95 / (-2.0 * 0.05_f64.ln()).sqrt(),
        };
        let (mut real, mut imaginary) = (0.0_f64, 0.0_f64);
        for step in 0..AROUND {
            let angle = std::f64::consts::TAU * f64::from(step) / f64::from(AROUND);
            let along = Complex::new(ellipse.major * angle.cos(), ellipse.minor * angle.sin());
            let there = square.value + along * scale * Complex::from_polar(1.0, ellipse.angle_rad);
            let root = there.sqrt();
            // The nearer of the two roots: nobody knows which is which.
            let off = if (root - here).norm() <= (root + here).norm() {
                root - here
            } else {
                root + here
            };
            real = real.max(off.re.abs());
            imaginary = imaginary.max(off.im.abs());
        }
        let of_mean = &self.mean.covariance;
        let total = |part: f64, index: usize| (part / NORMAL_95).powi(2) + of_mean[(index, index)];
        Matrix2::new(total(real, 0), 0.0, 0.0, total(imaginary, 1))
    }
}

#[cfg(test)]
mod tests;
