//! Scaling by powers of two: exact as long as nothing underflows, and how numbers are kept inside the range of doubles.

/// The exponent e with 2^e <= |x| < 2^(e+1). Zero and subnormal numbers count as the smallest normal one, -1022; what is not
/// finite gives 1024.
///
/// # Example
///
/// ```
/// use doubled::exponent;
///
/// assert_eq!((exponent(-3.0), exponent(0.75), exponent(0.0)), (1, -1, -1022));
/// ```
#[must_use]
#[inline]
pub fn exponent(x: f64) -> i32 {
    // A sign, eleven bits of exponent, and the first four of the fraction.
    let [first, second, ..] = x.to_be_bytes();
    let biased = (u16::from_be_bytes([first, second]) >> 4) & 0x7ff;
    i32::from(biased.max(1)) - 1023
}

/// 2^exponent, exactly; zero or infinite where the range of doubles ends.
///
/// # Example
///
/// ```
/// use doubled::power_of_two;
///
/// assert_eq!((power_of_two(-3), power_of_two(-1074), power_of_two(1024)), (0.125, 5e-324, f64::INFINITY));
/// ```
#[must_use]
#[inline]
pub fn power_of_two(exponent: i32) -> f64 {
    match exponent {
        -1022..=1023 => f64::from_bits(u64::from((exponent + 1023).unsigned_abs()) << 52),
        1024.. => f64::INFINITY,
        -1074..=-1023 => f64::from_bits(1 << (exponent + 1074)),
        _ => 0.0,
    }
}

/// x 2^exponent for any exponent: infinite or zero only where the result itself is out of range.
///
/// # Example
///
/// ```
/// use doubled::times_power_of_two;
///
/// assert_eq!(times_power_of_two(5e-324, 2097), 2.0_f64.powi(1023));
/// ```
#[must_use]
#[inline]
pub fn times_power_of_two(x: f64, exponent: i32) -> f64 {
    const STEP: i32 = 1000;
    // From the smallest number to the largest it takes 2^2098.
    let mut left = exponent.clamp(-2200, 2200);
    let mut result = x;
    while left != 0 {
        let step = left.clamp(-STEP, STEP);
        result *= power_of_two(step);
        left -= step;
    }
    result
}

#[cfg(test)]
mod tests;
