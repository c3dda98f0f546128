//! Polynomials as text.

use crate::{Poly, Ring};
use std::fmt;

/// A polynomial with the name of its variable, for printing; made by [`Poly::display`].
#[derive(Debug, Clone, Copy)]
pub struct PolyDisplay<'a, T> {
    poly: &'a Poly<T>,
    variable: &'a str,
}

impl<T> Poly<T> {
    /// The polynomial as text, highest degree first, in the given variable.
    ///
    /// A precision is passed on to the coefficients, so `{:.3}` rounds each of them.
    ///
    /// # Example
    /// ```
    /// use poly::Poly;
    ///
    /// let p = Poly::from_descending(&[1.0, -0.5, 0.0, -2.0]);
    /// assert_eq!(p.display("q").to_string(), "q^3 - 0.5q^2 - 2");
    /// assert_eq!(format!("{:.2}", p.display("q")), "q^3 - 0.50q^2 - 2.00");
    /// ```
    pub fn display<'a>(&'a self, variable: &'a str) -> PolyDisplay<'a, T> {
        PolyDisplay { poly: self, variable }
    }
}

impl<T: Ring + fmt::Display> fmt::Display for PolyDisplay<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision();
        let text = |c: &T| match precision {
            Some(digits) => format!("{c:.digits$}"),
            None => format!("{c}"),
        };
        if self.poly.is_zero() {
            return f.write_str("0");
        }
        let mut first = true;
        for (degree, c) in self.poly.coefficients().iter().enumerate().rev() {
            if c.is_zero() {
                continue;
            }
            // A sum such as 1+2i is put in brackets, a leading minus goes to the operator.
            let (minus, magnitude) = {
                let positive = text(c);
                let compound = positive.trim_start_matches('-').contains(['+', '-', '/', ' '])
                    && !positive.contains('e');
                match (compound, positive.strip_prefix('-')) {
                    (true, _) => (false, format!("({positive})")),
                    (false, Some(rest)) => (true, rest.to_owned()),
                    (false, None) => (false, positive),
                }
            };
            f.write_str(match (first, minus) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            })?;
            first = false;
            let unit = *c == T::one() || *c == -T::one();
            if degree == 0 || !unit {
                f.write_str(&magnitude)?;
            }
            match degree {
                0 => {}
                1 => f.write_str(self.variable)?,
                _ => write!(f, "{}^{degree}", self.variable)?,
            }
        }
        Ok(())
    }
}
