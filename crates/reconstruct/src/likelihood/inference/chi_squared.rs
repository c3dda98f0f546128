//! The chi-squared distribution's upper tail.

use std::f64::consts::TAU;

use statrs::function::erf::erfc;
use statrs::function::gamma::checked_gamma_ur;

/// The probability that a chi-squared variable with so many degrees of freedom exceeds `x`: Q(dof/2, x/2), the regularised incomplete gamma
/// function. Where there is nothing to test it is 1.
pub(crate) fn chi_squared_survival(x: f64, degrees_of_freedom: f64) -> f64 {
    if x <= 0.0 || degrees_of_freedom <= 0.0 || x.is_nan() || degrees_of_freedom.is_nan() {
        return 1.0;
    }
    if x.is_infinite() {
        return 0.0;
    }
    let (a, x) = (0.5 * degrees_of_freedom, 0.5 * x);
    let tail = around_the_mean(a, x).or_else(|| checked_gamma_ur(a, x).ok());
    tail.map_or(1.0, |tail| tail.clamp(0.0, 1.0))
}

/// Q(a, x) for large a and x close to it, where x^a exp(-x) / Gamma(a) by logarithms loses as many digits as a has.
///
/// Q = erfc(eta sqrt(a/2)) / 2 + exp(-a eta^2/2) / sqrt(2 pi a) (c_0(eta) + c_1(0) / a), eta^2/2 = x/a - 1 - ln(x/a), with the sign of x - a; what is left
/// out is below 1e-11 of it. Source: Temme, The asymptotic expansion of the incomplete gamma functions, SIAM J. Math. Anal. 10 (1979).
fn around_the_mean(a: f64, x: f64) -> Option<f64> {
    const LARGE: f64 = 1e5;
    const CLOSE: f64 = 0.03;
    let off = (x - a) / a;
    if a < LARGE || off.abs() > CLOSE {
        return None;
    }
    let half_square = off - off.ln_1p();
    let eta = (2.0 * half_square).sqrt().copysign(off);
    let c0 = -1.0 / 3.0 + eta / 12.0 - 2.0 * eta.powi(2) / 135.0 + eta.powi(3) / 864.0;
    let c1 = -1.0 / 540.0;
    let density = (-a * half_square).exp() / (TAU * a).sqrt();
    Some(0.5 * erfc(eta * (0.5 * a).sqrt()) + density * (c0 + c1 / a))
}

#[cfg(test)]
mod tests;
