//! A quotient of two polynomials.

#[cfg(test)]
mod tests;

use crate::{Field, Poly, PolyError, Ring};
use num_complex::Complex;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A rational function `numerator / denominator` with a nonzero denominator.
///
/// Common factors are kept as they are: they carry meaning here, and cancelling them is a decision. See
/// [`Rational::reduced`] over exact fields and [`Rational::cancel`] over `f64`. Equality compares numerators and
/// denominators as stored; [`Rational::equivalent`] compares the functions.
///
/// # Example
/// ```
/// use poly::{Poly, Rational};
///
/// // 1/(p + 1) - 1/(p + 2) = 1/((p + 1)(p + 2))
/// let part = |c: i64| Rational::new(Poly::constant(1), Poly::new(vec![c, 1]));
/// let difference = part(1)? - part(2)?;
/// assert_eq!(difference.numerator().descending(), [1]);
/// assert_eq!(difference.denominator().descending(), [1, 3, 2]);
/// # Ok::<(), poly::PolyError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Rational<T> {
    numerator: Poly<T>,
    denominator: Poly<T>,
}

impl<T: Ring> Rational<T> {
    /// The quotient of two polynomials.
    ///
    /// # Errors
    /// [`PolyError::ZeroDenominator`].
    pub fn new(numerator: Poly<T>, denominator: Poly<T>) -> Result<Self, PolyError> {
        if denominator.is_zero() {
            return Err(PolyError::ZeroDenominator);
        }
        Ok(Self { numerator, denominator })
    }

    /// The polynomial `p` as a rational function.
    pub fn from_poly(p: Poly<T>) -> Self {
        Self { numerator: p, denominator: Poly::one() }
    }

    /// The numerator.
    pub fn numerator(&self) -> &Poly<T> {
        &self.numerator
    }

    /// The denominator; never zero.
    pub fn denominator(&self) -> &Poly<T> {
        &self.denominator
    }

    /// Whether this is the zero function.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Degree of the denominator minus degree of the numerator; `None` for the zero function.
    ///
    /// Not negative for a proper function, positive for a strictly proper one.
    pub fn relative_degree(&self) -> Option<isize> {
        let signed = |p: &Poly<T>| p.degree().and_then(|n| isize::try_from(n).ok());
        Some(signed(&self.denominator)? - signed(&self.numerator)?)
    }

    /// Whether both are the same function: the cross products are equal.
    pub fn equivalent(&self, other: &Self) -> bool {
        &self.numerator * &other.denominator == &other.numerator * &self.denominator
    }

    /// The rational function with `f` applied to each coefficient.
    ///
    /// # Errors
    /// [`PolyError::ZeroDenominator`] if every coefficient of the denominator becomes zero.
    pub fn map<U: Ring>(&self, mut f: impl FnMut(&T) -> U) -> Result<Rational<U>, PolyError> {
        Rational::new(self.numerator.map(&mut f), self.denominator.map(&mut f))
    }

    /// The sum; a common denominator is kept, others are multiplied.
    ///
    /// # Errors
    /// [`PolyError::ZeroDenominator`] if the product of the denominators vanishes: by underflow, or in a ring with zero
    /// divisors.
    pub fn checked_add(&self, other: &Self) -> Result<Self, PolyError> {
        if self.denominator == other.denominator {
            return Self::new(&self.numerator + &other.numerator, self.denominator.clone());
        }
        Self::new(
            &self.numerator * &other.denominator + &other.numerator * &self.denominator,
            &self.denominator * &other.denominator,
        )
    }

    /// The difference; a common denominator is kept, others are multiplied.
    ///
    /// # Errors
    /// As [`Rational::checked_add`].
    pub fn checked_sub(&self, other: &Self) -> Result<Self, PolyError> {
        self.checked_add(&-other)
    }

    /// The product.
    ///
    /// # Errors
    /// As [`Rational::checked_add`].
    pub fn checked_mul(&self, other: &Self) -> Result<Self, PolyError> {
        Self::new(&self.numerator * &other.numerator, &self.denominator * &other.denominator)
    }

