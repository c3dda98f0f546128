//! For the tests: exact values as rationals, the unit of the error bounds, and numbers of all scales.

use core::ops::RangeInclusive;

use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

use crate::DoubleDouble;

pub(crate) fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("tests compare finite numbers")
}

pub(crate) fn exact(x: DoubleDouble) -> BigRational {
    rational(x.high()) + rational(x.low())
}

/// Whether `found` is `expected` up to `units` squares of the unit roundoff, and up to the underflow of a few low parts.
pub(crate) fn agrees(found: DoubleDouble, expected: &BigRational, units: f64) -> bool {
    agrees_on_scale(found, expected, units, &expected.abs())
}

/// As [`agrees`], with the error relative to a given scale.
pub(crate) fn agrees_on_scale(
    found: DoubleDouble,
    expected: &BigRational,
    units: f64,
    scale: &BigRational,
) -> bool {
    let underflow = rational(4.0 * f64::from_bits(1));
    let bound = rational(units * 2f64.powi(-106)) * scale + underflow;
    is_normalised(found) && (exact(found) - expected).abs() <= bound
}

/// Whether the high part is the double nearest to the sum.
pub(crate) fn is_normalised(x: DoubleDouble) -> bool {
    x.high() + x.low() == x.high()
}

/// Either sign, scales of 1e150 and 1e-150 and all between, low parts of all sizes and zero.
pub(crate) fn any_scale() -> impl Strategy<Value = DoubleDouble> + Clone {
    scaled(-498..=498)
}

/// Numbers between 2^first and 2^(last + 1) in modulus.
pub(crate) fn scaled(
    exponents: RangeInclusive<i32>,
) -> impl Strategy<Value = DoubleDouble> + Clone {
    (any::<bool>(), 1.0..2.0_f64, exponents, -1.0..1.0_f64, 53..140_i32, 0..4_u8).prop_map(
        |(negative, mantissa, exponent, low, below, kind)| {
            let high = if negative { -mantissa } else { mantissa } * 2f64.powi(exponent);
            let low = match kind {
                0 => 0.0,
                // Sparse: far below the high part.
                1 => low * high * 2f64.powi(-below),
                _ => low * high * 2f64.powi(-53),
            };
            DoubleDouble::sum(high, low)
        },
    )
}

/// Two numbers whose sum cancels: the second is the negative of the first up to some bits, high or low.
pub(crate) fn cancelling() -> impl Strategy<Value = (DoubleDouble, DoubleDouble)> {
    (any_scale(), -8..=8_i32, -1.0..1.0_f64).prop_map(|(x, steps, low)| {
        let high = -x.high() * (1.0 + f64::from(steps) * f64::EPSILON);
        (x, DoubleDouble::sum(high, low * high * 2f64.powi(-53)))
    })
}
