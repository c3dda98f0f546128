//! Counts in words, numbers rounded to counts, and numbers without what rounding adds to them.

/// `1 field`, `2 fields`.
pub(crate) fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// A number rounded to a count, if it is one of a sensible size.
pub(crate) fn whole(value: f64) -> Option<usize> {
    const LARGEST: f64 = 1e9;
    let rounded = value.round();
    #[expect(clippy::cast_possible_truncation, reason = "a whole number between 0 and the largest")]
    (0.0..=LARGEST).contains(&rounded).then_some(rounded as usize)
}

/// The number with so many significant digits.
pub(crate) fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// The number with 12 significant digits, so that 3 periods of 0.1 s are 0.3 s, and stamps near 200 s are 0.1 s apart.
pub(crate) fn without_rounding(value: f64) -> f64 {
    rounded(value, 12)
}

/// The number with the fewest significant digits that is as close as this.
pub(crate) fn shortest_within(value: f64, distance: f64) -> f64 {
    const MOST_DIGITS: usize = 15;
    let all = (1..=MOST_DIGITS).map(|digits| rounded(value, digits));
    all.into_iter().find(|short| (short - value).abs() <= distance).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_counts() {
        assert_eq!(whole(2.6), Some(3));
        for value in [-1.0, 2e9, f64::NAN, f64::INFINITY] {
            assert_eq!(whole(value), None);
        }
    }

    #[test]
    fn what_rounding_adds_goes() {
        assert_eq!(without_rounding(3.0 * 0.1).to_bits(), 0.3_f64.to_bits());
        assert_eq!(rounded(1234.567, 3).to_bits(), 1230.0_f64.to_bits());
        assert!(without_rounding(f64::NAN).is_nan());
        assert_eq!(shortest_within(0.100_000_000_095, 1e-9).to_bits(), 0.1_f64.to_bits());
        assert_eq!(shortest_within(0.1001, 1e-9).to_bits(), 0.1001_f64.to_bits());
        assert_eq!(shortest_within(1.0 / 3.0, 0.0).to_bits(), (1.0_f64 / 3.0).to_bits());
    }
}
