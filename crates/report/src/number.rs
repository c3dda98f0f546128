//! Numbers as text: significant digits, complex numbers, conjugate pairs.

/// A number with so many significant digits, rounded to nearest, trailing zeros kept.
///
/// Fixed notation from 1e-4 up to below 1e6 (or as far as the digits reach, if that is more), scientific
/// notation (`1.25e-7`) outside. Zero is `0`; not-a-number is `nan`, infinities are `inf` and `-inf`.
/// `digits` is clamped to 1..=17.
///
/// # Example
///
/// ```
/// use report::format_significant;
///
/// assert_eq!(format_significant(-0.5455628, 4), "-0.5456");
/// assert_eq!(format_significant(0.99984365, 4), "0.9998");
/// assert_eq!(format_significant(0.99999, 4), "1.000");
/// assert_eq!(format_significant(1234.5, 2), "1200");
/// assert_eq!(format_significant(3.217e-13, 2), "3.2e-13");
/// ```
pub fn format_significant(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "nan".into();
    }
    if value.is_infinite() {
        return if value > 0.0 { "inf" } else { "-inf" }.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.clamp(1, 17);
    let scientific = format!("{value:.*e}", digits - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    match exponent.parse::<isize>() {
        Ok(exponent @ -4..0) => format!("{value:.*}", digits - 1 + exponent.unsigned_abs()),
        Ok(exponent @ 0..) if exponent.unsigned_abs() < digits.max(6) => {
            let places = exponent.unsigned_abs();
            if places < digits {
                format!("{value:.*}", digits - 1 - places)
            } else {
                // Fewer digits than places before the point: fill with zeros.
                mantissa.replace('.', "") + &"0".repeat(places + 1 - digits)
            }
        }
        _ => scientific,
    }
}

/// A complex number in the engineers' notation `a + jb`, both parts with so many significant digits.
///
/// A number whose imaginary part is exactly zero is written as a real one.
///
/// # Example
///
/// ```
/// use report::format_complex;
///
/// assert_eq!(format_complex(-0.070594, 1.691678, 3), "-0.0706 + j1.69");
/// assert_eq!(format_complex(0.5, -2.0, 2), "0.50 - j2.0");
/// assert_eq!(format_complex(-0.5456, 0.0, 2), "-0.55");
/// ```
pub fn format_complex(re: f64, im: f64, digits: usize) -> String {
    join(re, im, if im < 0.0 { '-' } else { '+' }, digits)
}

/// A conjugate pair as `a ± jb`, both parts with so many significant digits; the sign of `im` does not matter.
///
/// A pair whose imaginary part is exactly zero is written as one real number.
///
/// # Example
///
/// ```
/// use report::format_conjugate_pair;
///
/// assert_eq!(format_conjugate_pair(-0.0705941, -1.6916784, 5), "-0.070594 ± j1.6917");
/// ```
pub fn format_conjugate_pair(re: f64, im: f64, digits: usize) -> String {
    join(re, im, '±', digits)
}

fn join(re: f64, im: f64, sign: char, digits: usize) -> String {
    let real = format_significant(re, digits);
    if im == 0.0 {
        real
    } else {
        format!("{real} {sign} j{}", format_significant(im.abs(), digits))
    }
}

#[cfg(test)]
mod tests;