    /// The quotient.
    ///
    /// # Errors
    /// [`PolyError::DivisionByZero`] if `other` is zero, else as [`Rational::checked_add`].
    pub fn checked_div(&self, other: &Self) -> Result<Self, PolyError> {
        self.checked_mul(&other.recip()?)
    }

    /// The reciprocal.
    ///
    /// # Errors
    /// [`PolyError::DivisionByZero`] if this is zero.
    pub fn recip(&self) -> Result<Self, PolyError> {
        if self.is_zero() {
            return Err(PolyError::DivisionByZero);
        }
        Ok(Self { numerator: self.denominator.clone(), denominator: self.numerator.clone() })
    }
}

impl<T: Field> Rational<T> {
    /// The value at `x`; `None` where the denominator is exactly zero.
    pub fn eval(&self, x: &T) -> Option<T> {
        let denominator = self.denominator.eval(x);
        if denominator.is_zero() { None } else { Some(self.numerator.eval(x) / denominator) }
    }

    /// The same function in lowest terms with a monic denominator. Meant for exact fields.
    ///
    /// # Example
    /// ```
    /// use num_rational::Ratio;
    /// use poly::{Poly, Rational};
    ///
    /// let p = |roots: &[i64]| Poly::from_roots(&roots.iter().map(|&r| Ratio::from(r)).collect::<Vec<_>>());
    /// let r = Rational::new(p(&[1, 2, 3]), p(&[2, 3, 4]))?.reduced();
    /// assert_eq!((r.numerator(), r.denominator()), (&p(&[1]), &p(&[4])));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn reduced(&self) -> Self {
        let common = self.numerator.gcd(&self.denominator);
        let divided = |p: &Poly<T>| p.div_rem(&common).map_or_else(|_| p.clone(), |(q, _)| q);
        let (numerator, denominator) = (divided(&self.numerator), divided(&self.denominator));
        match denominator.leading().cloned() {
            Some(leading) => {
                let factor = leading.inv();
                Self { numerator: numerator.scale(&factor), denominator: denominator.monic() }
            }
            // Inexact arithmetic only: an underflow took the whole denominator.
            None => self.clone(),
        }
    }
}

impl Rational<f64> {
    /// The value at a complex number; infinite or NaN at a pole.
    pub fn eval_complex(&self, x: Complex<f64>) -> Complex<f64> {
        self.numerator.eval_complex(x) / self.denominator.eval_complex(x)
    }
}

const VANISHED: &str =
    "the product of the denominators vanished; checked_add and its like return an error instead";

macro_rules! binary {
    ($Trait:ident, $method:ident, $checked:ident, $message:expr) => {
        impl<T: Ring> $Trait<&Rational<T>> for &Rational<T> {
            type Output = Rational<T>;
            /// # Panics
            /// If the product of the denominators vanishes, by underflow or in a ring with zero divisors, and on
            /// division by zero. The `checked_` methods return an error instead.
            fn $method(self, other: &Rational<T>) -> Rational<T> {
                match self.$checked(other) {
                    Ok(result) => result,
                    Err(_) => panic!("{}", $message),
                }
            }
        }
        impl<T: Ring> $Trait<Rational<T>> for Rational<T> {
            type Output = Rational<T>;
            /// # Panics
            /// As for references.
            fn $method(self, other: Rational<T>) -> Rational<T> {
                $Trait::$method(&self, &other)
            }
        }
    };
}

binary!(Add, add, checked_add, VANISHED);
binary!(Sub, sub, checked_sub, VANISHED);
binary!(Mul, mul, checked_mul, VANISHED);
binary!(Div, div, checked_div, "division by zero; checked_div returns an error instead");

impl<T: Ring> Neg for &Rational<T> {
    type Output = Rational<T>;
    fn neg(self) -> Rational<T> {
        Rational { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }
}

impl<T: Ring> Neg for Rational<T> {
    type Output = Rational<T>;
    fn neg(self) -> Rational<T> {
        -&self
    }
}
