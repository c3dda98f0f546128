//! The chi-squared distribution's upper tail, by the regularised incomplete gamma function.

/// The probability that a chi-squared variable with so many degrees of freedom exceeds `x`: Q(dof/2, x/2).
///
/// Series below the mean, continued fraction (modified Lentz) above it, as in Numerical Recipes 6.2; the prefactor is formed around its maximum,
/// so that it keeps its digits for millions of degrees of freedom.
pub(super) fn chi_squared_survival(x: f64, degrees_of_freedom: f64) -> f64 {
    if x <= 0.0 || degrees_of_freedom <= 0.0 || x.is_nan() || degrees_of_freedom.is_nan() {
        return 1.0;
    }
    let (a, x) = (0.5 * degrees_of_freedom, 0.5 * x);
    if x.is_infinite() {
        return 0.0;
    }
    let tail = if x < a + 1.0 {
        1.0 - prefactor(a, x) * series(a, x)
    } else {
        prefactor(a, x) * a * fraction(a, x)
    };
    tail.clamp(0.0, 1.0)
}

/// x^a exp(-x) / Gamma(a + 1).
fn prefactor(a: f64, x: f64) -> f64 {
    const LARGE: f64 = 10.0;
    if a < LARGE {
        // Gamma(a + 1) = Gamma(a + 11) / ((a + 1) .. (a + 10)).
        let product: f64 = (1..=10).map(|k| a + f64::from(k)).product();
        return prefactor(a + LARGE, x) * product / x.powf(LARGE);
    }
    // With x = a (1 + d): a (ln(1 + d) - d), without cancellation around d = 0.
    let d = (x - a) / a;
    let exponent = a * log_minus_argument(d);
    (exponent - stirling(a)).exp() / (core::f64::consts::TAU * a).sqrt()
}

/// ln(1 + d) - d.
fn log_minus_argument(d: f64) -> f64 {
    if d.abs() > 0.1 {
        return d.ln_1p() - d;
    }
    // -d^2/2 + d^3/3 - ..: 18 terms reach 1e-19.
    (2..20).rev().fold(0.0, |sum, k| {
        let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
        sum * d + sign / f64::from(k)
    }) * d
        * d
}

/// ln Gamma(a + 1) - (a + 1/2) ln a + a - ln(2 pi)/2 for a >= 10.
fn stirling(a: f64) -> f64 {
    let inverse = 1.0 / a;
    let square = inverse * inverse;
    inverse
        * (1.0 / 12.0
            - square
                * (1.0 / 360.0
                    - square
                        * (1.0 / 1260.0
                            - square
                                * (1.0 / 1680.0
                                    - square * (1.0 / 1188.0 - square * 691.0 / 360_360.0)))))
}

/// The largest number of terms: the square root of a few times 1e12 degrees of freedom.
const TERMS: usize = 10_000_000;

/// 1 + x/(a+1) + x^2/((a+1)(a+2)) + ..
fn series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum, mut next) = (1.0, 1.0, a);
    for _ in 0..TERMS {
        next += 1.0;
        term *= x / next;
        sum += term;
        if term < sum * f64::EPSILON {
            break;
        }
    }
    sum
}

/// 1/(x+1-a - 1(1-a)/(x+3-a - ..)).
fn fraction(a: f64, x: f64) -> f64 {
    const TINY: f64 = 1e-300;
    let away = |value: f64| if value.abs() < TINY { TINY } else { value };
    let mut b = x + 1.0 - a;
    let mut c = 1.0 / TINY;
    let mut d = 1.0 / away(b);
    let mut value = d;
    let mut k = 0.0;
    for _ in 0..TERMS {
        k += 1.0;
        let numerator = -k * (k - a);
        b += 2.0;
        d = 1.0 / away(numerator * d + b);
        c = away(b + numerator / c);
        let factor = d * c;
        value *= factor;
        if (factor - 1.0).abs() < f64::EPSILON {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests;
