//! The composite noncausal FIR/IIR model: its coefficients and its frequency response.

use nalgebra::Complex;

use crate::{FitError, Structure};

/// A composite noncausal FIR/IIR (CFI) model of a transmissibility.
///
/// ```text
/// T(q) = 1/D(q) * sum over i = -d .. r of h_i q^-i        D(q) y_o(k) = sum over i of h_i y_i(k - i)
/// ```
///
/// A positive index of h looks into the past, a negative one into the future. All coefficients are finite.
///
/// Source: paper eq. (40).
///
/// # Example
///
/// A backward difference, `y_o(k) = y_i(k) - y_i(k-1)`:
///
/// ```
/// use cfi_ident::{CfiModel, ConstantTerm, Orders, Structure};
///
/// let structure = Structure::new(Orders::new(0, 1, 0)?, ConstantTerm::Omitted);
/// let difference = CfiModel::new(structure, &[], &[1.0, -1.0])?;
/// assert_eq!(difference.denominator(), [1.0]);
/// assert_eq!(difference.causal(), [1.0, -1.0]);
/// assert_eq!(difference.markov_parameter(1), -1.0);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CfiModel {
    structure: Structure,
    /// Ascending, c_0 .. c_(l-1), 1.
    denominator: Vec<f64>,
    /// h_0, h_1, .. h_r.
    causal: Vec<f64>,
    /// h_-1, h_-2, .. h_-d: outwards from zero.
    anticausal: Vec<f64>,
}

impl CfiModel {
    /// A model from its unknown coefficients.
    ///
    /// - `denominator`: c_1 .. c_(l-1), or c_0 .. c_(l-1) with the constant term; without the leading 1.
    /// - `markov`: h_-d .. h_r, from the farthest future to the farthest past.
    ///
    /// # Errors
    ///
    /// [`FitError::CoefficientCount`] if the structure asks for other lengths, [`FitError::BadValue`] for a coefficient that
    /// is not finite.
    pub fn new(
        structure: Structure,
        denominator: &[f64],
        markov: &[f64],
    ) -> Result<Self, FitError> {
        let count = |what, found, needed| {
            if found == needed {
                Ok(())
            } else {
                Err(FitError::CoefficientCount { what, found, needed })
            }
        };
        count("denominator coefficients", denominator.len(), structure.denominator_count())?;
        count("Markov parameters", markov.len(), structure.markov_count())?;
        if let Some(value) = denominator.iter().chain(markov).find(|x| !x.is_finite()) {
            return Err(FitError::BadValue {
                what: "a model coefficient",
                value: *value,
                needed: "finite",
            });
        }
        let orders = structure.orders;
        let mut ascending = vec![0.0; orders.iir() - denominator.len()];
        ascending.extend_from_slice(denominator);
        ascending.push(1.0);
        let (future, past) = markov.split_at(orders.anticausal());
        let anticausal = future.iter().rev().copied().collect();
        Ok(Self { structure, denominator: ascending, causal: past.to_vec(), anticausal })
    }

    /// A model from all its parameters in the order of [`Structure::parameters`].
    ///
    /// # Errors
    ///
    /// As [`CfiModel::new`].
    pub fn from_theta(structure: Structure, theta: &[f64]) -> Result<Self, FitError> {
        if theta.len() != structure.parameter_count() {
            let (found, needed) = (theta.len(), structure.parameter_count());
            return Err(FitError::CoefficientCount { what: "parameters", found, needed });
        }
        let (denominator, markov) = theta.split_at(structure.denominator_count());
        Self::new(structure, denominator, markov)
    }

    /// Orders and form of D(q).
    pub fn structure(&self) -> Structure {
        self.structure
    }

    /// Coefficients of D(q) in ascending powers of q, with the leading 1: `[c_0, c_1, .., c_(l-1), 1]`, l + 1 of them.
    ///
    /// As the paper prints it there is no constant term, c_0 = 0, and l - 1 coefficients are unknown:
    ///
    /// ```text
    /// D(q) = q^l + sum over i = 1 .. l-1 of c_i q^i
    /// ```
    ///
    /// Source: paper eq. (35). Its text says `c_1, .., c_l`; the sum ends at l - 1.
    pub fn denominator(&self) -> Vec<f64> {
        self.denominator.clone()
    }

    /// `h_i`, the coefficient of q^-i in the FIR factor; 0 beyond the truncation.
    ///
    /// ```text
    /// T_(l,r,d)(q) = sum over i = -d .. r of h_i q^-i
    /// ```
    ///
    /// Source: paper eq. (41). The paper uses one symbol for this factor and for the whole model (40).
    pub fn markov_parameter(&self, index: isize) -> f64 {
        let side = if index < 0 { &self.anticausal } else { &self.causal };
        let position = if index < 0 { index.unsigned_abs() - 1 } else { index.unsigned_abs() };
        side.get(position).copied().unwrap_or(0.0)
    }

    /// `h_0, h_1, .. h_r`: how the past of the pseudo input acts.
    pub fn causal(&self) -> &[f64] {
        &self.causal
    }

    /// `h_-1, h_-2, .. h_-d`: how the future of the pseudo input acts, the nearest first.
    pub fn anticausal(&self) -> &[f64] {
        &self.anticausal
    }

    /// `h_-d, .. h_r`, from the farthest future to the farthest past.
    pub fn markov_parameters(&self) -> Vec<f64> {
        self.anticausal.iter().rev().chain(&self.causal).copied().collect()
    }

    /// All parameters in one vector, `[c h]`, in the order of [`Structure::parameters`].
    ///
    /// Source: paper eq. (42). Without the constant term it has l + r + d elements.
    pub fn theta(&self) -> Vec<f64> {
        self.unknown_denominator().iter().copied().chain(self.markov_parameters()).collect()
    }

    /// c_1 .. c_(l-1), or c_0 .. c_(l-1) with the constant term.
    pub(crate) fn unknown_denominator(&self) -> &[f64] {
        let degree = self.structure.orders.iir();
        &self.denominator[degree - self.structure.denominator_count()..degree]
    }

    /// The model's value at a point of the complex plane, for example `exp(j w T_s)`.
    ///
    /// The result is infinite or NaN at a root of D, and at 0.
    ///
    /// # Example
    ///
    /// ```
    /// # use cfi_ident::{CfiModel, ConstantTerm, Orders, Structure};
    /// use nalgebra::Complex;
    ///
    /// // T(q) = q / (q - 1/2): h_-1 = 1, h_0 = 0.
    /// let structure = Structure::new(Orders::new(1, 0, 1)?, ConstantTerm::Included);
    /// let model = CfiModel::new(structure, &[-0.5], &[1.0, 0.0])?;
    /// assert_eq!(model.response(Complex::new(-1.0, 0.0)), Complex::new(2.0 / 3.0, 0.0));
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn response(&self, z: Complex<f64>) -> Complex<f64> {
        let horner = |coefficients: &mut dyn Iterator<Item = &f64>, x: Complex<f64>| {
            coefficients.fold(Complex::new(0.0, 0.0), |sum, c| sum * x + c)
        };
        let past = horner(&mut self.causal.iter().rev(), z.inv());
        let future = horner(&mut self.anticausal.iter().rev(), z) * z;
        (past + future) / horner(&mut self.denominator.iter().rev(), z)
    }
}

#[cfg(test)]
mod tests;
