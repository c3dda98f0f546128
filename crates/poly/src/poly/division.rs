//! Division, greatest common divisors, and what takes their place without a field.

use crate::{Field, Poly, PolyError, Ring};

impl<T: Ring> Poly<T> {
    /// Quotient and remainder without division: `l^k p = q d + r` with `deg r < deg d`,
    /// `l` the leading coefficient of `d` and `k = max(deg p - deg d + 1, 0)`.
    ///
    /// Returns `(q, r)`. For a monic divisor this is ordinary division.
    ///
    /// # Errors
    /// [`PolyError::DivisionByZero`] if `d` is zero.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::from_descending(&[1, 0, 0, 1]);
    /// let d = Poly::from_descending(&[2, 1]);
    /// let (q, r) = p.pseudo_div_rem(&d)?;
    /// assert_eq!((q.descending(), r.descending()), (vec![4, -2, 1], vec![7]));
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn pseudo_div_rem(&self, divisor: &Self) -> Result<(Self, Self), PolyError> {
        let leading = divisor.leading().ok_or(PolyError::DivisionByZero)?;
        let m = divisor.coefficients.len() - 1;
        if self.coefficients.len() <= m {
            return Ok((Self::zero(), self.clone()));
        }
        let steps = self.coefficients.len() - m;
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![T::zero(); steps];
        for step in (0..steps).rev() {
            let top = rest[step + m].clone();
            for q in &mut quotient {
                *q = q.clone() * leading.clone();
            }
            quotient[step] = top.clone();
            for (k, r) in rest.iter_mut().enumerate() {
                let scaled = r.clone() * leading.clone();
                *r = match k.checked_sub(step) {
                    Some(i) if i <= m => scaled - top.clone() * divisor.coefficients[i].clone(),
                    _ => scaled,
                };
            }
            rest.pop();
        }
        Ok((Self::new(quotient), Self::new(rest)))
    }
}

impl<T: Field> Poly<T> {
    /// Quotient and remainder: `p = q d + r` with `deg r < deg d`.
    ///
    /// Over `f64` and `Complex<f64>` the remainder is rounded and almost never exactly zero.
    ///
    /// # Errors
    /// [`PolyError::DivisionByZero`] if `d` is zero.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::from_descending(&[1.0, 3.0, -22.0, 39.0, -21.0]);
    /// let (q, r) = p.div_rem(&Poly::from_descending(&[1.0, 7.0]))?;
    /// assert_eq!(q.descending(), [1.0, -4.0, 6.0, -3.0]);
    /// assert!(r.is_zero());
    /// # Ok::<(), poly::PolyError>(())
    /// ```
    pub fn div_rem(&self, divisor: &Self) -> Result<(Self, Self), PolyError> {
        let leading = divisor.leading().ok_or(PolyError::DivisionByZero)?;
        let m = divisor.coefficients.len() - 1;
        if self.coefficients.len() <= m {
            return Ok((Self::zero(), self.clone()));
        }
        let steps = self.coefficients.len() - m;
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![T::zero(); steps];
        for step in (0..steps).rev() {
            let factor = rest[step + m].clone() / leading.clone();
            for (r, d) in rest[step..step + m].iter_mut().zip(&divisor.coefficients) {
                *r = r.clone() - factor.clone() * d.clone();
            }
            rest.pop();
            quotient[step] = factor;
        }
        Ok((Self::new(quotient), Self::new(rest)))
    }

    /// The polynomial divided by its leading coefficient; zero stays zero.
    pub fn monic(&self) -> Self {
        let Some(leading) = self.leading().cloned() else { return Self::zero() };
        let mut coefficients: Vec<T> =
            self.coefficients.iter().map(|c| c.clone() / leading.clone()).collect();
        if let Some(last) = coefficients.last_mut() {
            *last = T::one();
        }
        Self::new(coefficients)
    }

    /// The monic greatest common divisor, by Euclid's algorithm; `gcd(0, 0) = 0`.
    ///
    /// Meant for exact fields. Over floating-point numbers rounding leaves a remainder and the answer is
    /// nearly always 1: see [`mroots()`](crate::mroots()) for multiple roots and
    /// [`Rational::cancel`](crate::Rational::cancel) for common ones.
    ///
    /// # Example
    /// ```
    /// use num_rational::Ratio;
    /// use poly::Poly;
    ///
    /// let p = |roots: &[i64]| Poly::from_roots(&roots.iter().map(|&r| Ratio::from(r)).collect::<Vec<_>>());
    /// assert_eq!(p(&[1, 1, 2, 5]).gcd(&p(&[1, 1, 5, 7])), p(&[1, 1, 5]));
    /// ```
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.monic(), other.monic());
        while let Ok((_, remainder)) = a.div_rem(&b) {
            a = b;
            b = remainder.monic();
        }
        a
    }

    /// The quotient `p / d` where `d` is known to divide `p`.
    ///
    /// # Errors
    /// [`PolyError::DivisionByZero`] if `d` is zero, [`PolyError::InexactDivision`] if a remainder is left.
    pub fn exact_div(&self, divisor: &Self) -> Result<Self, PolyError> {
        let (quotient, remainder) = self.div_rem(divisor)?;
        match remainder.degree() {
            None => Ok(quotient),
            Some(degree) => Err(PolyError::InexactDivision { degree }),
        }
    }
}
