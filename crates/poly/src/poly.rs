//! A polynomial in one variable.

mod arithmetic;
pub(crate) mod display;
mod division;
pub(crate) mod floating;
#[cfg(test)]
mod tests;

use crate::Ring;

/// A polynomial `c_0 + c_1 x + ... + c_n x^n` over a ring.
///
/// Coefficients are stored ascending, without leading exact zeros; the zero polynomial has no coefficients.
/// `+`, `-`, `*` and unary `-` work by value and by reference.
///
/// # Example
/// ```
/// use poly::Poly;
///
/// let p = Poly::new(vec![-3, 6, -4, 1]);
/// assert_eq!(p, Poly::from_descending(&[1, -4, 6, -3]));
/// assert_eq!(p.degree(), Some(3));
/// assert_eq!(p.eval(&1), 0);
/// assert_eq!((&p * &Poly::new(vec![7, 1])).descending(), [1, 3, -22, 39, -21]);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Poly<T> {
    coefficients: Vec<T>,
}

impl<T: Ring> Poly<T> {
    /// The polynomial with the given coefficients, constant term first.
    pub fn new(ascending: Vec<T>) -> Self {
        let mut coefficients = ascending;
        while coefficients.last().is_some_and(T::is_zero) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The polynomial with the given coefficients, highest degree first, as they are printed.
    pub fn from_descending(descending: &[T]) -> Self {
        Self::new(descending.iter().rev().cloned().collect())
    }

    /// The zero polynomial.
    pub fn zero() -> Self {
        Self { coefficients: Vec::new() }
    }

    /// The constant polynomial 1.
    pub fn one() -> Self {
        Self::constant(T::one())
    }

    /// The constant polynomial `c`.
    pub fn constant(c: T) -> Self {
        Self::new(vec![c])
    }

    /// The monomial `c x^degree`.
    pub fn monomial(c: T, degree: usize) -> Self {
        let mut coefficients = vec![T::zero(); degree];
        coefficients.push(c);
        Self::new(coefficients)
    }

    /// The polynomial `x`.
    pub fn indeterminate() -> Self {
        Self::monomial(T::one(), 1)
    }

    /// The monic polynomial `(x - r_1) ... (x - r_n)`; 1 for an empty list.
    ///
    /// Over `f64` each factor adds a rounding error; [`Poly::real_from_roots`] rounds once.
    pub fn from_roots(roots: &[T]) -> Self {
        let mut coefficients = Vec::with_capacity(roots.len() + 1);
        coefficients.push(T::one());
        for root in roots {
            coefficients.push(T::one());
            for k in (1..coefficients.len() - 1).rev() {
                coefficients[k] =
                    coefficients[k - 1].clone() - root.clone() * coefficients[k].clone();
            }
            coefficients[0] = -(root.clone() * coefficients[0].clone());
        }
        Self::new(coefficients)
    }

    /// Coefficients, constant term first; empty for the zero polynomial.
    pub fn coefficients(&self) -> &[T] {
        &self.coefficients
    }

    /// Coefficients, highest degree first; empty for the zero polynomial.
    pub fn descending(&self) -> Vec<T> {
        self.coefficients.iter().rev().cloned().collect()
    }

    /// Coefficients, constant term first, by value.
    pub fn into_coefficients(self) -> Vec<T> {
        self.coefficients
    }

    /// The coefficient of `x^degree`; zero beyond the degree.
    pub fn coefficient(&self, degree: usize) -> T {
        self.coefficients.get(degree).cloned().unwrap_or_else(T::zero)
    }

    /// The degree; `None` for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// The coefficient of the highest degree; `None` for the zero polynomial.
    pub fn leading(&self) -> Option<&T> {
        self.coefficients.last()
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at `x`, by Horner's rule.
    pub fn eval(&self, x: &T) -> T {
        let mut value = T::zero();
        for c in self.coefficients.iter().rev() {
            value = value * x.clone() + c.clone();
        }
        value
    }

    /// The polynomial with `f` applied to each coefficient, constant term first.
    ///
    /// Coefficients that become zero at the top are trimmed.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::new(vec![1, 2, 5]).map(|&c| c as f64 / 2.0);
    /// assert_eq!(p.coefficients(), [0.5, 1.0, 2.5]);
    /// ```
    pub fn map<U: Ring>(&self, f: impl FnMut(&T) -> U) -> Poly<U> {
        Poly::new(self.coefficients.iter().map(f).collect())
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let mut factor = T::zero();
        let mut coefficients = Vec::with_capacity(self.coefficients.len());
        for c in self.coefficients.iter().skip(1) {
            factor = factor + T::one();
            coefficients.push(factor.clone() * c.clone());
        }
        Self::new(coefficients)
    }

    /// `x^n p(1/x)` with `n` the degree: the coefficients in the other order.
    ///
    /// The roots are the inverses of the nonzero roots; roots at zero are lost.
    pub fn reversed(&self) -> Self {
        Self::new(self.descending())
    }

    /// The polynomial times the constant `c`.
    pub fn scale(&self, c: &T) -> Self {
        self.map(|a| c.clone() * a.clone())
    }

    /// The polynomial times `x^degree`.
    pub fn shift(&self, degree: usize) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let mut coefficients = vec![T::zero(); degree];
        coefficients.extend_from_slice(&self.coefficients);
        Self { coefficients }
    }

    /// The polynomial to the power `exponent`, by repeated squaring; `p^0 = 1`.
    pub fn pow(&self, exponent: usize) -> Self {
        let mut result = Self::one();
        let mut base = self.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                result = &result * &base;
            }
            rest /= 2;
            if rest > 0 {
                base = &base * &base;
            }
        }
        result
    }
}
