//! The chi-squared distribution's upper tail.

use statrs::function::gamma::checked_gamma_ur;

/// The probability that a chi-squared variable with so many degrees of freedom exceeds `x`: Q(dof/2, x/2). Where there is nothing to test it is 1.
pub(crate) fn chi_squared_survival(x: f64, degrees_of_freedom: f64) -> f64 {
    if x <= 0.0 || degrees_of_freedom <= 0.0 || x.is_nan() || degrees_of_freedom.is_nan() {
        return 1.0;
    }
    if x.is_infinite() {
        return 0.0;
    }
    checked_gamma_ur(0.5 * degrees_of_freedom, 0.5 * x).map_or(1.0, |tail| tail.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests;
