//! The model of a known transmissibility: poles split off into D(q), the rest expanded in a Laurent series and truncated.

use nalgebra::{Complex, DMatrix, DVector};

use crate::{CfiModel, ConstantTerm, FitError, Structure};

/// A transmissibility by its zeros and poles.
///
/// ```text
/// T(q) = gain (q - z_1) .. (q - z_m) / ((q - p_1) .. (q - p_n))
/// ```
///
/// It may be unstable and noncausal, and m may exceed n. Zeros and poles are closed under conjugation.
///
/// Source: paper eq. (34), where the gain is one.
#[derive(Debug, Clone, PartialEq)]
pub struct ZerosAndPoles {
    zeros: Vec<Complex<f64>>,
    /// By descending modulus; of a pair the one with positive imaginary part first.
    poles: Vec<Complex<f64>>,
    gain: f64,
}

impl ZerosAndPoles {
    /// Checks zeros, poles and gain. Both members of a complex pair are listed, exactly conjugate.
    ///
    /// # Errors
    ///
    /// [`FitError::BadValue`] for what is not finite, [`FitError::Unpaired`] for a complex one without its conjugate.
    pub fn new(
        zeros: &[Complex<f64>],
        poles: &[Complex<f64>],
        gain: f64,
    ) -> Result<Self, FitError> {
        let numbers = zeros.iter().chain(poles).flat_map(|z| [z.re, z.im]).chain([gain]);
        for value in numbers {
            if !value.is_finite() {
                return Err(FitError::BadValue {
                    what: "a zero, a pole or the gain",
                    value,
                    needed: "finite",
                });
            }
        }
        let zeros = paired("the zero", zeros)?;
        let poles = paired("the pole", poles)?;
        Ok(Self { zeros, poles, gain })
    }

    /// Splits the `iir` poles of largest modulus off into a monic polynomial D.
    ///
    /// ```text
    /// T(q) = 1/D(q) * T_l(q),     D(q) = (q - p_(n-l+1)) .. (q - p_n)
    /// ```
    ///
    /// Source: paper eq. (36). There D holds the poles on and outside the unit circle; here any number may be split off, and poles
    /// outside that stay in T_l give it an anticausal part.
    ///
    /// # Errors
    ///
    /// [`FitError::TooFewPoles`], [`FitError::Unpaired`] if a complex pair would be torn apart.
    pub fn split(&self, iir: usize) -> Result<Split, FitError> {
        if iir > self.poles.len() {
            return Err(FitError::TooFewPoles { found: self.poles.len(), needed: iir });
        }
        let (taken, left) = self.poles.split_at(iir);
        let torn = taken.last().filter(|last| last.im > 0.0);
        if let Some(value) = torn {
            return Err(FitError::Unpaired { what: "the pole", value: *value });
        }
        let remaining = Self { zeros: self.zeros.clone(), poles: left.to_vec(), gain: self.gain };
        Ok(Split { denominator: polynomial(taken), remaining })
    }

    /// The CFI model of this transmissibility: the exact expansion, cut off at h_-d and h_r.
    ///
    /// ```text
    /// T(z) = 1/D(z) * sum over all i of h_i z^-i
    /// ```
    ///
    /// Without the constant term, D is q times the l - 1 poles of largest modulus, and the series is multiplied by q as well.
    ///
    /// Source: paper eq. (39).
    ///
    /// # Errors
    ///
    /// As [`ZerosAndPoles::split`] and [`ZerosAndPoles::laurent`].
    ///
    /// # Example
    ///
    /// T(q) = q / (q - 2) with its only pole in D, as printed (l = 2 fits one pole):
    ///
    /// ```
    /// use cfi_ident::{ConstantTerm, Orders, Structure, ZerosAndPoles};
    /// use nalgebra::Complex;
    ///
    /// let t = ZerosAndPoles::new(&[Complex::new(0.0, 0.0)], &[Complex::new(2.0, 0.0)], 1.0)?;
    /// let model = t.cfi(Structure::new(Orders::new(2, 1, 2)?, ConstantTerm::Omitted))?;
    /// assert_eq!(model.denominator(), [0.0, -2.0, 1.0]);
    /// assert_eq!(model.markov_parameters(), [1.0, 0.0, 0.0, 0.0]);
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn cfi(&self, structure: Structure) -> Result<CfiModel, FitError> {
        let (l, r, d) =
            (structure.orders.iir(), structure.orders.causal(), structure.orders.anticausal());
        let shifted = structure.constant_term == ConstantTerm::Omitted && l > 0;
        let mut split = self.split(if shifted { l - 1 } else { l })?;
        if shifted {
            split.denominator.insert(0, 0.0);
            split.remaining.zeros.push(Complex::new(0.0, 0.0));
        }
        let markov = split.remaining.laurent(r, d)?;
        let unknown = structure.denominator_count();
        CfiModel::new(structure, &split.denominator[l - unknown..l], &markov)
    }

