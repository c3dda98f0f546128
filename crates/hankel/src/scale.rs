//! Scaling by powers of two, exact as long as nothing underflows.

/// The exponent e with 2^e <= magnitude < 2^(e+1); subnormal numbers count as the smallest normal one.
pub(crate) fn exponent(magnitude: f64) -> i32 {
    let biased = (magnitude.to_bits() >> 52) & 0x7ff;
    i32::try_from(biased).expect("eleven bits").max(1) - 1023
}

/// Two to a power; zero or infinite where a double ends.
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    match exponent {
        -1022..=1023 => f64::from_bits(u64::from((exponent + 1023).unsigned_abs()) << 52),
        1024.. => f64::INFINITY,
        -1074..=-1023 => f64::from_bits(1 << (exponent + 1074)),
        _ => 0.0,
    }
}

/// `value * 2^exponent` without intermediate overflow.
pub(crate) fn scaled(value: f64, exponent: i32) -> f64 {
    // Enough to bring any double to the other end of the range and beyond.
    let mut left = exponent.clamp(-4400, 4400);
    let mut result = value;
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        result *= power_of_two(step);
        left -= step;
    }
    result
}

#[cfg(test)]
mod tests;
