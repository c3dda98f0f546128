//! In which unit a column of time without one probably is.

/// A period that a recorder is likely to have, in seconds.
const LIKELY_S: std::ops::RangeInclusive<f64> = 1e-4..=2.0;

/// Longer periods than this are doubted even where the stamps are no whole numbers.
const LONGEST_S: f64 = 1e4;

/// Units below the second, and above it.
const FINER: [(&str, f64); 3] = [("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];
const COARSER: [(&str, f64); 3] = [("min", 60.0), ("h", 3600.0), ("days", 86_400.0)];

/// Seconds since 1970 from 1998 to 2096.
const EPOCH_S: std::ops::Range<f64> = 9e8..4e9;

/// The unit of whole numbers that count from 1970, where they cannot be seconds.
pub(crate) fn epoch(first: f64, is_whole: bool) -> Option<(&'static str, f64)> {
    FINER.into_iter().find(|(_, factor)| is_whole && EPOCH_S.contains(&(first * factor)))
}

/// The factor to seconds of the days that spreadsheets count from 1900, as their cells of date and time are written: numbers with a fraction from 1954 to 2119, whose usual step would be a
/// period of 1/50000 s and less if they were seconds.
pub(crate) fn spreadsheet_days(
    first: f64,
    step: f64,
    is_whole: bool,
) -> Option<(&'static str, f64)> {
    const DAYS: std::ops::Range<f64> = 2e4..8e4;
    const LARGEST_STEP: f64 = 2e-5;
    let is_one = !is_whole && DAYS.contains(&first) && step > 0.0 && step < LARGEST_STEP;
    is_one.then_some(("days", 86_400.0))
}

/// What is odd about a period, and the unit that would mend it; `stated` is the factor to seconds
/// of the unit in the heading.
pub(crate) fn doubt(period_s: f64, is_whole: bool, stated: Option<f64>) -> Option<String> {
    let in_unit = |(unit, factor): &(&str, f64)| {
        let period_s = crate::numbers::rounded(period_s * factor, 6);
        LIKELY_S.contains(&period_s).then(|| format!("{period_s} s if it is in {unit}"))
    };
    if let Some(factor) = stated.filter(|factor| (factor - 1.0).abs() > 0.0) {
        let as_seconds = crate::numbers::rounded(period_s / factor, 6);
        let is_odd = !(1e-4..=LONGEST_S).contains(&period_s) && LIKELY_S.contains(&as_seconds);
        return is_odd.then(|| format!("{as_seconds} s if it is in s"));
    }
    if period_s > LONGEST_S || (stated.is_none() && is_whole && period_s > *LIKELY_S.end()) {
        return FINER.iter().find_map(in_unit);
    }
    if period_s < *LIKELY_S.start() {
        let fitting: Vec<String> = COARSER.iter().filter_map(in_unit).collect();
        return (!fitting.is_empty()).then(|| fitting.join(", "));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamps_from_1970_on_say_their_unit() {
        for (first, unit) in [(1.7e18, "ns"), (1.7e15, "us"), (1.7e12, "ms")] {
            assert_eq!(epoch(first, true).map(|(unit, _)| unit), Some(unit));
            assert_eq!(epoch(first, false), None);
        }
        assert_eq!(epoch(1.7e9, true), None);
        assert_eq!(epoch(0.0, true), None);
    }

    #[test]
    fn days_of_spreadsheets_are_told_from_seconds() {
        // Every 0.1 s on a day in 2025, and in seconds from some moment on.
        assert_eq!(spreadsheet_days(45_989.5, 0.1 / 86_400.0, false), Some(("days", 86_400.0)));
        assert_eq!(spreadsheet_days(45_989.5, 0.001, false), None);
        assert_eq!(spreadsheet_days(45_989.0, 1.0, true), None);
        assert_eq!(spreadsheet_days(0.5, 1e-6, false), None);
    }

    #[test]
    fn an_odd_period_names_the_unit_that_would_mend_it() {
        let check = |period_s, is_whole, stated, expected: Option<&str>| {
            assert_eq!(doubt(period_s, is_whole, stated).as_deref(), expected, "{period_s}");
        };
        check(20.0, true, None, Some("0.02 s if it is in ms"));
        check(10_000.0, true, None, Some("0.01 s if it is in us"));
        check(1e8, true, None, Some("0.1 s if it is in ns"));
        check(1e8, false, Some(1.0), Some("0.1 s if it is in ns"));
        check(5e-5, false, None, Some("0.003 s if it is in min, 0.18 s if it is in h"));
        check(5e-5, false, Some(1e-3), Some("0.05 s if it is in s"));
        for (period_s, is_whole) in [(0.02, false), (1.0, true), (2.0, true), (60.0, false)] {
            check(period_s, is_whole, None, None);
        }
        check(20.0, true, Some(1.0), None);
        check(0.001, true, Some(1e-3), None);
    }
}