    /// Laurent coefficients `h_-future, .. h_past` in the annulus that contains the unit circle.
    ///
    /// ```text
    /// T_l(z) = sum over all i of h_i z^-i
    /// ```
    ///
    /// Poles inside the unit circle give the part with i >= 1, poles outside the part with i <= 0, and the polynomial part of a
    /// numerator of higher degree adds to the latter.
    ///
    /// Source: paper eq. (38).
    ///
    /// # Errors
    ///
    /// [`FitError::BadValue`] if a pole lies on the unit circle (within 1e-12), or if two poles inside and outside are so close that the
    /// expansion cannot be computed; [`FitError::Overflow`].
    ///
    /// # Example
    ///
    /// 1 / ((z - 1/2) (z - 2)) = (2/3) / (z - 2) - (2/3) / (z - 1/2):
    ///
    /// ```
    /// use cfi_ident::ZerosAndPoles;
    /// use nalgebra::Complex;
    ///
    /// let t = ZerosAndPoles::new(&[], &[Complex::new(0.5, 0.0), Complex::new(2.0, 0.0)], 1.0)?;
    /// let h = t.laurent(2, 1)?;
    /// for (h, expected) in h.iter().zip([-1.0 / 6.0, -1.0 / 3.0, -2.0 / 3.0, -1.0 / 3.0]) {
    ///     assert!((h - expected).abs() < 1e-15);
    /// }
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn laurent(&self, past: usize, future: usize) -> Result<Vec<f64>, FitError> {
        if let Some(pole) = self.poles.iter().find(|p| (p.norm() - 1.0).abs() < ON_THE_CIRCLE) {
            let needed = "off the unit circle: a larger l takes the pole into D";
            return Err(FitError::BadValue {
                what: "the modulus of a pole left to the FIR factor",
                value: pole.norm(),
                needed,
            });
        }
        let inside: Vec<_> = self.poles.iter().filter(|p| p.norm() < 1.0).copied().collect();
        let outside: Vec<_> = self.poles.iter().filter(|p| p.norm() > 1.0).copied().collect();
        let numerator: Vec<f64> = polynomial(&self.zeros).iter().map(|c| c * self.gain).collect();
        let (inside, outside) = (polynomial(&inside), polynomial(&outside));
        let parts = partial_fractions(&numerator, &inside, &outside)?;
        let mut future_side = ascending_series(&parts.outside, &outside, future + 1);
        future_side.iter_mut().zip(&parts.polynomial).for_each(|(h, q)| *h += q);
        // In w = 1/z the inside part is a ratio of reversed polynomials, delayed by one sample.
        let reversed = |p: &[f64]| p.iter().rev().copied().collect::<Vec<f64>>();
        let past_side = ascending_series(&reversed(&parts.inside), &reversed(&inside), past);
        let markov: Vec<f64> = future_side.iter().rev().chain(&past_side).copied().collect();
        if markov.iter().all(|h| h.is_finite()) {
            Ok(markov)
        } else {
            Err(FitError::Overflow { what: "a Laurent coefficient" })
        }
    }

    /// The value at a point of the complex plane.
    pub fn response(&self, z: Complex<f64>) -> Complex<f64> {
        let product = |roots: &[Complex<f64>]| {
            roots.iter().fold(Complex::new(1.0, 0.0), |p, root| p * (z - root))
        };
        product(&self.zeros) / product(&self.poles) * self.gain
    }

    /// The zeros.
    pub fn zeros(&self) -> &[Complex<f64>] {
        &self.zeros
    }

    /// The poles, by descending modulus.
    pub fn poles(&self) -> &[Complex<f64>] {
        &self.poles
    }

    /// The factor in front.
    pub fn gain(&self) -> f64 {
        self.gain
    }
}

/// A transmissibility with some of its poles split off.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Split {
    /// D(q), monic, ascending powers of q, l + 1 coefficients.
    pub denominator: Vec<f64>,
    /// What the FIR factor has to approximate: all zeros and the other poles.
    ///
    /// ```text
    /// T_l(q) = gain (q - z_1) .. (q - z_m) / ((q - p_1) .. (q - p_(n-l)))
    /// ```
    ///
    /// Source: paper eq. (37).
    pub remaining: ZerosAndPoles,
}

/// Poles this close to the unit circle have no usable annulus: the series would need 1e12 terms to decay.
const ON_THE_CIRCLE: f64 = 1e-12;

/// Sorts by descending modulus with conjugate pairs together, positive imaginary part first.
fn paired(what: &'static str, roots: &[Complex<f64>]) -> Result<Vec<Complex<f64>>, FitError> {
    let mut upper: Vec<_> = roots.iter().filter(|z| z.im >= 0.0).copied().collect();
    let mut lower: Vec<_> = roots.iter().filter(|z| z.im < 0.0).copied().collect();
    upper.sort_by(|a, b| {
        b.norm().total_cmp(&a.norm()).then(b.re.total_cmp(&a.re)).then(b.im.total_cmp(&a.im))
    });
    let mut sorted = Vec::with_capacity(roots.len());
    for root in upper {
        sorted.push(root);
        if root.im > 0.0 {
            let partner = lower.iter().position(|z| *z == root.conj());
            let partner = partner.ok_or(FitError::Unpaired { what, value: root })?;
            sorted.push(lower.swap_remove(partner));
        }
    }
    match lower.first() {
        Some(value) => Err(FitError::Unpaired { what, value: *value }),
        None => Ok(sorted),
    }
}

/// Ascending real coefficients of the monic polynomial with these conjugate-closed, paired roots.
fn polynomial(roots: &[Complex<f64>]) -> Vec<f64> {
    let mut coefficients = vec![1.0];
    for root in roots.iter().filter(|z| z.im >= 0.0) {
        let factor = if root.im > 0.0 {
            vec![root.norm_sqr(), -2.0 * root.re, 1.0]
        } else {
            vec![-root.re, 1.0]
        };
        coefficients = product(&coefficients, &factor);
    }
    coefficients
}

fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut c = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            c[i + j] += x * y;
        }
    }
    c
}

struct PartialFractions {
    polynomial: Vec<f64>,
    inside: Vec<f64>,
    outside: Vec<f64>,
}

/// numerator = polynomial * inside * outside + A * outside + B * inside with deg A < deg inside, deg B < deg outside.
fn partial_fractions(
    numerator: &[f64],
    inside: &[f64],
    outside: &[f64],
) -> Result<PartialFractions, FitError> {
    let both = product(inside, outside);
    let (n_inside, n_outside) = (inside.len() - 1, outside.len() - 1);
    let n_polynomial = (numerator.len() + 1).saturating_sub(both.len());
    let size = n_polynomial + n_inside + n_outside;
    let shifted = |p: &[f64], shift: usize, row: usize| {
        row.checked_sub(shift).and_then(|i| p.get(i)).copied().unwrap_or(0.0)
    };
    let system = DMatrix::from_fn(size, size, |row, column| {
        if column < n_polynomial {
            shifted(&both, column, row)
        } else if column < n_polynomial + n_inside {
            shifted(outside, column - n_polynomial, row)
        } else {
            shifted(inside, column - n_polynomial - n_inside, row)
        }
    });
    let target = DVector::from_fn(size, |row, _| numerator.get(row).copied().unwrap_or(0.0));
    let singular = FitError::BadValue {
        what: "the determinant that separates the poles inside the unit circle from those outside",
        value: 0.0,
        needed: "nonzero",
    };
    let solution = system.lu().solve(&target).ok_or(singular)?;
    let part = |from: usize, count: usize| solution.as_slice()[from..from + count].to_vec();
    Ok(PartialFractions {
        polynomial: part(0, n_polynomial),
        inside: part(n_polynomial, n_inside),
        outside: part(n_polynomial + n_inside, n_outside),
    })
}

/// The first `count` coefficients of numerator / denominator in ascending powers; the denominator's constant term is not zero.
fn ascending_series(numerator: &[f64], denominator: &[f64], count: usize) -> Vec<f64> {
    let mut series: Vec<f64> = Vec::with_capacity(count);
    for k in 0..count {
        let known: f64 =
            denominator.iter().skip(1).zip(series.iter().rev()).map(|(p, s)| p * s).sum();
        series.push((numerator.get(k).copied().unwrap_or(0.0) - known) / denominator[0]);
    }
    series
}

#[cfg(test)]
mod tests;
